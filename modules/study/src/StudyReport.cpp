// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyReport.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "OutcomeValue.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::study {

namespace {

using figures::fixed;
namespace ink = figures::ink;

constexpr std::array outcomes = {Outcome::angle, Outcome::coverage, Outcome::peakForce,
                                 Outcome::partitionForce};
/// Interactions listed for each quantity.
constexpr std::size_t maxInteractions = 3;
/// Points of a series in a figure; more would cover each other.
constexpr std::size_t maxPoints = 400;

/// Decimals of a quantity in tables.
int decimalsOf(Outcome outcome) { return outcome == Outcome::partitionForce ? 2 : 1; }

std::string interval(const Estimate& estimate, int decimals)
{
  return fixed(estimate.value, decimals) + " (" + fixed(estimate.low, decimals) + " to " +
         fixed(estimate.high, decimals) + ")";
}

/// The finished insertions' median and quartiles: "412 (401 to 425)"; a dash without any.
std::string quartiles(const std::vector<const StudyResult*>& results, Outcome outcome)
{
  std::vector<double> values;
  for (const StudyResult* each : results)
    if (each->insertion.end == analysis::InsertionEnd::finished)
      values.push_back(valueOf(*each, outcome));
  if (values.empty()) return "-";
  return interval({quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)},
                  decimalsOf(outcome));
}

std::string rowOf(const std::string& name, const std::vector<const StudyResult*>& results)
{
  const auto finished = static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const StudyResult* each) {
        return each->insertion.end == analysis::InsertionEnd::finished;
      }));
  const Estimate rate = analysis::proportionOf(finished, results.size());
  std::string row = "| " + name + " | " + std::to_string(results.size()) + " | " +
                    (analysis::countedOf(rate, results.size())
                         ? analysis::shareText(rate, results.size())
                         : interval({100.0 * rate.value, 100.0 * rate.low, 100.0 * rate.high}, 1));
  for (const Outcome outcome : outcomes) row += " | " + quartiles(results, outcome);
  return row + " |\n";
}

std::string tableHead(const std::string& what)
{
  std::string head = "| " + what + " | insertions | full insertions, % (95 % interval)";
  std::string line = "|---|---|---";
  for (const Outcome outcome : outcomes) {
    head += " | " + titleOf(outcome);
    line += "|---";
  }
  return head + " |\n" + line + "|\n";
}

/// A table of every level of every factor, then of thirds by the size of the cochlea.
std::string distributions(const StudyEvaluation& study)
{
  std::string text = "## Distributions\n\nMedian (quartiles) of the insertions that finished.\n\n" +
                     tableHead("insertions with");
  std::vector<const StudyResult*> all;
  for (const StudyResult& each : study.results()) all.push_back(&each);
  text += rowOf("all", all);
  for (const auto& [key, levels] : study.factors())
    for (const std::string& level : levels) {
      std::vector<const StudyResult*> own;
      for (const StudyResult* each : all)
        if (StudyEvaluation::settingOf(*each, key) == level) own.push_back(each);
      text += rowOf(key + " = " + level, own);
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const StudyResult* a, const StudyResult* b) { return a->a_mm < b->a_mm; });
  if (all.size() < 3 || all.front()->a_mm == all.back()->a_mm) return text + "\n";
  for (std::size_t third = 0; third < 3; ++third) {
    const std::vector<const StudyResult*> own(
        all.begin() + static_cast<std::ptrdiff_t>(all.size() * third / 3),
        all.begin() + static_cast<std::ptrdiff_t>(all.size() * (third + 1) / 3));
    text += rowOf("A " + fixed(own.front()->a_mm, 2) + " to " + fixed(own.back()->a_mm, 2) + " mm",
                  own);
  }
  return text + "\n";
}

using Endings = std::map<std::string, std::size_t>;

/// How many insertions ended in which way.
Endings endingsOf(const StudyEvaluation& study)
{
  Endings counts;
  for (const StudyResult& each : study.results()) ++counts[haptics::nameOf(each.insertion.end)];
  return counts;
}

std::string textOf(const Endings& endings)
{
  std::string text;
  for (const auto& [name, count] : endings)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string effectsOf(const StudyEvaluation& study, Outcome outcome)
{
  const int decimals = decimalsOf(outcome) + 1;
  std::string text = "### " + titleOf(outcome) + "\n\n";
  const std::vector<Effect> effects = study.mainEffects(outcome);
  const std::vector<Slope> slopes = study.slopes(outcome);
  if (effects.empty() && slopes.empty())
    return text + "Too few cochleae in which every insertion finished.\n\n";
  text += "| change | effect (95 % interval) |\n|---|---|\n";
  for (const Effect& each : effects)
    text += "| " + each.name + " | " + interval(each.size, decimals) + " |\n";
  std::vector<Effect> together = study.interactions(outcome);
  together.resize(std::min(together.size(), maxInteractions));
  for (const Effect& each : together)
    text += "| together, beyond their sum: " + each.name + " | " + interval(each.size, decimals) +
            " |\n";
  for (const Slope& each : slopes)
    text += "| per unit of " + each.name + " | " + interval(each.perUnit, decimals) + " |\n";
  return text + "\n";
}

/// The quantity over the diameter A of the basal turn, a series for each level of a factor.
figures::Figure overSize(const StudyEvaluation& study, Outcome outcome, const std::string& title)
{
  constexpr std::array inks = {ink::blue, ink::vermilion, ink::green, ink::purple};
  constexpr std::array shapes = {figures::MarkerShape::disk, figures::MarkerShape::square,
                                 figures::MarkerShape::diamond, figures::MarkerShape::ring};
  figures::Figure figure;
  figure.title = title;
  // The factor with the largest difference between its levels: what a reader looks for first.
  std::string factor;
  double largest = -1.0;
  for (const Effect& each : study.mainEffects(outcome))
    if (std::fabs(each.size.value) > largest) {
      largest = std::fabs(each.size.value);
      factor = each.name.substr(0, each.name.find(" = "));
    }
  if (factor.empty() && !study.factors().empty())
    factor = study.factors().count("array") != 0 ? "array" : study.factors().begin()->first;
  std::vector<std::string> levels = {""};
  if (!factor.empty()) levels = study.factors().at(factor);
  if (levels.size() > inks.size()) {
    figure.notes.push_back("The first " + std::to_string(inks.size()) + " of " +
                           std::to_string(levels.size()) + " values of " + factor + ".");
    levels.resize(inks.size());
  }
  double low = INFINITY, high = -INFINITY, top = 0.0;
  bool isShortened = false;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    figures::FigureValues series;
    series.label = factor.empty() ? "" : factor + " = " + levels[i];
    series.ink = inks[i];
    series.shape = shapes[i];
    for (const StudyResult& each : study.results()) {
      if (each.insertion.end != analysis::InsertionEnd::finished) continue;
      if (!factor.empty() && StudyEvaluation::settingOf(each, factor) != levels[i]) continue;
      if (series.x.size() == maxPoints) {
        isShortened = true;
        break;
      }
      const double value = valueOf(each, outcome);
      series.x.push_back(each.a_mm);
      for (auto* list : {&series.y, &series.low, &series.high}) list->push_back(value);
      low = std::min(low, each.a_mm);
      high = std::max(high, each.a_mm);
      top = std::max(top, value);
    }
    if (series.x.empty()) series.label = series.label + " (none finished)";
    figure.values.push_back(std::move(series));
  }
  if (!(low <= high)) low = 8.0, high = 10.0;
  figure.x = {"diameter A of the basal turn, mm", std::floor(2.0 * low) / 2.0,
              std::ceil(2.0 * high + 0.01) / 2.0, 0.5, 1};
  figure.y = figures::axisOver(titleOf(outcome), 0.0, top);
  if (isShortened)
    figure.notes.push_back("The first " + std::to_string(maxPoints) + " insertions of each.");
  Endings notDrawn = endingsOf(study);
  notDrawn.erase(haptics::nameOf(analysis::InsertionEnd::finished));
  if (!notDrawn.empty())
    figure.notes.push_back("Insertions that did not finish are not drawn: " + textOf(notDrawn) +
                           ".");
  return figure;
}

}  // namespace

std::string titleOf(Outcome outcome)
{
  switch (outcome) {
    case Outcome::angle:
      return "angular insertion depth, deg";
    case Outcome::coverage:
      return "cochlear coverage, %";
    case Outcome::peakForce:
      return "peak insertion force, mN";
    case Outcome::partitionForce:
      break;
  }
  return "peak force on the cochlear partition, mN";
}

Result<StudyReport> reportOf(const StudyFile& file)
{
  std::vector<StudyResult> results;
  const auto done = file.read([&results](StudyResult result) -> Result<Done> {
    result.insertion.profile.clear();  // not in the report
    result.insertion.contacts.clear();
    results.push_back(std::move(result));
    return Done{};
  });
  if (!done) return done.error();
  if (results.empty()) return Error{"The study has no insertion. Run and merge it first."};
  const StudyEvaluation study(std::move(results));

  const std::string number = file.facts().fingerprint.substr(0, 16);
  std::string notes;
  if (const std::string note = noteOn(file.facts().seal); !note.empty()) notes += note + "\n\n";
  for (const std::string& note : file.facts().notes) notes += note + "\n\n";
  StudyReport report;
  report.text =
      "# " + file.facts().title + "\n\n" + std::to_string(study.results().size()) +
      " insertions: " + textOf(endingsOf(study)) + ". Perilymph " + file.facts().program +
      (number.empty() ? std::string() : ", study " + number) + ".\n\n" + notes +
      "For research and training; not a medical device. Depths, forces and rates are those "
      "of the model; an insertion\nthat did not finish counts in the rate of full "
      "insertions and in nothing else.\n\n" +
      distributions(study) +
      "## Effects\n\nDifferences from the mean of a cochlea, in cochleae in which every "
      "insertion finished; slopes within\nequal settings, by least squares.\n\n";
  for (const Outcome outcome : outcomes) report.text += effectsOf(study, outcome);
  report.figures = {
      {"angle", overSize(study, Outcome::angle, file.facts().title + ": insertion angle")},
      {"peak-force", overSize(study, Outcome::peakForce, file.facts().title + ": peak force")}};
  return report;
}

}  // namespace perilymph::study

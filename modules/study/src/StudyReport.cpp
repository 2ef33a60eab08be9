// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "perilymph/figures/Strings.h"

namespace perilymph::study {

namespace {

using figures::fixed;
namespace ink = figures::ink;

/// Interactions listed for each quantity.
constexpr std::size_t maxInteractions = 3;
/// Points of a series in a figure; more would cover each other.
constexpr std::size_t maxPoints = 400;

std::string interval(const Estimate& estimate, int decimals)
{
  return fixed(estimate.value, decimals) + " (" + fixed(estimate.low, decimals) + " to " +
         fixed(estimate.high, decimals) + ")";
}

/// "97.5 (91.3 to 99.3)"; of few insertions "4 of 5 (38 to 96)".
std::string rateText(const StudyGroup& group)
{
  const Estimate percent{100.0 * group.rate.value, 100.0 * group.rate.low, 100.0 * group.rate.high};
  const auto count = analysis::countedOf(group.rate, group.rows.size());
  if (!count) return interval(percent, 1);
  return std::to_string(*count) + " of " + std::to_string(group.rows.size()) + " (" +
         fixed(percent.low, 0) + " to " + fixed(percent.high, 0) + ")";
}

/// "412 (401 to 425); 413": median, quartiles and mean; a dash without any.
std::string sampleText(const StudySample& sample, std::size_t quantity)
{
  const auto& quartiles = sample.quartiles[quantity];
  const int decimals = summarizedQuantities[quantity].decimals;
  return quartiles
             ? interval(*quartiles, decimals) + "; " + fixed(sample.means[quantity]->mean, decimals)
             : "-";
}

/// The first rows of a table: its columns and a line.
std::string tableHead(const std::vector<std::string>& columns)
{
  std::string head = "|", line = "|";
  for (const std::string& column : columns) {
    head += " " + column + " |";
    line += "---|";
  }
  return head + "\n" + line + "\n";
}

/// A table's columns, followed by those of the quantities.
std::string tableOfQuantities(std::vector<std::string> columns)
{
  for (const SummarizedQuantity& each : summarizedQuantities) columns.emplace_back(each.title);
  return tableHead(columns);
}

/// The study as the page Studies and the tables of `--group` summarize it, of one factor or of all.
StudySummary summaryBy(const StudyColumns& columns, const std::string& factor)
{
  return summaryOf(columns, columns.rows({}), {"A_mm", "angle_deg", factor});
}

/// The value of a group's setting, as it is shown.
std::string shownLevel(const StudyColumns& columns, const StudySummary& summary,
                       const StudyGroup& group)
{
  const StudyFactor* factor = columns.factor(summary.axes.group);
  return factor == nullptr ? group.level : factor->shownOf(group.level);
}

/// Groups of the report, with their names.
using NamedGroups = std::vector<std::pair<std::string, StudyGroup>>;

/// All insertions, those of each value of each factor, and thirds by the size of the cochlea.
NamedGroups groupsOf(const StudyColumns& columns, const std::vector<StudySummary>& byFactor)
{
  NamedGroups groups;
  for (const StudyGroup& group : summaryBy(columns, "").groups) groups.emplace_back("all", group);
  for (const StudySummary& summary : byFactor)
    for (const StudyGroup& group : summary.groups)
      groups.emplace_back(summary.axes.group + " = " + shownLevel(columns, summary, group), group);
  std::vector<std::uint32_t> rows = columns.rows({});
  const auto size = [&columns](std::uint32_t row) { return columns.result(row).a_mm; };
  std::ranges::stable_sort(rows, {}, size);
  if (rows.size() < 3 || size(rows.front()) == size(rows.back())) return groups;
  for (std::size_t third = 0; third < 3; ++third) {
    const std::vector<std::uint32_t> own(
        rows.begin() + static_cast<std::ptrdiff_t>(rows.size() * third / 3),
        rows.begin() + static_cast<std::ptrdiff_t>(rows.size() * (third + 1) / 3));
    for (const StudyGroup& group : summaryOf(columns, own, {"A_mm", "angle_deg", ""}).groups)
      groups.emplace_back(
          "A " + fixed(size(own.front()), 2) + " to " + fixed(size(own.back()), 2) + " mm", group);
  }
  return groups;
}

std::string endingsTable(const NamedGroups& groups)
{
  std::string text =
      "## Complete and stopped insertions\n\nWilson's interval, in which insertions that share a "
      "cochlea count as independent: with few cochleae it is too narrow.\n\n" +
      tableHead({"insertions with", "n", "complete, % (95 % interval)", "stopped", "not prepared"});
  for (const auto& [name, group] : groups)
    text += "| " + name + " | " + std::to_string(group.rows.size()) + " | " + rateText(group) +
            " | " + std::to_string(group.stopped()) + " | " + std::to_string(group.notPrepared()) +
            " |\n";
  return text + "\n";
}

std::string distributionTables(const NamedGroups& groups)
{
  std::string text = "## Distributions: median (quartiles); mean\n\n";
  for (const StudySelection selection : studySelections) {
    text += std::string("### Of ") + nameOf(selection) + "\n\n" +
            tableOfQuantities({"insertions with", "n"});
    for (const auto& [name, group] : groups) {
      const StudySample& sample = group.samples[selection];
      text += "| " + name + " | " + std::to_string(sample.count) + " |";
      for (std::size_t i = 0; i < summarizedQuantities.size(); ++i)
        text += " " + sampleText(sample, i) + " |";
      text += "\n";
    }
    text += "\n";
  }
  return text;
}

std::string differenceTables(const StudyColumns& columns, const std::vector<StudySummary>& byFactor)
{
  std::string text =
      "## Differences of means (95 % interval)\n\nOf pairs that share the cochlea and every other "
      "setting, over cochleae, with Student's interval; without pairs Welch's.\n\n";
  for (const StudySelection selection : studySelections) {
    text += std::string("### Of ") + nameOf(selection) + "\n\n" +
            tableOfQuantities({"difference", "of"});
    for (const StudySummary& summary : byFactor)
      for (const StudyDifference& each : summary.differences) {
        if (each.selection != selection) continue;
        text += "| " + summary.axes.group + ": " +
                shownLevel(columns, summary, summary.groups[each.group]) + " - " +
                shownLevel(columns, summary, summary.groups[each.other]) + " | " +
                std::to_string(each.count) +
                (each.isPaired ? " pairs, " + std::to_string(each.cochleae) + " cochleae"
                               : " and " + std::to_string(each.otherCount)) +
                " |";
        for (std::size_t i = 0; i < each.means.size(); ++i)
          text += " " +
                  (each.means[i] ? interval(*each.means[i], summarizedQuantities[i].decimals)
                                 : std::string("-")) +
                  " |";
        text += "\n";
      }
    text += "\n";
  }
  return text;
}

std::string trendTable(const NamedGroups& groups)
{
  std::string text =
      "## Angular insertion depth over A: slope, deg/mm (95 % interval)\n\nOne line through all "
      "insertions of a row, whatever their settings: the interval holds the differences of the "
      "settings, which\nthat of the slopes under Effects does not. Insertions that share a cochlea "
      "count as independent.\n\n" +
      tableHead({"insertions with", nameOf(StudySelection::ran), nameOf(StudySelection::complete)});
  for (const auto& [name, group] : groups) {
    text += "| " + name + " |";
    for (const StudySelection selection : studySelections) {
      const auto& trend = group.samples[selection].trend;
      text += " " + (trend ? interval(trend->slope(), 1) : std::string("-")) + " |";
    }
    text += "\n";
  }
  return text + "\n";
}

using Endings = std::map<std::string, std::size_t>;

/// How many insertions ended in which way.
Endings endingsOf(const StudyColumns& columns)
{
  Endings counts;
  for (std::size_t row = 0; row < columns.size(); ++row)
    ++counts[haptics::nameOf(columns.result(row).insertion.end)];
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

std::string effectsOf(const StudyEvaluation& study, const SummarizedQuantity& quantity,
                      StudySelection selection)
{
  const int decimals = quantity.decimals + 1;
  std::string text = "### " + std::string(quantity.title) + ", of " + nameOf(selection) + "\n\n";
  const std::vector<Effect> effects = study.mainEffects(quantity.key, selection);
  const std::vector<Slope> slopes = study.slopes(quantity.key, selection);
  if (effects.empty() && slopes.empty())
    return text + "Too few cochleae of which every insertion is in this selection.\n\n";
  text += tableHead({"change", "effect (95 % interval)"});
  for (const Effect& each : effects)
    text += "| " + each.name + " | " + interval(each.size, decimals) + " |\n";
  std::vector<Effect> together = study.interactions(quantity.key, selection);
  together.resize(std::min(together.size(), maxInteractions));
  for (const Effect& each : together)
    text += "| together, beyond their sum: " + each.name + " | " + interval(each.size, decimals) +
            " |\n";
  for (const Slope& each : slopes)
    text += "| per unit of " + each.name + " | " + interval(each.perUnit, decimals) + " |\n";
  return text + "\n";
}

/// The factor with the largest difference between its levels: what a reader looks for first.
const StudyFactor* mainFactor(const StudyColumns& columns, const StudyEvaluation& study,
                              const std::string& quantity)
{
  std::string name;
  double largest = -1.0;
  for (const Effect& each : study.mainEffects(quantity, StudySelection::ran))
    if (std::fabs(each.size.value) > largest) {
      largest = std::fabs(each.size.value);
      name = each.name.substr(0, each.name.find(" = "));
    }
  if (!name.empty()) return columns.factor(name);
  if (const StudyFactor* array = columns.factor("array")) return array;
  return study.factors().empty() ? nullptr : study.factors().front();
}

/// The quantity over the diameter A of the basal turn, two series for each level of a factor: the
/// complete insertions, and as rings the stopped ones.
figures::Figure overSize(const StudyColumns& columns, const StudyEvaluation& study,
                         const SummarizedQuantity& quantity, const std::string& title)
{
  constexpr std::array inks = {ink::blue, ink::vermilion, ink::green, ink::purple};
  constexpr std::array shapes = {figures::MarkerShape::disk, figures::MarkerShape::square,
                                 figures::MarkerShape::diamond, figures::MarkerShape::disk};
  figures::Figure figure;
  figure.title = title;
  const StudyFactor* factor = mainFactor(columns, study, quantity.key);
  const auto& values = columns.quantity(quantity.key)->values;
  std::vector<std::string> levels = {""};
  if (factor != nullptr) levels = factor->levels;
  if (levels.size() > inks.size()) {
    figure.notes.push_back("The first " + std::to_string(inks.size()) + " of " +
                           std::to_string(levels.size()) + " values of " + factor->key + ".");
    levels.resize(inks.size());
  }
  double low = INFINITY, high = -INFINITY, top = 0.0;
  bool isShortened = false;
  for (std::size_t i = 0; i < levels.size(); ++i)
    for (const bool isComplete : {true, false}) {
      figures::FigureValues series;
      series.label = (factor == nullptr ? std::string() : factor->key + " = " + factor->shown[i]) +
                     (isComplete          ? ""
                      : factor == nullptr ? "stopped"
                                          : ", stopped");
      series.ink = inks[i];
      series.shape = isComplete ? shapes[i] : figures::MarkerShape::ring;
      for (std::uint32_t row = 0; row < columns.size(); ++row) {
        const StudyResult& each = columns.result(row);
        if (!isIn(StudySelection::ran, each) ||
            isIn(StudySelection::complete, each) != isComplete ||
            (factor != nullptr && factor->level[row] != i))
          continue;
        if (series.x.size() == maxPoints) {
          isShortened = true;
          break;
        }
        series.x.push_back(each.a_mm);
        for (auto* list : {&series.y, &series.low, &series.high}) list->push_back(values[row]);
        low = std::min(low, each.a_mm);
        high = std::max(high, each.a_mm);
        top = std::max(top, values[row]);
      }
      if (series.x.empty() && !isComplete) continue;
      if (series.x.empty()) series.label = series.label + " (none complete)";
      figure.values.push_back(std::move(series));
    }
  if (!(low <= high)) low = 8.0, high = 10.0;
  figure.x = {"diameter A of the basal turn, mm", std::floor(2.0 * low) / 2.0,
              std::ceil(2.0 * high + 0.01) / 2.0, 0.5, 1};
  figure.y = figures::axisOver(std::string(quantity.title), 0.0, top);
  if (isShortened)
    figure.notes.push_back("The first " + std::to_string(maxPoints) + " insertions of each.");
  return figure;
}

const SummarizedQuantity& quantityOf(const char* key)
{
  return *std::ranges::find(summarizedQuantities, std::string(key),
                            [](const SummarizedQuantity& each) { return std::string(each.key); });
}

}  // namespace

StudyReport reportOf(const StudyColumns& columns)
{
  const StudyEvaluation study(columns);
  const StudyFileFacts& facts = columns.facts();
  std::vector<StudySummary> byFactor;
  for (const StudyFactor* factor : study.factors())
    byFactor.push_back(summaryBy(columns, factor->key));
  const NamedGroups groups = groupsOf(columns, byFactor);
  const std::string number = facts.fingerprint.substr(0, 16);
  std::string notes;
  if (const std::string note = noteOn(facts.seal); !note.empty()) notes += note + "\n\n";
  for (const std::string& note : facts.notes) notes += note + "\n\n";
  StudyReport report;
  report.text =
      "# " + facts.title + "\n\n" + std::to_string(columns.size()) +
      " insertions: " + textOf(endingsOf(columns)) + ". Perilymph " + facts.program +
      (number.empty() ? std::string() : ", study " + number) + ".\n\n" + notes +
      "For research and training; not a medical device. Depths, forces and rates are those "
      "of the model.\n\n"
      "Two selections are reported. *All that ran*: every insertion that was prepared, a stopped "
      "one with what it reached.\n*Complete*: those that reached their full depth; without the "
      "stopped ones they look deeper and gentler\nthan the array is. Every insertion counts in "
      "the rate of complete ones.\n\n" +
      endingsTable(groups) + distributionTables(groups);
  if (!byFactor.empty()) report.text += differenceTables(columns, byFactor);
  report.text += trendTable(groups) +
                 "## Effects\n\nDifferences from the mean of a cochlea, in cochleae of which every "
                 "insertion is in the selection; slopes within\nequal settings, by least squares: "
                 "differences of the settings are not in their intervals; insertions that share a "
                 "cochlea count\nas independent. Student's intervals.\n\n";
  for (const SummarizedQuantity& quantity : summarizedQuantities)
    for (const StudySelection selection : studySelections)
      report.text += effectsOf(study, quantity, selection);
  report.figures = {{"angle", overSize(columns, study, quantityOf("angle_deg"),
                                       facts.title + ": insertion angle")},
                    {"peak-force", overSize(columns, study, quantityOf("peak_mN"),
                                            facts.title + ": peak force")}};
  return report;
}

}  // namespace perilymph::study

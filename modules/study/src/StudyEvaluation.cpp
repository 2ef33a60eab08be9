// SPDX-License-Identifier: BSD-3-Clause

// Effects of factors, and slopes, from the results of a study.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "OutcomeValue.h"
#include "perilymph/study/StudyReport.h"

namespace perilymph::study {

namespace {

/// A setting with more values than this was drawn from a range (choice, high: lists of people are
/// shorter).
constexpr std::size_t maxLevels = 12;
constexpr std::size_t fewestCochleae = 3;

double meanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Estimate estimateOf(const std::vector<double>& values)
{
  const analysis::SampleStatistics statistics = analysis::statisticsOf(values);
  return {statistics.mean, statistics.low95(), statistics.high95()};
}

/// Mean outcome of the insertions that a condition selects.
template <class Condition>
double meanWhere(const std::vector<const StudyResult*>& cochlea, Outcome outcome,
                 const Condition& condition)
{
  std::vector<double> values;
  for (const StudyResult* each : cochlea)
    if (condition(*each)) values.push_back(valueOf(*each, outcome));
  return values.empty() ? 0.0 : meanOf(values);
}

double numberIn(const std::string& text)
{
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

double valueOf(const StudyResult& result, Outcome outcome)
{
  switch (outcome) {
    case Outcome::angle:
      return inDegrees(result.insertion.apical);
    case Outcome::coverage:
      return 100.0 * result.insertion.coverage;
    case Outcome::peakForce:
      return inMillinewtons(result.insertion.peak.force);
    case Outcome::partitionForce:
      break;
  }
  return inMillinewtons(result.insertion.partition);
}

StudyEvaluation::StudyEvaluation(std::vector<StudyResult> results) : results_(std::move(results))
{
  std::map<std::string, std::set<std::string>> values;
  for (const StudyResult& each : results_)
    for (const auto& [key, value] : each.settings) values[key].insert(value);
  for (const auto& [key, found] : values) {
    if (found.size() > maxLevels) ranges_.push_back(key);
    if (found.size() > 1 && found.size() <= maxLevels) factors_[key] = {found.begin(), found.end()};
  }
}

std::string StudyEvaluation::settingOf(const StudyResult& result, const std::string& key)
{
  for (const auto& [name, value] : result.settings)
    if (name == key) return value;
  return {};
}

std::string StudyEvaluation::combinationOf(const StudyResult& result) const
{
  std::string text;
  for (const auto& [key, levels] : factors_) text += settingOf(result, key) + '\n';
  return text;
}

/// The results by cochlea, of those in which every insertion finished.
std::vector<std::vector<const StudyResult*>> StudyEvaluation::wholeCochleae() const
{
  std::map<std::string, std::vector<const StudyResult*>> byCochlea;
  for (const StudyResult& each : results_) byCochlea[each.cochlea].push_back(&each);
  std::vector<std::vector<const StudyResult*>> whole;
  for (auto& [name, all] : byCochlea)
    if (std::all_of(all.begin(), all.end(), [](const StudyResult* each) {
          return each->insertion.end == analysis::InsertionEnd::finished;
        }))
      whole.push_back(std::move(all));
  return whole;
}

std::vector<Effect> StudyEvaluation::mainEffects(Outcome outcome) const
{
  const auto cochleae = wholeCochleae();
  std::vector<Effect> effects;
  if (cochleae.size() < fewestCochleae) return effects;
  for (const auto& [key, levels] : factors_)
    for (const std::string& level : levels) {
      std::vector<double> differences;
      for (const auto& cochlea : cochleae)
        differences.push_back(meanWhere(cochlea, outcome,
                                        [&, &factor = key](const StudyResult& each) {
                                          return settingOf(each, factor) == level;
                                        }) -
                              meanWhere(cochlea, outcome, [](const StudyResult&) { return true; }));
      effects.push_back({key + " = " + level, estimateOf(differences)});
    }
  return effects;
}

std::vector<Effect> StudyEvaluation::interactions(Outcome outcome) const
{
  const auto cochleae = wholeCochleae();
  std::vector<Effect> effects;
  if (cochleae.size() < fewestCochleae) return effects;
  for (auto one = factors_.begin(); one != factors_.end(); ++one)
    for (auto other = std::next(one); other != factors_.end(); ++other)
      for (const std::string& a : one->second)
        for (const std::string& b : other->second) {
          const auto isA = [&](const StudyResult& each) {
            return settingOf(each, one->first) == a;
          };
          const auto isB = [&](const StudyResult& each) {
            return settingOf(each, other->first) == b;
          };
          std::vector<double> excess;
          for (const auto& cochlea : cochleae)
            excess.push_back(
                meanWhere(cochlea, outcome,
                          [&](const StudyResult& each) { return isA(each) && isB(each); }) -
                meanWhere(cochlea, outcome, isA) - meanWhere(cochlea, outcome, isB) +
                meanWhere(cochlea, outcome, [](const StudyResult&) { return true; }));
          effects.push_back(
              {one->first + " = " + a + ", " + other->first + " = " + b, estimateOf(excess)});
        }
  std::stable_sort(effects.begin(), effects.end(), [](const Effect& a, const Effect& b) {
    return std::fabs(a.size.value) > std::fabs(b.size.value);
  });
  return effects;
}

std::vector<Slope> StudyEvaluation::slopes(Outcome outcome) const
{
  std::vector<std::string> names = {"A_mm"};
  names.insert(names.end(), ranges_.begin(), ranges_.end());
  std::vector<Slope> slopes;
  for (const std::string& name : names) {
    // Both variables less the mean of their combination.
    std::map<std::string, std::vector<std::pair<double, double>>> points;
    for (const StudyResult& each : results_)
      if (each.insertion.end == analysis::InsertionEnd::finished)
        points[combinationOf(each)].emplace_back(
            name == "A_mm" ? each.a_mm : numberIn(settingOf(each, name)), valueOf(each, outcome));
    double xx = 0.0, xy = 0.0, yy = 0.0;
    double freedom = -1.0;
    for (const auto& [combination, own] : points) {
      double x = 0.0, y = 0.0;
      for (const auto& [a, b] : own) x += a, y += b;
      x /= static_cast<double>(own.size());
      y /= static_cast<double>(own.size());
      for (const auto& [a, b] : own) {
        xx += (a - x) * (a - x);
        xy += (a - x) * (b - y);
        yy += (b - y) * (b - y);
      }
      freedom += static_cast<double>(own.size()) - 1.0;
    }
    if (!(xx > 0.0) || freedom < 1.0) continue;
    const double slope = xy / xx;
    const double error = std::sqrt(std::max(yy - slope * xy, 0.0) / freedom / xx);
    const double half = halfWidth95 * error;
    slopes.push_back({name, {slope, slope - half, slope + half}});
  }
  return slopes;
}

}  // namespace perilymph::study

// SPDX-License-Identifier: BSD-3-Clause

// Effects of factors, and slopes, from the results of a study.

#include <algorithm>
#include <cmath>
#include <map>

#include "perilymph/study/StudyReport.h"

namespace perilymph::study {

namespace {

constexpr std::size_t fewestCochleae = 3;
constexpr const char* ending = "ending";

/// A level of a factor, as an index into its list.
struct Level {
  const StudyFactor* factor;
  std::size_t index;

  bool isOf(std::uint32_t row) const { return factor->level[row] == index; }
  std::string name() const { return factor->key + " = " + factor->shown[index]; }
};

/// Mean of the values in the rows that a condition selects; 0 without any.
template <class Condition>
double meanWhere(const std::vector<std::uint32_t>& rows, const std::vector<double>& values,
                 const Condition& condition)
{
  double sum = 0.0, count = 0.0;
  for (const std::uint32_t row : rows)
    if (condition(row)) sum += values[row], count += 1.0;
  return count > 0.0 ? sum / count : 0.0;
}

constexpr auto everyRow = [](std::uint32_t) { return true; };

std::vector<Level> levelsOf(const StudyFactor& factor)
{
  std::vector<Level> levels;
  for (std::size_t i = 0; i < factor.levels.size(); ++i) levels.push_back({&factor, i});
  return levels;
}

}  // namespace

StudyEvaluation::StudyEvaluation(const StudyColumns& columns)
    : columns_(&columns), ranges_(columns.ranges())
{
  for (const StudyFactor& factor : columns.factors())
    if (factor.key != ending) factors_.push_back(&factor);
}

/// The rows by cochlea, of those of which every insertion is selected.
std::vector<StudyEvaluation::Rows> StudyEvaluation::wholeCochleae(StudySelection selection) const
{
  std::map<std::string, Rows> byCochlea;
  for (std::uint32_t row = 0; row < columns_->size(); ++row)
    byCochlea[columns_->result(row).cochlea].push_back(row);
  std::vector<Rows> whole;
  for (auto& [name, rows] : byCochlea)
    if (std::ranges::all_of(
            rows, [&](std::uint32_t row) { return isIn(selection, columns_->result(row)); }))
      whole.push_back(std::move(rows));
  return whole;
}

std::vector<Effect> StudyEvaluation::mainEffects(const std::string& quantity,
                                                 StudySelection selection) const
{
  const auto cochleae = wholeCochleae(selection);
  const auto& values = columns_->quantity(quantity)->values;
  std::vector<Effect> effects;
  if (cochleae.size() < fewestCochleae) return effects;
  for (const StudyFactor* factor : factors_)
    for (const Level& level : levelsOf(*factor)) {
      std::vector<double> differences;
      for (const Rows& rows : cochleae)
        differences.push_back(
            meanWhere(rows, values, [&](std::uint32_t row) { return level.isOf(row); }) -
            meanWhere(rows, values, everyRow));
      effects.push_back({level.name(), *analysis::meanWithInterval(differences)});
    }
  return effects;
}

std::vector<Effect> StudyEvaluation::interactions(const std::string& quantity,
                                                  StudySelection selection) const
{
  const auto cochleae = wholeCochleae(selection);
  const auto& values = columns_->quantity(quantity)->values;
  std::vector<Effect> effects;
  if (cochleae.size() < fewestCochleae) return effects;
  for (auto one = factors_.begin(); one != factors_.end(); ++one)
    for (auto other = std::next(one); other != factors_.end(); ++other)
      for (const Level& a : levelsOf(**one))
        for (const Level& b : levelsOf(**other)) {
          std::vector<double> excess;
          for (const Rows& rows : cochleae)
            excess.push_back(
                meanWhere(rows, values,
                          [&](std::uint32_t row) { return a.isOf(row) && b.isOf(row); }) -
                meanWhere(rows, values, [&](std::uint32_t row) { return a.isOf(row); }) -
                meanWhere(rows, values, [&](std::uint32_t row) { return b.isOf(row); }) +
                meanWhere(rows, values, everyRow));
          effects.push_back({a.name() + ", " + b.name(), *analysis::meanWithInterval(excess)});
        }
  std::stable_sort(effects.begin(), effects.end(), [](const Effect& a, const Effect& b) {
    return std::fabs(a.size.value) > std::fabs(b.size.value);
  });
  return effects;
}

std::vector<Slope> StudyEvaluation::slopes(const std::string& quantity,
                                           StudySelection selection) const
{
  std::vector<std::string> names = {"A_mm"};
  names.insert(names.end(), ranges_.begin(), ranges_.end());
  const auto& y = columns_->quantity(quantity)->values;
  std::vector<Slope> slopes;
  for (const std::string& name : names) {
    const auto& x = columns_->quantity(name)->values;
    // Both variables less the mean of their combination.
    std::map<std::vector<std::uint16_t>, std::vector<std::pair<double, double>>> points;
    for (std::uint32_t row = 0; row < columns_->size(); ++row) {
      if (!isIn(selection, columns_->result(row)) || !std::isfinite(x[row])) continue;
      std::vector<std::uint16_t> combination;
      for (const StudyFactor* factor : factors_) combination.push_back(factor->level[row]);
      points[combination].emplace_back(x[row], y[row]);
    }
    double xx = 0.0, xy = 0.0, yy = 0.0;
    double freedom = -1.0;
    for (const auto& [combination, own] : points) {
      double meanX = 0.0, meanY = 0.0;
      for (const auto& [a, b] : own) meanX += a, meanY += b;
      meanX /= static_cast<double>(own.size());
      meanY /= static_cast<double>(own.size());
      for (const auto& [a, b] : own) {
        xx += (a - meanX) * (a - meanX);
        xy += (a - meanX) * (b - meanY);
        yy += (b - meanY) * (b - meanY);
      }
      freedom += static_cast<double>(own.size()) - 1.0;
    }
    if (!(xx > 0.0) || freedom < 1.0) continue;
    const double slope = xy / xx;
    const double error = std::sqrt(std::max(yy - slope * xy, 0.0) / freedom / xx);
    const double half = analysis::studentHalfWidth95(freedom) * error;
    slopes.push_back({name, {slope, slope - half, slope + half}});
  }
  return slopes;
}

}  // namespace perilymph::study

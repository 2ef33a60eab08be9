// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudySummary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stop_token>

#include "InsertionsTable.h"
#include "SummaryColumns.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/session/Csv.h"

namespace perilymph::study {

namespace {

using analysis::Estimate;

constexpr const char* endings = "ending";

/// The finite values of some rows.
std::vector<double> finiteOf(const std::vector<double>& values,
                             const std::vector<std::uint32_t>& rows)
{
  std::vector<double> finite;
  finite.reserve(rows.size());
  for (const std::uint32_t row : rows)
    if (std::isfinite(values[row])) finite.push_back(values[row]);
  return finite;
}

std::optional<Estimate> quartilesOf(std::vector<double> values)
{
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto at = [&values](double fraction) {
    return quantileOfSorted(values, fraction, QuantileRule::ofSample);
  };
  return Estimate{at(0.5), at(0.25), at(0.75)};
}

std::optional<analysis::LinearTrend> trendOf(const StudyColumns& columns,
                                             const std::vector<std::uint32_t>& rows,
                                             const SummaryAxes& axes)
{
  const StudyQuantity *x = columns.quantity(axes.x), *y = columns.quantity(axes.y);
  if (x == nullptr || y == nullptr) return std::nullopt;
  std::vector<double> xs, ys;
  for (const std::uint32_t row : rows)
    if (std::isfinite(x->values[row]) && std::isfinite(y->values[row])) {
      xs.push_back(x->values[row]);
      ys.push_back(y->values[row]);
    }
  return analysis::linearTrend(xs, ys);
}

std::vector<std::uint32_t> selectedOf(const StudyColumns& columns,
                                      const std::vector<std::uint32_t>& rows,
                                      StudySelection selection)
{
  std::vector<std::uint32_t> selected;
  selected.reserve(rows.size());
  for (const std::uint32_t row : rows)
    if (isIn(selection, columns.result(row))) selected.push_back(row);
  return selected;
}

StudySample sampleOf(const StudyColumns& columns, const std::vector<std::uint32_t>& rows,
                     const SummaryAxes& axes)
{
  StudySample sample;
  sample.count = rows.size();
  for (std::size_t i = 0; i < summarizedQuantities.size(); ++i) {
    const auto values = finiteOf(columns.quantity(summarizedQuantities[i].key)->values, rows);
    if (!values.empty()) sample.means[i] = analysis::statisticsOf(values);
    sample.quartiles[i] = quartilesOf(values);
  }
  sample.trend = trendOf(columns, rows, axes);
  return sample;
}

StudyGroup groupOf(const StudyColumns& columns, StudyGroup group, const SummaryAxes& axes)
{
  for (const StudySelection selection : studySelections)
    group.samples[selection] = sampleOf(columns, selectedOf(columns, group.rows, selection), axes);
  group.rate = analysis::proportionOf(group.complete(), group.rows.size());
  return group;
}

using Draws = std::map<std::string, std::uint32_t>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Rows by what their partners in other groups share with them: the cochlea and every setting but that
/// of the groups.
Draws byDraw(const StudyColumns& columns, const std::vector<std::uint32_t>& selected,
             const std::string& key)
{
  Draws rows;
  for (const std::uint32_t row : selected) {
    const StudyResult& result = columns.result(row);
    std::string draw = result.cochlea;
    for (const auto& [name, value] : result.settings)
      if (name != key) draw += '\n' + name + '=' + value;
    rows.emplace(std::move(draw), row);
  }
  return rows;
}

/// Rows of insertions that share their draw.
Pairs pairsOf(const Draws& one, const Draws& other)
{
  Pairs pairs;
  for (const auto& [draw, row] : one)
    if (const auto partner = other.find(draw); partner != other.end())
      pairs.emplace_back(row, partner->second);
  return pairs;
}

/// The differences of pairs: one for each cochlea, the mean of its pairs; of a single cochlea one for
/// each pair.
std::vector<double> differencesOf(const StudyColumns& columns, const Pairs& pairs,
                                  const std::vector<double>& values)
{
  std::map<std::string, std::vector<double>> byCochlea;
  for (const auto& [row, partner] : pairs)
    byCochlea[columns.result(row).cochlea].push_back(values[row] - values[partner]);
  if (byCochlea.size() == 1) return byCochlea.begin()->second;
  std::vector<double> means;
  for (const auto& [cochlea, own] : byCochlea) means.push_back(analysis::statisticsOf(own).mean);
  return means;
}

std::size_t cochleaeOf(const StudyColumns& columns, const Pairs& pairs)
{
  std::set<std::string> names;
  for (const auto& pair : pairs) names.insert(columns.result(pair.first).cochlea);
  return names.size();
}

/// The selected rows of a group, also by their draw.
struct SelectedGroup {
  std::vector<std::uint32_t> rows;
  Draws draws;
};

StudyDifference differenceOf(const StudyColumns& columns, const SelectedGroup& one,
                             const SelectedGroup& other)
{
  StudyDifference found;
  const Pairs pairs = pairsOf(one.draws, other.draws);
  found.isPaired = pairs.size() >= 2;
  if (found.isPaired) found.cochleae = cochleaeOf(columns, pairs);
  found.count = found.isPaired ? pairs.size() : one.rows.size();
  found.otherCount = found.isPaired ? pairs.size() : other.rows.size();
  for (std::size_t i = 0; i < summarizedQuantities.size(); ++i) {
    const auto& values = columns.quantity(summarizedQuantities[i].key)->values;
    if (found.isPaired)
      found.means[i] = analysis::meanWithInterval(differencesOf(columns, pairs, values));
    else if (const auto welch = analysis::welchDifference(finiteOf(values, one.rows),
                                                          finiteOf(values, other.rows)))
      found.means[i] = welch->difference;
  }
  return found;
}

std::string number(double value) { return session::shortestDecimal(value); }

/// Three fields with their commas before; empty ones without an estimate.
std::string fields(const std::optional<Estimate>& estimate)
{
  if (!estimate) return ",,,";
  return "," + number(estimate->value) + "," + number(estimate->low) + "," + number(estimate->high);
}

std::string groupsTable(const StudySummary& summary)
{
  std::string csv = headerOf(summaryGroupColumns()) + "\n";
  for (const StudyGroup& group : summary.groups)
    for (const StudySelection selection : studySelections) {
      const StudySample& sample = group.samples[selection];
      csv += csvField(group.level) + "," + nameOf(selection);
      for (const std::size_t count :
           {group.rows.size(), group.complete(), group.stopped(), group.notPrepared()})
        csv += "," + std::to_string(count);
      csv += fields(Estimate{100.0 * group.rate.value, 100.0 * group.rate.low,
                             100.0 * group.rate.high}) +
             "," + std::to_string(sample.count);
      for (std::size_t i = 0; i < summarizedQuantities.size(); ++i) {
        csv += fields(sample.quartiles[i]);
        csv += sample.means[i] ? "," + number(sample.means[i]->mean) : std::string(",");
        csv += sample.means[i] && sample.count > 1
                   ? "," + number(sample.means[i]->standardDeviation)
                   : std::string(",");
      }
      csv += "\n";
    }
  return csv;
}

std::string differencesTable(const StudySummary& summary)
{
  std::string csv = headerOf(summaryDifferenceColumns()) + "\n";
  for (const StudyDifference& each : summary.differences) {
    csv += csvField(summary.groups[each.group].level) + "," +
           csvField(summary.groups[each.other].level) + "," + nameOf(each.selection) +
           (each.isPaired ? ",paired," : ",Welch,") + std::to_string(each.count) + "," +
           std::to_string(each.otherCount) + "," +
           (each.isPaired ? std::to_string(each.cochleae) : std::string());
    for (const auto& mean : each.means) csv += fields(mean);
    csv += "\n";
  }
  return csv;
}

/// The slope is in units of y per unit of x, which their keys name.
std::string trendsTable(const StudySummary& summary)
{
  std::string csv = headerOf(summaryTrendColumns()) + "\n";
  for (const StudyGroup& group : summary.groups)
    for (const StudySelection selection : studySelections) {
      const auto& trend = group.samples[selection].trend;
      if (!trend) continue;
      csv += csvField(group.level) + "," + nameOf(selection) + "," + csvField(summary.axes.x) +
             "," + csvField(summary.axes.y) + "," + std::to_string(trend->count()) +
             fields(trend->slope()) + "," + number(trend->intercept()) + "," +
             number(trend->residualDeviation()) + "\n";
    }
  return csv;
}

}  // namespace

const char* nameOf(StudySelection selection)
{
  return selection == StudySelection::ran ? "all that ran" : "complete";
}

bool isIn(StudySelection selection, const StudyResult& result)
{
  const analysis::InsertionEnd end = result.insertion.end;
  return selection == StudySelection::ran ? end != analysis::InsertionEnd::refused
                                          : end == analysis::InsertionEnd::finished;
}

StudySummary summaryOf(const StudyColumns& columns, const std::vector<std::uint32_t>& rows,
                       const SummaryAxes& axes, const std::stop_token& stop)
{
  StudySummary summary{axes, {}, {}};
  const StudyFactor* factor = columns.factor(axes.group);
  const bool isGrouped = factor != nullptr;
  std::vector<StudyGroup> groups(isGrouped ? factor->levels.size() : 1);
  for (std::size_t i = 0; isGrouped && i < groups.size(); ++i) groups[i].level = factor->levels[i];
  for (const std::uint32_t row : rows)
    groups[isGrouped ? factor->level[row] : 0].rows.push_back(row);
  for (StudyGroup& group : groups) {
    if (stop.stop_requested()) return summary;
    if (!group.rows.empty()) summary.groups.push_back(groupOf(columns, std::move(group), axes));
  }
  if (!isGrouped || axes.group == endings) return summary;
  for (const StudySelection selection : studySelections) {
    std::vector<SelectedGroup> selected;
    for (const StudyGroup& group : summary.groups) {
      if (stop.stop_requested()) return summary;
      auto& added = selected.emplace_back();
      added.rows = selectedOf(columns, group.rows, selection);
      added.draws = byDraw(columns, added.rows, axes.group);
    }
    for (std::size_t i = 0; i < selected.size(); ++i)
      for (std::size_t k = i + 1; k < selected.size() && !stop.stop_requested(); ++k) {
        auto& added =
            summary.differences.emplace_back(differenceOf(columns, selected[i], selected[k]));
        added.group = i;
        added.other = k;
        added.selection = selection;
      }
  }
  return summary;
}

std::vector<std::pair<const char*, std::string>> tablesOf(const StudyColumns& columns,
                                                          const std::vector<std::uint32_t>& rows,
                                                          const StudySummary& summary)
{
  std::set<std::string> settings;
  for (const std::uint32_t row : rows)
    for (const auto& [key, value] : columns.result(row).settings) settings.insert(key);
  std::string points = insertionsHeader(settings);
  for (const std::uint32_t row : rows) points += insertionsRow(columns.result(row), settings);
  return {{summaryTables[0], std::move(points)},
          {summaryTables[1], groupsTable(summary)},
          {summaryTables[2], differencesTable(summary)},
          {summaryTables[3], trendsTable(summary)}};
}

}  // namespace perilymph::study

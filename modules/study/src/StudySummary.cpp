// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudySummary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stop_token>

#include "InsertionsTable.h"
#include "perilymph/analysis/CsvField.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/session/Csv.h"

namespace perilymph::study {

namespace {

using analysis::csvField;
using analysis::Estimate;

constexpr const char* endings = "ending";

bool isFinished(const StudyResult& result)
{
  return result.insertion.end == analysis::InsertionEnd::finished;
}

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

StudyGroup groupOf(const StudyColumns& columns, StudyGroup group, const SummaryAxes& axes)
{
  for (const std::uint32_t row : group.rows)
    if (isFinished(columns.result(row))) ++group.finished;
  group.rate = analysis::proportionOf(group.finished, group.rows.size());
  for (std::size_t i = 0; i < summarizedQuantities.size(); ++i)
    group.quartiles[i] =
        quartilesOf(finiteOf(columns.quantity(summarizedQuantities[i].key)->values, group.rows));
  group.trend = trendOf(columns, group.rows, axes);
  return group;
}

using Draws = std::map<std::string, std::uint32_t>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The rows of a group by what its partners in other groups share with them: the cochlea and every
/// setting but that of the groups.
Draws byDraw(const StudyColumns& columns, const StudyGroup& group, const std::string& key)
{
  Draws rows;
  for (const std::uint32_t row : group.rows) {
    const StudyResult& result = columns.result(row);
    if (result.insertion.end == analysis::InsertionEnd::refused) continue;
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

StudyDifference differenceOf(const StudyColumns& columns, const std::vector<StudyGroup>& groups,
                             std::size_t group, std::size_t other, const std::vector<Draws>& draws)
{
  StudyDifference found;
  found.group = group;
  found.other = other;
  const Pairs pairs = pairsOf(draws[group], draws[other]);
  found.isPaired = pairs.size() >= 2;
  if (found.isPaired) found.cochleae = cochleaeOf(columns, pairs);
  const auto ran = [&](std::size_t index) {
    return found.isPaired
               ? pairs.size()
               : finiteOf(columns.quantity(summarizedQuantities[0].key)->values, groups[index].rows)
                     .size();
  };
  found.count = ran(group);
  found.otherCount = ran(other);
  for (std::size_t i = 0; i < summarizedQuantities.size(); ++i) {
    const auto& values = columns.quantity(summarizedQuantities[i].key)->values;
    if (found.isPaired)
      found.means[i] = analysis::meanWithInterval(differencesOf(columns, pairs, values));
    else if (const auto welch = analysis::welchDifference(finiteOf(values, groups[group].rows),
                                                          finiteOf(values, groups[other].rows)))
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

std::string columnsOf(const char* value, const char* low, const char* high)
{
  std::string header;
  for (const SummarizedQuantity& each : summarizedQuantities)
    for (const char* what : {value, low, high})
      header += std::string(",") + each.column + "_" + what + "_" + each.unit;
  return header;
}

std::string groupsTable(const StudySummary& summary)
{
  std::string csv =
      "group,n,complete,stopped,complete_percent,complete_low95_percent,"
      "complete_high95_percent" +
      columnsOf("median", "quartile25", "quartile75") + "\n";
  for (const StudyGroup& group : summary.groups) {
    csv +=
        csvField(group.level) + "," + std::to_string(group.rows.size()) + "," +
        std::to_string(group.finished) + "," + std::to_string(group.stopped()) +
        fields(Estimate{100.0 * group.rate.value, 100.0 * group.rate.low, 100.0 * group.rate.high});
    for (const auto& each : group.quartiles) csv += fields(each);
    csv += "\n";
  }
  return csv;
}

std::string differencesTable(const StudySummary& summary)
{
  std::string csv =
      "group,other,method,n,n_other,cochleae" + columnsOf("difference", "low95", "high95") + "\n";
  for (const StudyDifference& each : summary.differences) {
    csv += csvField(summary.groups[each.group].level) + "," +
           csvField(summary.groups[each.other].level) + (each.isPaired ? ",paired," : ",Welch,") +
           std::to_string(each.count) + "," + std::to_string(each.otherCount) + "," +
           (each.isPaired ? std::to_string(each.cochleae) : std::string());
    for (const auto& mean : each.means) csv += fields(mean);
    csv += "\n";
  }
  return csv;
}

/// The slope is in units of y per unit of x, which their keys name.
std::string trendsTable(const StudySummary& summary)
{
  std::string csv = "group,x,y,n,slope,slope_low95,slope_high95,intercept,residual_sd\n";
  for (const StudyGroup& group : summary.groups) {
    if (!group.trend) continue;
    csv += csvField(group.level) + "," + csvField(summary.axes.x) + "," + csvField(summary.axes.y) +
           "," + std::to_string(group.trend->count()) + fields(group.trend->slope()) + "," +
           number(group.trend->intercept()) + "," + number(group.trend->residualDeviation()) + "\n";
  }
  return csv;
}

}  // namespace

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
  std::vector<Draws> draws;
  for (const StudyGroup& group : summary.groups) {
    if (stop.stop_requested()) return summary;
    draws.push_back(byDraw(columns, group, axes.group));
  }
  for (std::size_t i = 0; i < summary.groups.size(); ++i)
    for (std::size_t k = i + 1; k < summary.groups.size() && !stop.stop_requested(); ++k)
      summary.differences.push_back(differenceOf(columns, summary.groups, i, k, draws));
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

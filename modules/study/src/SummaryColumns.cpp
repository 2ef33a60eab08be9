// SPDX-License-Identifier: BSD-3-Clause
#include "SummaryColumns.h"

#include <string>
#include <utility>
#include <vector>

#include "perilymph/study/StudySummary.h"

namespace perilymph::study {

namespace {

/// Columns of each summarized quantity: "angle_median_deg", ...
void addQuantities(FieldMeanings& columns,
                   const std::vector<std::pair<const char*, const char*>>& statistics)
{
  for (const SummarizedQuantity& each : summarizedQuantities) {
    const std::string title = each.title;
    for (const auto& [name, words] : statistics)
      columns.push_back({std::string(each.column) + "_" + name + "_" + each.unit, each.unit,
                         title.substr(0, title.find(',')) + ", " + words});
  }
}

}  // namespace

const FieldMeanings& summaryGroupColumns()
{
  static const FieldMeanings columns = [] {
    FieldMeanings all = {
        {"group", "", "value of the setting by which insertions are grouped"},
        {"selection", "", "all that ran, or complete"},
        {"n", "", "number of insertions of the group"},
        {"complete", "", "number of those that reached their full depth"},
        {"stopped", "", "number of those that ended before"},
        {"not_prepared", "", "number of those that could not be run"},
        {"complete_percent", "percent", "complete ones of all"},
        {"complete_low95_percent", "percent", "lower limit of its 95 % interval (Wilson)"},
        {"complete_high95_percent", "percent", "upper limit"},
        {"n_selected", "", "number of insertions of the selection"}};
    addQuantities(all, {{"median", "median"},
                        {"quartile25", "lower quartile"},
                        {"quartile75", "upper quartile"},
                        {"mean", "mean"},
                        {"sd", "standard deviation"}});
    return all;
  }();
  return columns;
}

const FieldMeanings& summaryDifferenceColumns()
{
  static const FieldMeanings columns = [] {
    FieldMeanings all = {
        {"group", "", "first group"},
        {"other", "", "second group"},
        {"selection", "", "all that ran, or complete"},
        {"method", "", "paired, of insertions that share cochlea and random values, or Welch"},
        {"n", "", "number of pairs, or of insertions of the first group"},
        {"n_other", "", "number of pairs, or of insertions of the second group"},
        {"cochleae", "", "number of cochleae of the pairs; else empty"}};
    addQuantities(all, {{"mean_difference", "mean of the first group less that of the second"},
                        {"low95", "lower limit of its 95 % interval"},
                        {"high95", "upper limit"}});
    return all;
  }();
  return columns;
}

const FieldMeanings& summaryTrendColumns()
{
  static const FieldMeanings columns = {
      {"group", "", "value of the setting by which insertions are grouped"},
      {"selection", "", "all that ran, or complete"},
      {"x", "", "quantity of the horizontal axis"},
      {"y", "", "quantity of the vertical axis"},
      {"n", "", "number of insertions"},
      {"slope", "of y per x", "slope of the line of least squares"},
      {"slope_low95", "of y per x", "lower limit of its 95 % interval"},
      {"slope_high95", "of y per x", "upper limit"},
      {"intercept", "of y", "value of the line at x = 0"},
      {"residual_sd", "of y", "standard deviation about the line"}};
  return columns;
}

}  // namespace perilymph::study

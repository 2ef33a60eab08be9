// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ClinicalReports.h"

#include <algorithm>

#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

namespace {

constexpr std::array reportedQuantities{
    Choice<ReportedQuantity>{ReportedQuantity::angle, "angle"},
    Choice<ReportedQuantity>{ReportedQuantity::contactsInside, "contacts_inside"},
    Choice<ReportedQuantity>{ReportedQuantity::complete, "complete"},
    Choice<ReportedQuantity>{ReportedQuantity::translocation, "translocation"},
    Choice<ReportedQuantity>{ReportedQuantity::foldOver, "fold_over"},
    Choice<ReportedQuantity>{ReportedQuantity::peakForce, "peak_force"},
    Choice<ReportedQuantity>{ReportedQuantity::endForce, "end_force"}};

constexpr std::array reportedSpreads{Choice<ReportedSpread>{ReportedSpread::none, "none"},
                                     Choice<ReportedSpread>{ReportedSpread::quartiles, "quartiles"},
                                     Choice<ReportedSpread>{ReportedSpread::range, "range"},
                                     Choice<ReportedSpread>{ReportedSpread::sd, "sd"}};

/// Values of a quantity that a report may hold.
Range rangeOfReported(ReportedQuantity quantity)
{
  switch (quantity) {
    case ReportedQuantity::angle:
      return {0.0, 1080.0};
    case ReportedQuantity::contactsInside:
      return {0.0, 64.0};
    case ReportedQuantity::peakForce:
    case ReportedQuantity::endForce:
      return {0.0, 2000.0};
    default:
      return {0.0, 100.0};
  }
}

bool isProportion(ReportedQuantity quantity)
{
  return quantity == ReportedQuantity::complete || quantity == ReportedQuantity::translocation ||
         quantity == ReportedQuantity::foldOver;
}

/// A rate that is given as a count, with the interval that follows.
void readCount(TomlReader& table, ClinicalReport& report)
{
  report.count = table.integer("count", 0, 1'000'000'000, 0);
  if (!isProportion(report.quantity))
    return table.refuse("count",
                        "count is for complete, translocation and fold_over alone; give value");
  if (report.n < 1 || *report.count > report.n)
    return table.refuse("count", "count exceeds n; give the number of those that had it, 0 to n");
  const Estimate rate =
      proportionOf(static_cast<std::size_t>(*report.count), static_cast<std::size_t>(report.n));
  report.value = 100.0 * rate.value;
  report.spread = ReportedSpread::interval95;
  report.low = *report.count == 0 ? 0.0 : 100.0 * rate.low;  // without its rounding
  report.high = 100.0 * rate.high;
}

ClinicalReport readReport(TomlReader& table)
{
  ClinicalReport report;
  report.arrays = table.values("arrays");
  report.quantity = table.choice("quantity", reportedQuantities);
  report.statistic = table.choice("statistic", {"median", "mean", "proportion", "none"});
  report.n = table.integer("n", 0, 1'000'000'000, 0);
  const Range allowed = rangeOfReported(report.quantity);
  if (table.has("count")) {
    readCount(table, report);
  } else {
    if (table.has("value")) report.value = table.number("value", allowed);
    report.spread = table.choice("spread", reportedSpreads, ReportedSpread::none);
    if (report.spread != ReportedSpread::none) {
      report.low = table.number("low", allowed);
      report.high = table.number("high", {report.low, allowed.high});
      if (report.value && (*report.value < report.low || *report.value > report.high))
        table.refuse("value", "value lies outside of low to high; correct one of the three");
    }
    if (!report.value && report.spread == ReportedSpread::none)
      table.refuse("value", "a report needs a value, a count, or low and high with their spread");
  }
  if (table.has("n_of")) report.nOf = table.text("n_of");
  if (table.has("value_of")) report.valueOf = table.text("value_of");
  report.definition = table.text("definition");
  report.reference = table.text("reference");
  report.source = table.text("source");
  report.read = table.choice("read", {"table", "abstract", "quoted"});
  report.confidence = table.choice("confidence", {"high", "medium", "low"});
  return report;
}

bool isOf(const ClinicalReport& report, const std::string& array, ReportedQuantity quantity)
{
  return report.quantity == quantity &&
         std::ranges::find(report.arrays, array) != report.arrays.end();
}

/// At most two decimals.
std::string shortNumber(double value)
{
  return session::shortestDecimal(static_cast<double>(std::lround(value * 100.0)) / 100.0);
}

}  // namespace

const char* nameOf(ReportedQuantity quantity) { return nameIn(reportedQuantities, quantity); }

const char* nameOf(ReportedSpread spread)
{
  return spread == ReportedSpread::interval95 ? "interval95" : nameIn(reportedSpreads, spread);
}

const char* nameOf(ArrayVerdict verdict)
{
  if (verdict == ArrayVerdict::hit) return "hit";
  return verdict == ArrayVerdict::miss ? "miss" : "not_tested";
}

Result<ClinicalEvidence> ClinicalEvidence::read(const std::filesystem::path& reports,
                                                const std::filesystem::path& verdicts)
{
  ClinicalEvidence evidence;
  auto reader = TomlReader::open(reports);
  if (!reader) return reader.error();
  reader->text("label");
  for (TomlReader& table : reader->tables("report")) evidence.reports_.push_back(readReport(table));
  if (const auto done = reader->finish(); !done) return done.error();

  auto judged = TomlReader::open(verdicts);
  if (!judged) return judged.error();
  judged->text("label");
  evidence.verdictSource_ = judged->text("source");
  for (TomlReader& table : judged->tables("verdict"))
    evidence.rows_.push_back({table.text("array"), table.text("row"),
                              table.choice("verdict", {"hit", "miss"}) == "hit"});
  if (const auto done = judged->finish(); !done) return done.error();
  return evidence;
}

const Result<ClinicalEvidence>& ClinicalEvidence::shipped()
{
  static const Result<ClinicalEvidence> evidence = read(
      resource("resources/clinical/reports.toml"), resource("resources/clinical/verdicts.toml"));
  return evidence;
}

const ClinicalReport* ClinicalEvidence::find(const std::string& array,
                                             ReportedQuantity quantity) const
{
  const auto found = std::ranges::find_if(
      reports_, [&](const ClinicalReport& each) { return isOf(each, array, quantity); });
  return found == reports_.end() ? nullptr : &*found;
}

std::vector<const ClinicalReport*> ClinicalEvidence::findAll(const std::string& array,
                                                             ReportedQuantity quantity) const
{
  std::vector<const ClinicalReport*> found;
  for (const ClinicalReport& each : reports_)
    if (isOf(each, array, quantity)) found.push_back(&each);
  return found;
}

ArrayVerdict ClinicalEvidence::verdictOf(const std::string& array) const
{
  if (!missedRows(array).empty()) return ArrayVerdict::miss;
  return std::ranges::find(rows_, array, &RowOfArray::array) == rows_.end()
             ? ArrayVerdict::notTested
             : ArrayVerdict::hit;
}

std::vector<std::string> ClinicalEvidence::missedRows(const std::string& array) const
{
  std::vector<std::string> missed;
  for (const RowOfArray& each : rows_)
    if (each.array == array && !each.isHit) missed.push_back(each.row);
  return missed;
}

std::string numbersOf(const ClinicalReport& report)
{
  if (report.count) return std::to_string(*report.count) + " of " + std::to_string(report.n);
  const std::string bounds = shortNumber(report.low) + " to " + shortNumber(report.high);
  if (!report.value) return bounds;
  if (report.spread == ReportedSpread::none) return shortNumber(*report.value);
  if (report.spread == ReportedSpread::sd)
    return shortNumber(*report.value) + " (SD " + shortNumber(0.5 * (report.high - report.low)) +
           ")";
  const char* kind = "";
  if (report.spread == ReportedSpread::quartiles) kind = "quartiles ";
  if (report.spread == ReportedSpread::range) kind = "range ";
  return shortNumber(*report.value) + " (" + kind + bounds + ")";
}

}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause

// Rows of the clinical table: what is published, and whether the insertions meet it.

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/Reference.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/validation/ClinicalPrediction.h"
#include "perilymph/validation/Prediction.h"

namespace perilymph::validation {

namespace {

/// A published count.
struct ClinicalRate {
  std::string quantity, array, source, confidence;
  long count = 0, of = 1;
};

Result<std::vector<ClinicalRate>> clinicalRates()
{
  auto reader = TomlReader::open(resource("resources/clinical/rates.toml"));
  if (!reader) return reader.error();
  std::vector<ClinicalRate> rates;
  reader->text("label");
  for (TomlReader& table : reader->tables("rate")) {
    ClinicalRate rate;
    rate.quantity = table.text("quantity");
    rate.array = table.text("array");
    rate.of = table.integer("of", 1, 1'000'000, 1);
    rate.count = table.integer("count", 0, rate.of, 0);
    rate.source = table.text("source");
    rate.confidence = table.choice("confidence", {"high", "medium", "low"});
    rates.push_back(rate);
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return rates;
}

using Insertions = std::vector<analysis::ClinicalInsertion>;

std::vector<double> valuesOf(const Insertions& insertions, const std::string& array,
                             double (*value)(const analysis::ClinicalInsertion&))
{
  std::vector<double> values;
  for (const analysis::ClinicalInsertion& each : insertions)
    if (array == "all" || each.array == array) values.push_back(value(each));
  return values;
}

/// Fills in the prediction. A range is hit if the median and at least half of the runs are inside.
void judge(ClinicalRow& row, const std::vector<double>& values)
{
  row.runs = static_cast<int>(values.size());
  if (values.empty()) return;
  row.median = quantile(values, 0.5);
  row.lowerQuartile = quantile(values, 0.25);
  row.upperQuartile = quantile(values, 0.75);
  if (!(row.high > row.low)) return;
  const auto isInside = [&](double value) { return value >= row.low && value <= row.high; };
  row.inside = static_cast<double>(std::count_if(values.begin(), values.end(), isInside)) /
               static_cast<double>(values.size());
  if (row.confidence == "low") return;
  row.verdict = isInside(row.median) && row.inside >= 0.5 ? RowVerdict::hit : RowVerdict::miss;
}

ClinicalRow forceRow(const char* quantity, const analysis::PrintedRange* range)
{
  ClinicalRow row;
  row.quantity = quantity;
  row.unit = "mN";
  if (!range) return row;
  row.low = range->low * 1e3;
  row.high = range->high * 1e3;
  row.source = range->source;
  row.confidence = "high";
  return row;
}

/// The 95 % interval of a published count (Wilson, J Am Stat Assoc 22, 209, 1927), in percent. A
/// rate is hit if the predicted one is inside.
ClinicalRow rateRow(const ClinicalRate& rate, const Insertions& insertions)
{
  ClinicalRow row;
  row.quantity = rate.quantity + " of " + (rate.array == "all" ? "all arrays" : rate.array);
  row.unit = "%";
  row.source = rate.source;
  row.confidence = rate.confidence;
  constexpr double z = 1.959964;
  const double n = static_cast<double>(rate.of), p = static_cast<double>(rate.count) / n;
  const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  row.low = 100.0 * (middle - half);
  row.high = 100.0 * (middle + half);
  const bool isRupture = rate.quantity.find("rupture") != std::string::npos;
  const std::vector<double> values =
      isRupture
          ? valuesOf(insertions, rate.array,
                     [](const analysis::ClinicalInsertion& i) { return i.isRuptured ? 1.0 : 0.0; })
          : valuesOf(insertions, rate.array, [](const analysis::ClinicalInsertion& i) {
              return i.end == haptics::InsertionEnd::finished ? 1.0 : 0.0;
            });
  row.runs = static_cast<int>(values.size());
  if (values.empty()) return row;
  double sum = 0.0;
  for (const double value : values) sum += value;
  row.median = row.lowerQuartile = row.upperQuartile = 100.0 * sum / row.runs;
  const bool isInside = row.median >= row.low && row.median <= row.high;
  row.inside = isInside ? 1.0 : 0.0;
  if (row.confidence != "low") row.verdict = isInside ? RowVerdict::hit : RowVerdict::miss;
  return row;
}

}  // namespace

Result<std::vector<ClinicalRow>> clinicalRows(
    const std::vector<analysis::ClinicalInsertion>& insertions)
{
  const auto inVivo = analysis::shippedReference("in-vivo");
  if (!inVivo) return inVivo.error();
  const auto angles = clinicalAngles();
  if (!angles) return angles.error();
  const auto rates = clinicalRates();
  if (!rates) return rates.error();

  std::vector<ClinicalRow> rows;
  ClinicalRow end = forceRow("force at the end, all arrays", inVivo->findRange("end of insertion"));
  judge(end, valuesOf(insertions, "all", [](const analysis::ClinicalInsertion& i) {
          return inMillinewtons(i.endForce);
        }));
  rows.push_back(end);
  ClinicalRow peak = forceRow("peak force, all arrays", inVivo->findRange("peak"));
  peak.note = "bounded by the force at which surgeons stop, which is drawn from this range";
  judge(peak, valuesOf(insertions, "all", [](const analysis::ClinicalInsertion& i) {
          return inMillinewtons(i.peak);
        }));
  rows.push_back(peak);
  for (const ClinicalAngle& angle : *angles) {
    ClinicalRow row;
    row.quantity = "angular depth of " + angle.array;
    row.unit = "deg";
    row.low = inDegrees(angle.low);
    row.high = inDegrees(angle.high);
    row.source = angle.source;
    row.confidence = "high";
    judge(row, valuesOf(insertions, angle.array,
                        [](const analysis::ClinicalInsertion& i) { return inDegrees(i.apical); }));
    rows.push_back(row);
  }
  for (const ClinicalRate& rate : *rates) rows.push_back(rateRow(rate, insertions));

  ClinicalRow buckling;
  buckling.quantity = "peak force of buckled insertions";
  buckling.unit = "mN";
  buckling.confidence = "low";
  buckling.source = "no published value with a known free length was found";
  Insertions buckled;
  for (const analysis::ClinicalInsertion& each : insertions)
    if (each.end == haptics::InsertionEnd::buckled) buckled.push_back(each);
  judge(buckling, valuesOf(buckled, "all", [](const analysis::ClinicalInsertion& i) {
          return inMillinewtons(i.peak);
        }));
  rows.push_back(buckling);
  return rows;
}

}  // namespace perilymph::validation

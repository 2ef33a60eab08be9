// SPDX-License-Identifier: BSD-3-Clause

// Rows of the clinical table: what is published, and whether the insertions meet it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/validation/ClinicalPrediction.h"
#include "prediction/PublishedClinic.h"

namespace perilymph::validation {

namespace {

using Insertions = std::vector<analysis::ClinicalInsertion>;

// Errors against which the power of a verdict is given (choice, high): a quarter turn and more, and a
// rate that a clinic would see.
constexpr double wrongBy_deg = 100.0;
constexpr double wrongBy = 0.2;

Insertions of(const Insertions& insertions, const std::string& array)
{
  Insertions some;
  for (const analysis::ClinicalInsertion& each : insertions)
    if (array == "all" || each.array == array) some.push_back(each);
  return some;
}

template <class Value>
std::vector<double> valuesOf(const Insertions& insertions, Value value)
{
  std::vector<double> values;
  for (const analysis::ClinicalInsertion& each : insertions) values.push_back(value(each));
  return values;
}

RowVerdict verdictOf(bool isHit) { return isHit ? RowVerdict::hit : RowVerdict::miss; }

/// Fills in the prediction.
void describe(ClinicalRow& row, const std::vector<double>& values)
{
  row.runs = static_cast<int>(values.size());
  if (values.empty()) return;
  row.median = quantile(values, 0.5);
  row.lowerQuartile = quantile(values, 0.25);
  row.upperQuartile = quantile(values, 0.75);
  if (!(row.high > row.low)) return;
  const auto inside = std::count_if(values.begin(), values.end(), [&](double value) {
    return value >= row.low && value <= row.high;
  });
  row.inside = static_cast<double>(inside) / static_cast<double>(values.size());
}

/// A force: shown without a verdict.
ClinicalRow forceRow(const char* quantity, const analysis::Reference& inVivo, const char* range,
                     const std::vector<double>& values_mN, const char* note)
{
  ClinicalRow row;
  row.quantity = quantity;
  row.unit = "mN";
  row.note = note;
  row.confidence = "high";
  if (const analysis::PrintedRange* printed = inVivo.findRange(range)) {
    row.low = printed->low * 1e3;
    row.high = printed->high * 1e3;
    row.published = 0.5 * (row.low + row.high);
    row.source = printed->source;
    row.patients = static_cast<int>(inVivo.insertions);
  }
  describe(row, values_mN);
  return row;
}

/// The angle of the most apical contact when as many contacts were inside as given, from where the
/// array lies at the end: it follows its tip. Empty if it did not come so deep.
std::optional<double> angleWith_deg(double contactsInside,
                                    const analysis::ClinicalInsertion& insertion)
{
  const auto& contacts = insertion.contacts;
  if (contacts.size() < 2 || !(contactsInside >= 1.0)) return std::nullopt;
  const double place = std::min(contactsInside - 1.0, static_cast<double>(contacts.size() - 1));
  const auto first = std::min(static_cast<std::size_t>(place), contacts.size() - 2);
  const double fraction = place - static_cast<double>(first);
  const double there =
      (1.0 - fraction) * contacts[first].depth.si() + fraction * contacts[first + 1].depth.si();
  if (there < 0.0) return std::nullopt;
  const double apical = contacts.front().depth.si() - there;  // depth of the apical contact then
  for (std::size_t i = 1; i < contacts.size() && contacts[i].isInserted; ++i) {
    const double deep = contacts[i - 1].depth.si(), near = contacts[i].depth.si();
    if (apical > deep || apical < near) continue;
    const double part = (apical - near) / (deep - near);
    return part * inDegrees(contacts[i - 1].angle) + (1.0 - part) * inDegrees(contacts[i].angle);
  }
  return std::nullopt;
}

/// The contacts inside, and the angle at the published length.
void accompany(ClinicalRow& row, const PublishedArray& published, const Insertions& insertions)
{
  row.depth_mm = quantile(
      valuesOf(insertions,
               [](const analysis::ClinicalInsertion& each) { return inMillimeters(each.depth); }),
      0.5);
  std::vector<double> counts;
  for (const analysis::ClinicalInsertion& each : insertions)
    if (!each.contacts.empty())
      counts.push_back(static_cast<double>(
          std::count_if(each.contacts.begin(), each.contacts.end(),
                        [](const analysis::ContactPosition& one) { return one.isInserted; })));
  if (counts.empty()) return;
  const analysis::SampleStatistics found = analysis::statisticsOf(counts);
  ClinicalCompanion inside{found.mean, std::numeric_limits<double>::quiet_NaN(),
                           static_cast<int>(counts.size()), true};
  for (const ClinicalAngle& center : published.centers) {
    if (!center.contactsInside) continue;
    const analysis::SampleStatistics printed{
        *center.contactsInside, *center.contactsDeviation,
        *center.contactsDeviation / std::sqrt(static_cast<double>(center.patients))};
    inside.published = printed.mean;
    const analysis::SampleStatistics difference = analysis::differenceOf(found, printed);
    inside.isMet = std::fabs(difference.mean) <= halfWidth95 * difference.standardError;

    std::vector<double> angles;
    for (const analysis::ClinicalInsertion& each : insertions)
      if (const auto angle = angleWith_deg(printed.mean, each)) angles.push_back(*angle);
    ClinicalCompanion angle;
    angle.published = inDegrees(center.median);
    angle.runs = static_cast<int>(angles.size());
    angle.found = angles.empty() ? std::numeric_limits<double>::quiet_NaN() : quantile(angles, 0.5);
    angle.isMet = std::fabs(angle.found - angle.published) <= halfWidth95 * betweenCenters_deg;
    row.angleAtLength = angle;
  }
  row.contactsInside = inside;
}

ClinicalRow angleRow(const PublishedArray& published, const Insertions& insertions)
{
  ClinicalRow row;
  row.quantity = "angular depth of " + published.array;
  row.unit = "deg";
  row.confidence = "high";
  const PooledSample pool = pooled(published.samples(), betweenCenters_deg);
  row.published = pool.median;
  row.patients = pool.count;
  for (const ClinicalAngle& center : published.centers) {
    row.source += (row.source.empty() ? "" : "; ") + center.source;
    if (row.high > row.low || center.spread == PublishedSpread::none) continue;
    row.low = inDegrees(center.low);
    row.high = inDegrees(center.high);
  }
  const SimulatedSample simulated{
      valuesOf(insertions,
               [](const analysis::ClinicalInsertion& each) { return inDegrees(each.apical); }),
      valuesOf(insertions,
               [](const analysis::ClinicalInsertion& each) { return each.sharedFriction; })};
  describe(row, simulated.values);
  if (simulated.values.size() < 2) return row;
  const Distance distance = compare(pool, simulated);
  row.tolerance = halfWidth95 * distance.standardError;
  row.power = distance.power(wrongBy_deg);
  row.verdict = verdictOf(distance.isHit());
  row.atMedianFriction = verdictOf(distance.isHitAtMedian());
  row.spread = verdictOf(distance.isSpreadHit());
  row.spreadFactor = distance.interquartile / pool.interquartile;
  row.spreadTolerance = exponential(distance.spreadTolerance);
  accompany(row, published, insertions);
  const bool isLengthMet = (!row.contactsInside || row.contactsInside->isMet) &&
                           (!row.angleAtLength || row.angleAtLength->isMet);
  if (row.verdict == RowVerdict::hit && !isLengthMet) row.note = "hit for another reason";
  return row;
}

ClinicalRow rateRow(const ClinicalRate& rate, const Insertions& insertions)
{
  ClinicalRow row;
  row.quantity = rate.rowName();
  row.unit = "%";
  row.source = rate.source;
  row.confidence = rate.confidence;
  row.patients = rate.of;
  const analysis::Estimate printed = analysis::proportionOf(static_cast<std::size_t>(rate.count),
                                                            static_cast<std::size_t>(rate.of));
  row.published = 100.0 * printed.value;
  row.low = 100.0 * printed.low;
  row.high = 100.0 * printed.high;
  row.runs = static_cast<int>(insertions.size());
  if (insertions.empty()) {
    if (rate.array == "none") row.note = "no such array is inserted for this table";
    return row;
  }
  const int found = static_cast<int>(
      std::count_if(insertions.begin(), insertions.end(),
                    [&](const analysis::ClinicalInsertion& each) { return rate.counts(each); }));
  const double fraction = static_cast<double>(found) / row.runs;
  row.median = row.lowerQuartile = row.upperQuartile = 100.0 * fraction;
  row.inside = row.median >= row.low && row.median <= row.high ? 1.0 : 0.0;
  if (rate.confidence == "low") return row;
  const CountInterval expected = expectedCounts(rate.of, found, row.runs);
  row.verdict = verdictOf(expected.holds(rate.count));
  row.power = expected.power(rate.of, fraction >= 0.5 ? fraction - wrongBy : fraction + wrongBy);
  return row;
}

}  // namespace

Result<std::vector<ClinicalRow>> clinicalRows(const Insertions& insertions)
{
  const auto inVivo = analysis::shippedReference("in-vivo");
  if (!inVivo) return inVivo.error();
  const auto arrays = publishedArrays();
  if (!arrays) return arrays.error();
  const auto rates = clinicalRates();
  if (!rates) return rates.error();

  std::vector<ClinicalRow> rows;
  for (const PublishedArray& array : *arrays)
    rows.push_back(angleRow(array, of(insertions, array.array)));
  for (const ClinicalRate& rate : *rates) rows.push_back(rateRow(rate, of(insertions, rate.array)));
  rows.push_back(
      forceRow("force at the end, all arrays", *inVivo, "end of insertion",
               valuesOf(insertions, [](const auto& each) { return inMillinewtons(each.endForce); }),
               "not counted: how long the hands had rested is not published"));
  rows.push_back(
      forceRow("peak force, all arrays", *inVivo, "peak",
               valuesOf(insertions, [](const auto& each) { return inMillinewtons(each.peak); }),
               "not counted: bounded by the force at which surgeons stop, which is drawn from this "
               "range"));
  Insertions buckled;
  for (const analysis::ClinicalInsertion& each : insertions)
    if (each.end == haptics::InsertionEnd::buckled) buckled.push_back(each);
  rows.push_back(
      forceRow("peak force of buckled insertions", *inVivo, "buckling",
               valuesOf(buckled, [](const auto& each) { return inMillinewtons(each.peak); }),
               "no published value with a known free length was found"));
  return rows;
}

}  // namespace perilymph::validation

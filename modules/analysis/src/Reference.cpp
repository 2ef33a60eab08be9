// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Reference.h"

#include <sstream>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::analysis {

namespace {

constexpr Range forces_N{-5.0, 5.0};

/// The next travel, which must be greater than the previous one.
template <class Printed>
double travelBehind(TomlReader& table, const std::vector<Printed>& before, const char* plural)
{
  const double travel_mm = table.number("travel_mm", {0.0, 60.0});
  const double last_mm = before.empty() ? -1.0 : inMillimeters(meters(before.back().travel));
  if (travel_mm <= last_mm) {
    std::ostringstream sentence;
    sentence << "travel_mm is " << travel_mm << ", not above the point before it (" << last_mm
             << "). Put the " << plural << " in the order of travel.";
    table.refuse("travel_mm", sentence.str());
  }
  return millimeters(travel_mm).si();
}

PrintedForce readPoint(TomlReader& table, const std::vector<PrintedForce>& before)
{
  PrintedForce point;
  point.travel = travelBehind(table, before, "points");
  point.mean = table.number("mean_N", forces_N);
  point.standardDeviation = table.number("sd_N", {0.0, 5.0});
  point.feature = table.text("feature", "");
  point.source = table.text("source");
  return point;
}

PrintedInterval readInterval(TomlReader& table, const std::vector<PrintedInterval>& before)
{
  PrintedInterval interval;
  interval.travel = travelBehind(table, before, "intervals");
  interval.low = table.number("low_N", forces_N);
  interval.high = table.number("high_N", {interval.low, 5.0});
  interval.standardDeviation = table.number("sd_N", {0.0, 5.0});
  interval.source = table.text("source");
  return interval;
}

PrintedDifference readDifference(TomlReader& table, const std::vector<PrintedDifference>& before)
{
  PrintedDifference difference;
  difference.travel = travelBehind(table, before, "differences");
  difference.mean = table.number("mean_N", forces_N);
  if (table.has("ci95_low_N")) {
    difference.low = table.number("ci95_low_N", {-5.0, difference.mean});
    difference.high = table.number("ci95_high_N", {difference.mean, 5.0});
  }
  difference.source = table.text("source");
  return difference;
}

PrintedRange readRange(TomlReader& table)
{
  PrintedRange range;
  range.quantity = table.text("quantity");
  range.low = table.number("low_N", forces_N);
  range.high = table.number("high_N", {range.low, 5.0});
  range.source = table.text("source");
  return range;
}

PrintedValue readValue(TomlReader& table)
{
  PrintedValue value;
  value.quantity = table.text("quantity");
  value.value = table.number("value_N", forces_N);
  value.source = table.text("source");
  return value;
}

}  // namespace

const PrintedForce* Reference::find(const std::string& feature) const
{
  for (const PrintedForce& point : points)
    if (point.feature == feature) return &point;
  return nullptr;
}

const PrintedRange* Reference::findRange(const std::string& quantity) const
{
  for (const PrintedRange& range : ranges)
    if (range.quantity == quantity) return &range;
  return nullptr;
}

const PrintedValue* Reference::findValue(const std::string& quantity) const
{
  for (const PrintedValue& value : values)
    if (value.quantity == quantity) return &value;
  return nullptr;
}

Result<Reference> loadReference(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  Reference reference;
  reference.label = reader->text("label");
  reference.kind = reader->choice(
      "kind", {"experiment", "simulator", "in vivo", "in vitro", "perception"}, "experiment");
  reference.source = reader->text("source");
  reference.insertions = reader->number("insertions", {0.0, 1e6}, 0.0);
  for (TomlReader& table : reader->tables("point"))
    reference.points.push_back(readPoint(table, reference.points));
  for (TomlReader& table : reader->tables("interval"))
    reference.intervals.push_back(readInterval(table, reference.intervals));
  for (TomlReader& table : reader->tables("difference"))
    reference.differences.push_back(readDifference(table, reference.differences));
  for (TomlReader& table : reader->tables("range")) reference.ranges.push_back(readRange(table));
  for (TomlReader& table : reader->tables("value")) reference.values.push_back(readValue(table));
  if (reference.points.empty() && reference.intervals.empty() && reference.differences.empty() &&
      reference.ranges.empty() && reference.values.empty())
    reader->refuse(
        "label",
        "There is no [[point]], [[difference]], [[range]] or [[value]]; a reference needs "
        "at least one [[point]] or its like.");
  if (const auto done = reader->finish(); !done) return done.error();
  return reference;
}

Result<Reference> shippedReference(const std::string& name)
{
  const auto file = findByName("reference", "resources/reference", name);
  if (!file) return file.error();
  return loadReference(*file);
}

Result<Force> forceFeltBySurgeons()
{
  const auto surgeons = shippedReference("surgeons");
  if (!surgeons) return surgeons.error();
  const PrintedValue* const felt = surgeons->findValue("force felt, median");
  if (felt == nullptr)
    return Error{"The reference 'surgeons' has no [[value]] of the quantity 'force felt, median'."};
  return newtons(felt->value);
}

Result<PrintedRange> peaksInPatients()
{
  const auto inVivo = shippedReference("in-vivo");
  if (!inVivo) return inVivo.error();
  const PrintedRange* const peak = inVivo->findRange("peak");
  if (peak == nullptr)
    return Error{"The reference 'in-vivo' has no [[range]] of the quantity 'peak'."};
  return *peak;
}

}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause
#include "prediction/PublishedClinic.h"

#include <algorithm>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::validation {

namespace {

constexpr double interquartileOfNormal = 1.349;  // in standard deviations

std::optional<double> interquartile_deg(const ClinicalAngle& angle)
{
  const double width = inDegrees(angle.high - angle.low);
  switch (angle.spread) {
    case PublishedSpread::interquartile:
      return width;
    case PublishedSpread::deviation:
      return interquartileOfNormal * 0.5 * width;
    case PublishedSpread::range:
      return interquartileOfNormal * width / expectedRange(angle.patients);
    case PublishedSpread::none:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::string ClinicalRate::rowName() const
{
  return quantity + " of " + (array == "all" || array == "none" ? kind + " arrays" : array);
}

bool ClinicalRate::counts(const analysis::ClinicalInsertion& insertion) const
{
  return quantity == "translocation" ? insertion.isTranslocated : isComplete(insertion);
}

Result<std::vector<ClinicalRate>> clinicalRates()
{
  auto reader = TomlReader::open(resource("resources/clinical/rates.toml"));
  if (!reader) return reader.error();
  std::vector<ClinicalRate> rates;
  reader->text("label");
  for (TomlReader& table : reader->tables("rate")) {
    ClinicalRate rate;
    rate.quantity = table.choice("quantity", {"complete insertion", "translocation"});
    rate.array = table.text("array");
    rate.kind = table.text("kind");
    rate.of = static_cast<int>(table.integer("of", 1, 100'000, 1));
    rate.count = static_cast<int>(table.integer("count", 0, rate.of, 0));
    rate.source = table.text("source");
    rate.confidence = table.choice("confidence", {"high", "medium", "low"});
    rates.push_back(rate);
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return rates;
}

std::vector<PublishedSample> PublishedArray::samples() const
{
  std::vector<PublishedSample> all;
  for (const ClinicalAngle& center : centers)
    all.push_back({inDegrees(center.median), interquartile_deg(center), center.patients});
  return all;
}

Result<std::vector<PublishedArray>> publishedArrays()
{
  const auto angles = clinicalAngles();
  if (!angles) return angles.error();
  std::vector<PublishedArray> arrays;
  for (const ClinicalAngle& angle : *angles) {
    const auto there = std::find_if(arrays.begin(), arrays.end(), [&](const PublishedArray& each) {
      return each.array == angle.array;
    });
    if (there != arrays.end())
      there->centers.push_back(angle);
    else
      arrays.push_back({angle.array, {angle}});
  }
  return arrays;
}

bool isComplete(const analysis::ClinicalInsertion& insertion)
{
  if (insertion.contacts.empty()) return insertion.end == haptics::InsertionEnd::finished;
  return std::all_of(insertion.contacts.begin(), insertion.contacts.end(),
                     [](const analysis::ContactPosition& each) { return each.isInserted; });
}

}  // namespace perilymph::validation

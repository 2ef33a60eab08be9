// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PackingRange.h"

#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::analysis {

double PackingRange::median() const { return std::sqrt(low * high); }

Result<PackingRange> loadPackingRange(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  PackingRange range;
  reader->text("label");
  range.low = reader->number("packing_low", {0.001, 2.0});
  range.high = reader->number("packing_high", {range.low, 2.0});
  range.source = reader->text("source");
  range.confidence = reader->choice("confidence", {"high", "medium", "low"}, std::nullopt);
  if (const auto done = reader->finish(); !done) return done.error();
  return range;
}

std::filesystem::path shippedPackingFile() { return resource("resources/clinical/wires.toml"); }

Result<PackingRange> shippedPackingRange() { return loadPackingRange(shippedPackingFile()); }

double drawPacking(const PackingRange& range, std::uint64_t seed, std::uint64_t number)
{
  constexpr std::uint64_t purpose = 209;  // apart from those of surgeons, plans and tapers
  RandomStream random(seed, number, purpose);
  return exponential(random.between(logarithm(range.low), logarithm(range.high)));
}

}  // namespace perilymph::analysis

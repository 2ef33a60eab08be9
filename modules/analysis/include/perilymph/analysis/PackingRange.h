// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How tightly the wires of straight arrays may be packed: drawn alike by plans and by the clinical table.

#include <cstdint>
#include <filesystem>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// The range of c of electrode::wirePacking(), the same for all makers: uniform in its logarithm.
struct PackingRange {
  double low = 0.0, high = 0.0;
  std::string source, confidence;

  /// The value that half of the draws exceed.
  double median() const;
};

/// Reads the range from a TOML file.
Result<PackingRange> loadPackingRange(const std::filesystem::path& file);
/// The shipped file: resources/clinical/wires.toml.
std::filesystem::path shippedPackingFile();
Result<PackingRange> shippedPackingRange();

/// c of item `number` of a seed: the same for all arrays, on every machine, in any order.
double drawPacking(const PackingRange& range, std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Voxels of any number type and byte order, as files other than DICOM hold them.

#include <cstddef>
#include <cstdint>
#include <limits>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytesOf(VoxelType type);

/// How voxels are stored.
struct VoxelCoding {
  VoxelType type = VoxelType::int16;
  bool isBigEndian = false;
  double slope = 1.0, intercept = 0.0;
};

/// Converts voxels to 16 bits as they come: slope times value plus intercept, rounded.
class VoxelConverter {
public:
  explicit VoxelConverter(const VoxelCoding& coding) : coding_(coding) {}

  /// @param to  Where `count` voxels go; null to look at them only.
  void add(const char* bytes, std::size_t count, std::int16_t* to);

  /// Refuses values that are not finite, more than a thousandth beyond 16 bits, and intensities
  /// that span less than 100, which cannot be Hounsfield units. Without a subject.
  Result<void> check() const;

  bool isFinite() const noexcept { return isFinite_; }
  bool spansEnough() const noexcept;
  double smallest() const noexcept { return smallest_; }
  double largest() const noexcept { return largest_; }

private:
  VoxelCoding coding_;
  std::size_t count_ = 0, clipped_ = 0;
  bool isFinite_ = true;
  double smallest_ = std::numeric_limits<double>::infinity(), largest_ = -smallest_;
};

}  // namespace perilymph::imaging

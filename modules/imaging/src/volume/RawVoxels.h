// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Voxels of any number type and byte order, as files other than DICOM hold them.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytesOf(VoxelType type);

/// Reads bytes of a file, which may be gzipped as a whole.
///
/// Refuses files that end before the last byte, and damaged gzip streams.
///
/// @param from  First byte, in what is unpacked.
Result<std::string> readBytes(const std::filesystem::path& file, std::size_t from,
                              std::size_t count, const ReadingHooks& hooks);

/// The same for a file that is gzipped from a byte on, behind a header in plain text.
Result<std::string> readPackedBytes(const std::filesystem::path& file, std::size_t packedFrom,
                                    std::size_t count, const ReadingHooks& hooks);

/// Bytes to 16 bits: slope times value plus intercept, rounded.
///
/// Refuses values that are not finite, more than a thousandth beyond 16 bits, and intensities that
/// span less than 100, which cannot be Hounsfield units.
Result<std::vector<std::int16_t>> toVoxels(const std::string& bytes, VoxelType type,
                                           bool isBigEndian, double slope, double intercept);

}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// NIfTI and NRRD: volumes in one file, with a matrix of their own.

#include <array>
#include <filesystem>
#include <optional>

#include "RawVoxels.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

/// What the header of such a file says.
struct VolumeFile {
  std::string format;  ///< "NIfTI" or "NRRD".
  std::array<int, 3> size{};
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();  ///< Index to LPS [mm].
  VoxelType type = VoxelType::int16;
  bool isBigEndian = false;
  double slope = 1.0, intercept = 0.0;
  std::size_t firstByte = 0;  ///< First byte of the voxels, in what is unpacked.
  /// NRRD packs the voxels alone, behind a header in plain text.
  std::size_t packedFrom = 0;
};

/// Reads a NIfTI-1 header (.nii, .nii.gz): the SForm, else the QForm.
///
/// Refuses files with neither, with more than one volume, in other number types or too large.
Result<VolumeFile> readNiftiHeader(const std::filesystem::path& file);

/// Reads an NRRD header (.nrrd) with its voxels in the same file, raw or gzipped.
///
/// Refuses files without space, directions or origin, and other encodings.
Result<VolumeFile> readNrrdHeader(const std::filesystem::path& file);

/// The header of a file that ends in .nii, .nii.gz or .nrrd; none for another.
std::optional<Result<VolumeFile>> readVolumeHeader(const std::filesystem::path& file);

/// A file as a series of one volume.
CtSeries describeVolume(const VolumeFile& volume);

/// Reads the voxels of a file.
Result<LoadedCt> readVolumeFile(const std::filesystem::path& file, const VolumeFile& volume,
                                const ReadingHooks& hooks);

/// Refuses sizes that are no volume or beyond maxCtVoxels.
Result<Done> checkVolumeSize(const std::filesystem::path& file, const std::array<double, 3>& size);

}  // namespace perilymph::imaging

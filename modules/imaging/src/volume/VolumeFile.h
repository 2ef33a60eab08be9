// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// NIfTI, NRRD and MetaImage: volumes with a matrix of their own.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "../statements/Statements.h"
#include "ByteSource.h"
#include "RawVoxels.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

/// What the header of such a file says, checked against every other statement of the file.
struct VolumeFile {
  std::string format;  ///< "NIfTI", "NRRD" or "MetaImage".
  std::array<int, 3> size{};
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();  ///< Index to LPS [mm].
  VoxelCoding coding;
  std::filesystem::path voxelFile;     ///< Where the voxels are: the file, or one beside it.
  std::size_t from = 0;                ///< First byte of that file which is read,
  Packing packing = Packing::none;     ///< how it is packed from there on,
  std::size_t skipped = 0;             ///< and bytes before the voxels in what is unpacked.
  const StatedTwice* bytes = nullptr;  ///< The pair of header and length of the voxels.
  /// Smallest and largest gray value that the header states.
  std::optional<std::array<double, 2>> grayRange;
  std::vector<Sentence> warnings;  ///< Sentences.
};

/// Reads a NIfTI-1 header (.nii, .nii.gz): the SForm of code 1 or 2, else the QForm, else another SForm.
///
/// Refuses files with neither, with more than one volume, in other number types or too large, and
/// those whose statements differ (statements/VolumePairs.h).
Result<VolumeFile> readNiftiHeader(const std::filesystem::path& file);

/// Reads an NRRD header (.nrrd, .nhdr) with its voxels behind it or in a file of the same folder, raw or
/// gzipped.
///
/// Refuses files without space, directions or origin, other encodings, and statements that differ.
Result<VolumeFile> readNrrdHeader(const std::filesystem::path& file);

/// Reads a MetaImage header (.mha, .mhd) with its voxels behind it or in a file of the same folder, raw
/// or packed by zlib.
///
/// Refuses files without spacing, matrix or offset, of another modality than CT, and statements
/// that differ.
Result<VolumeFile> readMetaHeader(const std::filesystem::path& file);

/// The header of a file by its extension, or of the only volume in a folder without DICOM; none for
/// another path.
std::optional<Result<VolumeFile>> readVolumeHeader(const std::filesystem::path& file);

/// A file as a series of one volume.
CtSeries describeVolume(const VolumeFile& volume);

/// Reads the voxels of a file, inflated and converted as they come. Takes two bytes of memory per
/// voxel; a volume whose intensities span less than 100 over its first 67 million voxels takes none.
///
/// Refuses data shorter or longer than the sizes state.
Result<LoadedCt> readVolumeFile(const std::filesystem::path& file, const VolumeFile& volume,
                                const ReadingHooks& hooks);

/// Bytes of the voxels by sizes and number type.
std::size_t voxelBytesOf(const VolumeFile& volume);

/// Refuses data that cannot have that length, without reading them.
Result<void> checkDataLength(const std::filesystem::path& file, const VolumeFile& volume);

}  // namespace perilymph::imaging

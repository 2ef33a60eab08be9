// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How deep the sequences of a DICOM file are nested. vtk-dicom's parser takes a time that grows with the square of
// the depth, and its stack ends on a deep one.

#include <filesystem>

namespace perilymph::imaging {

/// Depth up to which a file is parsed. Objects of the standard nest five sequences or fewer.
inline constexpr int maxSequenceDepth = 16;

/// True where sequences are nested deeper than `maxSequenceDepth`. Reads the elements before the voxels once, without
/// keeping any; a file that is no DICOM file is not deep.
bool isNestedTooDeep(const std::filesystem::path& file);

}  // namespace perilymph::imaging

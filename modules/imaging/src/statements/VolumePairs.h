// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What NIfTI, NRRD and MetaImage files state twice.

#include <span>

#include "Statements.h"

namespace perilymph::imaging {

/// A thousandth of a voxel size is 0.009 mm of A, a third of what noise alone makes of it. Programs
/// write both statements from one number, so that rounding to 32 bits (1e-7) is all that parts them.
inline constexpr double sizeTolerance = 1e-3;

constexpr StatedTwice voxelBytes(const char* format, const char* data)
{
  return {format,
          "the length of its voxels",
          "its sizes and number type",
          data,
          "bytes",
          0.0,
          0.0,
          Disagreement::refuse,
          "it is cut off or damaged, or its header was changed: copy or export it again"};
}

namespace nifti {
inline constexpr StatedTwice voxelSize =
    refusedPair("NIfTI", "the voxel size", "the SForm", "pixdim", "mm", sizeTolerance);
inline constexpr StatedTwice cornerPlace = refusedPair(
    "NIfTI", "the place of its voxels", "the SForm", "the QForm of the same code", "mm", 0.0, 0.05);
inline constexpr StatedTwice handedness =
    refusedPair("NIfTI", "the handedness of its axes", "the SForm", "the QForm", "", 0.0);
inline constexpr StatedTwice otherQForm{"NIfTI",
                                        "the place of its voxels",
                                        "the SForm",
                                        "the QForm of another code",
                                        "mm",
                                        0.0,
                                        0.05,
                                        Disagreement::warn,
                                        "the SForm is used, so check the sides"};
inline constexpr StatedTwice templateSForm{
    "NIfTI",
    "the place of its voxels",
    "the QForm of code 1 or 2",
    "the SForm of a higher code",
    "mm",
    0.0,
    0.05,
    Disagreement::warn,
    "the QForm, of the scanner's space, is used, so check the sides"};
inline constexpr StatedTwice unusableForm{
    "NIfTI", "whether it has an SForm", "sform_code",       "the matrix", "", 0.0,
    0.0,     Disagreement::warn,        "the QForm is used"};
inline constexpr StatedTwice voxelBits =
    refusedPair("NIfTI", "the bits of a voxel", "datatype", "bitpix", "", 0.0);
inline constexpr StatedTwice grayValues{
    "NIfTI",
    "its gray values",
    "scl_slope",
    "scl_inter",
    "",
    0.0,
    0.0,
    Disagreement::warn,
    "they are read as stored, so check that bone is above 1000"};
inline constexpr StatedTwice bytes = voxelBytes("NIfTI", "its data");
}  // namespace nifti

namespace nrrd {
inline constexpr StatedTwice voxelSize =
    refusedPair("NRRD", "the voxel size", "space directions", "spacings", "mm", sizeTolerance);
inline constexpr StatedTwice extent = refusedPair("NRRD", "the voxel size", "space directions",
                                                  "axis mins and axis maxs", "mm", sizeTolerance);
inline constexpr StatedTwice unit =
    refusedPair("NRRD", "the unit of length", "space units", "units", "", 0.0);
inline constexpr StatedTwice voxelCount =
    refusedPair("NRRD", "the number of its voxels", "sizes", "number", "", 0.0);
inline constexpr StatedTwice dimensions =
    refusedPair("NRRD", "its dimensions in space", "space", "space dimension", "", 0.0);
inline constexpr StatedTwice grayValues{
    "NRRD",
    "its gray values",
    "its data",
    "old min and old max",
    "",
    0.0,
    0.0,
    Disagreement::warn,
    "they are read as stored, so check that bone is above 1000"};
inline constexpr StatedTwice thickness{
    "NRRD",
    "the thickness of its slices",
    "the steps of space directions",
    "thicknesses",
    "mm",
    0.8,
    0.0,
    Disagreement::warn,
    "one of both may be wrong, so check the voxel size in the original series"};
inline constexpr StatedTwice keyValue =
    refusedPair("NRRD", "its geometry", "a field", "a key with a value", "", 0.0);
inline constexpr StatedTwice field =
    refusedPair("NRRD", "one field", "its first line", "a later line", "", 0.0);
inline constexpr StatedTwice bytes = voxelBytes("NRRD", "its data");
}  // namespace nrrd

namespace meta {
inline constexpr StatedTwice voxelSize =
    refusedPair("MetaImage", "the voxel size", "ElementSpacing",
                "ElementSpacing times TransformMatrix", "mm", sizeTolerance);
inline constexpr StatedTwice elementSize = refusedPair(
    "MetaImage", "the voxel size", "ElementSpacing", "ElementSize", "mm", sizeTolerance);
inline constexpr StatedTwice orientation = refusedPair(
    "MetaImage", "where its axes point", "TransformMatrix", "AnatomicalOrientation", "", 0.0);
inline constexpr StatedTwice grayValues{
    "MetaImage",
    "its gray values",
    "its data",
    "ElementMin and ElementMax",
    "",
    0.0,
    0.5,
    Disagreement::warn,
    "they are read as stored, so check that bone is above 1000"};
inline constexpr StatedTwice packedBytes{
    "MetaImage",
    "the length of its packed voxels",
    "its data",
    "CompressedDataSize",
    "bytes",
    0.0,
    0.0,
    Disagreement::refuse,
    "it is cut off or damaged, or its header was changed: copy or export it again"};
inline constexpr StatedTwice field =
    refusedPair("MetaImage", "one field", "its first line", "a later line", "", 0.0);
inline constexpr StatedTwice bytes = voxelBytes("MetaImage", "its data");
}  // namespace meta

/// All of them.
std::span<const StatedTwice* const> volumePairs();

}  // namespace perilymph::imaging

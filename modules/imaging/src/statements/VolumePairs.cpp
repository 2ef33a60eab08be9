// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePairs.h"

namespace perilymph::imaging {

std::span<const StatedTwice* const> volumePairs()
{
  static constexpr const StatedTwice* pairs[] = {
      &nifti::voxelSize,  &nifti::cornerPlace,  &nifti::otherQForm, &nifti::templateSForm,
      &nifti::handedness, &nifti::unusableForm, &nifti::voxelBits,  &nifti::grayValues,
      &nifti::bytes,      &nrrd::voxelSize,     &nrrd::extent,      &nrrd::unit,
      &nrrd::dimensions,  &nrrd::voxelCount,    &nrrd::grayValues,  &nrrd::thickness,
      &nrrd::keyValue,    &nrrd::field,         &nrrd::bytes,       &meta::voxelSize,
      &meta::elementSize, &meta::orientation,   &meta::grayValues,  &meta::packedBytes,
      &meta::field,       &meta::bytes};
  return pairs;
}

}  // namespace perilymph::imaging

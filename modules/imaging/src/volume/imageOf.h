// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A volume's voxels as VTK takes them.

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>

#include <algorithm>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

/// The voxels on a grid of spacing 1 from the origin, unmeasured ones as air. Without a copy where
/// all were measured: the volume must outlive the image, which must only be read.
inline vtkSmartPointer<vtkImageData> imageOf(const ct::CtVolume& volume)
{
  const auto voxels = volume.voxels();
  const auto& size = volume.size();
  const auto count = static_cast<vtkIdType>(voxels.size());
  vtkNew<vtkShortArray> values;
  if (volume.unmeasuredCount() > 0) {
    values->SetNumberOfValues(count);
    std::transform(voxels.begin(), voxels.end(), values->GetPointer(0), ct::asAir);
  } else {
    // VTK only reads them; save = 1 leaves their memory to the volume
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
    values->SetArray(const_cast<std::int16_t*>(voxels.data()), count, 1);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

}  // namespace perilymph::imaging

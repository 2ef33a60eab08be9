// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A volume's voxels as VTK takes them.

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

/// The voxels on a grid of spacing 1 from the origin, without a copy: the volume must outlive the
/// image, which must only be read.
inline vtkSmartPointer<vtkImageData> imageOf(const ct::CtVolume& volume)
{
  const auto voxels = volume.voxels();
  const auto& size = volume.size();
  vtkNew<vtkShortArray> values;
  // VTK only reads them; save = 1 leaves their memory to the volume
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
  values->SetArray(const_cast<std::int16_t*>(voxels.data()), static_cast<vtkIdType>(voxels.size()),
                   1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  image->GetPointData()->SetScalars(values);
  return image;
}

}  // namespace perilymph::imaging

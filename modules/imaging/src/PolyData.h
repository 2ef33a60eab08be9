// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Conversion of surfaces to and from VTK.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// A surface in millimeters, in double precision.
vtkSmartPointer<vtkPolyData> toPolyData(const anatomy::Surface& surface);

/// The triangles of VTK data in millimeters. Other cells are ignored.
anatomy::Surface fromPolyData(vtkPolyData& data);

}  // namespace perilymph::imaging

#pragma once

// Surfaces as VTK wants them, and back.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::imaging {

/// A surface in millimeters, in double precision.
vtkSmartPointer<vtkPolyData> toPolyData(const anatomy::Surface& surface);

/// The triangles of VTK's millimeters. Cells of another kind are left out.
anatomy::Surface fromPolyData(vtkPolyData& data);

}  // namespace perilymph::imaging

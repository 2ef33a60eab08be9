// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/DecimatedSurface.h"

#include <vtkQuadricDecimation.h>

#include <cmath>

#include "PolyData.h"

namespace perilymph::imaging {
namespace {

constexpr Length sampleSpacing = millimeters(0.05);

/// Removes points that no triangle uses.
anatomy::Surface withoutSparePoints(const anatomy::Surface& surface)
{
  anatomy::Surface packed;
  std::vector<int> names(surface.points.size(), -1);
  for (const auto& triangle : surface.triangles) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& name = names[static_cast<std::size_t>(triangle[k])];
      if (name < 0) {
        name = static_cast<int>(packed.points.size());
        packed.points.push_back(surface.points[static_cast<std::size_t>(triangle[k])]);
      }
      corners[k] = name;
    }
    packed.triangles.push_back(corners);
  }
  return packed;
}

}  // namespace

Result<HapticSurface> hapticSurface(const anatomy::ScalaTympani& scala, int maxTriangles)
{
  HapticSurface result;
  result.visualTriangles =
      static_cast<int>(anatomy::wallSurface(scala, maxTriangles).triangles.size());
  const anatomy::Surface reachable = anatomy::wallSurfaceBefore(scala, maxTriangles, hapticEnd);
  const double wanted = std::floor(hapticFraction * result.visualTriangles);

  const auto decimation = vtkSmartPointer<vtkQuadricDecimation>::New();
  decimation->SetInputData(toPolyData(reachable));
  decimation->SetTargetReduction(1.0 - wanted / static_cast<double>(reachable.triangles.size()));
  decimation->Update();
  result.surface = withoutSparePoints(fromPolyData(*decimation->GetOutput()));
  if (result.surface.triangles.empty() ||
      static_cast<double>(result.surface.triangles.size()) > wanted + 2.0)
    return Error{
        "The haptic surface of %1 could not be brought to %2 triangles; it has %3. Use the surface "
        "at full resolution, --surface.",
        scala.name(), static_cast<int>(wanted), result.surface.triangles.size()};
  result.surfaceDistance = anatomy::surfaceDistance(reachable, result.surface, sampleSpacing);
  return result;
}

}  // namespace perilymph::imaging

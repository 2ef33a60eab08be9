// SPDX-License-Identifier: BSD-3-Clause
#include "Backdrop.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::visualization {
namespace {

constexpr int cells = 24;  ///< Along each edge.

double fraction(int i) { return 2.0 * i / cells - 1.0; }

}  // namespace

Backdrop::Backdrop(const SceneColors& palette)
{
  std::vector<Triangle> triangles;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int a = y * (cells + 1) + x;
      const int b = a + cells + 1;
      triangles.push_back({a, a + 1, b});
      triangles.push_back({a + 1, b + 1, b});
    }
  mesh_.shape((cells + 1) * (cells + 1), triangles);
  for (int y = 0, index = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x, ++index) {
      const double away = std::min(1.0, std::hypot(fraction(x), fraction(y)) / 1.15);
      const double light = 0.5 * (1.0 + std::cos(pi * away));
      Rgba color = palette.ground;
      for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<unsigned char>(
            std::lround(color[i] + light * (palette.groundLight[i] - color[i])));
      mesh_.setColor(index, color);
    }
  mesh_.colorsChanged();
  mesh_.actor().GetProperty()->LightingOff();
  mesh_.actor().ForceOpaqueOn();
  mesh_.actor().UseBoundsOff();
}

void Backdrop::place(const ViewFrame& view, const Eigen::Vector3d& center, double width_mm,
                     double height_mm)
{
  for (int y = 0, index = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x, ++index)
      mesh_.point(index) = (center + 0.5 * width_mm * fraction(x) * view.right +
                            0.5 * height_mm * fraction(y) * view.up)
                               .cast<float>();
  mesh_.pointsChanged();
}

}  // namespace perilymph::visualization

// SPDX-License-Identifier: BSD-3-Clause
#include "Tweezers.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>
#include <cmath>

namespace perilymph::visualization {
namespace {

/// A cross-section of a jaw: distance behind the grip, distance from the center, thickness.
struct Station {
  double back_mm, apart_mm, halfThickness_mm, halfHeight_mm;
};

// Slender at the grip, then opening and widening: watchmaker's tweezers.
constexpr Station stations[] = {
    {-0.9, 0.42, 0.06, 0.14}, {-0.6, 0.46, 0.10, 0.20}, {0.0, 0.50, 0.13, 0.28},
    {1.5, 0.62, 0.17, 0.40},  {4.0, 0.95, 0.24, 0.60},  {9.0, 1.75, 0.34, 0.85},
    {18.0, 2.70, 0.45, 1.10}, {30.0, 3.20, 0.50, 1.20},
};
constexpr int stationCount = static_cast<int>(std::size(stations));
constexpr int sides = 12;
/// The hand is off the array's axis, toward the viewer, so that the jaws leave the view free.
constexpr double lift = 0.35;

}  // namespace

Tweezers::Tweezers(double heldAt_mm, const SceneColors& palette) : heldAt_mm_(heldAt_mm)
{
  std::vector<Triangle> triangles;
  for (int i = 0; i + 1 < stationCount; ++i)
    for (int k = 0; k < sides; ++k) {
      const int a = i * sides + k;
      const int b = i * sides + (k + 1) % sides;
      triangles.push_back({a, b, a + sides});
      triangles.push_back({b, b + sides, a + sides});
    }
  // the tip of the jaw is closed by a triangle fan
  for (int k = 1; k + 1 < sides; ++k) triangles.push_back({0, k + 1, k});
  for (Mesh& jaw : jaws_) {
    jaw.shape(stationCount * sides, triangles);
    jaw.paint(palette.steel);
    vtkProperty& look = *jaw.actor().GetProperty();
    look.SetSpecular(0.6);
    look.SetSpecularPower(25.0);
    look.SetDiffuse(0.6);
  }
}

void Tweezers::show(const ArrayPath& path)
{
  const PathPoint held = path.at(heldAt_mm_);
  // Jaws are left and right of the array seen along the modiolus.
  Eigen::Vector3d across = held.along.cross(Eigen::Vector3d::UnitZ());
  if (across.norm() < 1e-6) across = held.inner;
  across.normalize();
  const Eigen::Vector3d high = across.cross(held.along);

  for (std::size_t j = 0; j < jaws_.size(); ++j) {
    const double sign = j == 0 ? 1.0 : -1.0;
    int index = 0;
    for (const Station& station : stations) {
      const double rise = lift * std::max(0.0, station.back_mm);
      const Eigen::Vector3d center = held.place - station.back_mm * held.along + rise * high +
                                     sign * station.apart_mm * across;
      for (int k = 0; k < sides; ++k, ++index) {
        const double angle = 2.0 * pi * k / sides;
        const double x = std::cos(angle), y = std::sin(angle);
        jaws_[j].point(index) =
            (center + station.halfThickness_mm * x * across + station.halfHeight_mm * y * high)
                .cast<float>();
        jaws_[j].normal(index) =
            (x / station.halfThickness_mm * across + y / station.halfHeight_mm * high)
                .normalized()
                .cast<float>();
      }
    }
    jaws_[j].pointsChanged();
  }
}

}  // namespace perilymph::visualization

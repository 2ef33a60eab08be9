// SPDX-License-Identifier: BSD-3-Clause
#include "SoftDots.h"

#include <vtkActor.h>
#include <vtkProperty.h>

#include <array>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::visualization {
namespace {

/// Rings of a dot: fractions of its radius and of its opacity.
constexpr std::array<std::pair<double, double>, 3> rings{{{0.35, 0.82}, {0.7, 0.28}, {1.0, 0.0}}};
constexpr int around = 14;
constexpr int pointsPerDot = 1 + around * static_cast<int>(rings.size());

void addDot(std::vector<Triangle>& triangles, int first)
{
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    triangles.push_back({first, first + 1 + k, first + 1 + next});
    for (int ring = 0; ring + 1 < static_cast<int>(rings.size()); ++ring) {
      const int a = first + 1 + ring * around;
      const int b = a + around;
      triangles.push_back({a + k, b + k, a + next});
      triangles.push_back({a + next, b + k, b + next});
    }
  }
}

}  // namespace

SoftDots::SoftDots()
{
  mesh_.actor().GetProperty()->LightingOff();
  mesh_.actor().ForceTranslucentOn();
  mesh_.actor().UseBoundsOff();
}

void SoftDots::add(const Eigen::Vector3d& place, const Rgba& color, double radius_mm)
{
  dots_.push_back({place, color, radius_mm});
}

void SoftDots::reserveDots()
{
  if (dots_.size() <= capacity_ && dots_.size() + 64 > capacity_) return;
  capacity_ = (dots_.size() + 31) / 32 * 32;  // in steps, so that it rarely changes
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < capacity_; ++i) addDot(triangles, static_cast<int>(i) * pointsPerDot);
  mesh_.shape(static_cast<int>(capacity_) * pointsPerDot, triangles);
}

void SoftDots::build(const ViewFrame& view, double toward_mm)
{
  reserveDots();
  int index = 0;
  const auto put = [&](const Eigen::Vector3d& place, Rgba color, double opacity) {
    color[3] = static_cast<unsigned char>(opacity * color[3]);
    mesh_.point(index) = place.cast<float>();
    mesh_.setColor(index++, color);
  };
  for (const Dot& dot : dots_) {
    const Eigen::Vector3d center = dot.place + toward_mm * view.back;
    put(center, dot.color, 1.0);
    for (const auto& [fraction, opacity] : rings)
      for (int k = 0; k < around; ++k) {
        const double angle = 2.0 * pi * k / around;
        const Eigen::Vector3d radial = std::cos(angle) * view.right + std::sin(angle) * view.up;
        put(center + fraction * dot.radius_mm * radial, dot.color, opacity);
      }
  }
  const int points = mesh_.points();
  while (index < points) put(Eigen::Vector3d::Zero(), Rgba{}, 0.0);
  mesh_.pointsChanged();
  mesh_.colorsChanged();
}

}  // namespace perilymph::visualization

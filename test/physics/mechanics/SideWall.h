// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A wall for one node: bends a rod at its tip only.

#include <span>

#include "perilymph/anatomy/Lumen.h"

namespace perilymph::test {

/// A frictionless wall at y = -gap that faces +y and that only the tip can touch.
class SideWall final : public anatomy::Lumen {
public:
  explicit SideWall(double gap) : gap_(gap) {}
  anatomy::Entry entry() const noexcept override { return {}; }
  anatomy::LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<anatomy::LumenTrack>,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    for (anatomy::WallPoint& wall : walls) wall = {};
    walls.back().distance = points_W.back().y() + gap_;
    walls.back().isNear = walls.back().distance <= reach.back();
    walls.back().normal_W = Eigen::Vector3d::UnitY();
  }
  void addTo(Hash&) const noexcept override {}

private:
  double gap_;
};

}  // namespace perilymph::test

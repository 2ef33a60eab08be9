// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lumens with closed-form solutions: for tests of the mechanics and checks of devices.

#include "perilymph/anatomy/Lumen.h"

namespace perilymph::anatomy {

/// Half space before a flat wall: the opening at the origin, insertion along -z of W (E = W), the
/// wall at z = -depth, facing the opening.
class FlatWall final : public Lumen {
public:
  explicit FlatWall(double depth) : depth_(depth) {}
  Entry entry() const noexcept override { return {}; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;
  void addTo(Hash& hash) const noexcept override;

private:
  double depth_;
};

/// An infinite straight round tube along -z of W, its opening at the origin (E = W).
class StraightTube final : public Lumen {
public:
  explicit StraightTube(double radius) : radius_(radius) {}
  Entry entry() const noexcept override { return {}; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;
  void addTo(Hash& hash) const noexcept override;

private:
  double radius_;
};

/// A straight round tube that joins a toroidal one: the straight part has length `lead` along -z
/// from the origin; the circle has radius `bend` in the x-z plane, curves toward -x and has its
/// center at (-bend, 0, -lead). Both have section radius `radius`. Angles are counted along the
/// circle.
class CircularDuct final : public Lumen {
public:
  CircularDuct(double radius, double bend, double lead) : radius_(radius), bend_(bend), lead_(lead)
  {
  }
  Entry entry() const noexcept override { return {}; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;
  void addTo(Hash& hash) const noexcept override;

private:
  double radius_, bend_, lead_;
};

}  // namespace perilymph::anatomy

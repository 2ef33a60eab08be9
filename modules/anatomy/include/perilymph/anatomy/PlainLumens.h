#pragma once

// Scenes whose answers are known in closed form: for tests of the mechanics and checks of devices.

#include "perilymph/anatomy/Lumen.h"

namespace perilymph::anatomy {

/// Half space behind a flat wall: the opening at the origin, the array enters along -z of W (E =
/// W), the wall stands at z = -depth and faces the opening.
class FlatWall final : public Lumen {
public:
  explicit FlatWall(double depth) : depth_(depth) {}
  Entry entry() const noexcept override { return {}; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;

private:
  double depth_;
};

/// A straight round tube along -z of W, its opening at the origin (E = W), endless.
class StraightTube final : public Lumen {
public:
  explicit StraightTube(double radius) : radius_(radius) {}
  Entry entry() const noexcept override { return {}; }
  LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;

private:
  double radius_;
};

/// A straight round tube that goes over into a ring-shaped one: the straight part of length `lead`
/// along -z from the origin, then a circle of radius `bend` in the x-z plane, curving toward -x,
/// around (-bend, 0, -lead). Both have the section radius `radius`. Angles count along the circle.
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

private:
  double radius_, bend_, lead_;
};

}  // namespace perilymph::anatomy

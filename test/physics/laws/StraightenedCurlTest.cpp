// SPDX-License-Identifier: BSD-3-Clause

// Energy of a straightened curl: a rod of constant curvature kappa stores EI kappa^2 / 2 per length
// when a tube holds it straight.

#include <gtest/gtest.h>

#include <cmath>

#include "../mechanics/TestRod.h"
#include "perilymph/anatomy/Lumen.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// A straight tube along -z that flares behind its end.
class Trumpet final : public anatomy::Lumen {
public:
  Trumpet(double radius, double length) : radius_(radius), length_(length) {}
  anatomy::Entry entry() const noexcept override { return {}; }
  anatomy::LumenTrack startTrack() const noexcept override { return {}; }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<anatomy::LumenTrack>,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    for (std::size_t i = 0; i < points_W.size(); ++i) walls[i] = wallAt(points_W[i], reach[i]);
  }
  void addTo(Hash&) const noexcept override {}

private:
  static constexpr double flare = 2e-3;  // [m] radius of the trumpet's bend, sharper than the curl

  /// D = R(z) - r with its exact gradient, so that the wall is conservative.
  anatomy::WallPoint wallAt(const Eigen::Vector3d& point, double reach) const noexcept
  {
    anatomy::WallPoint wall;
    const double r = std::hypot(point.x(), point.y());
    const double behind = std::max(-point.z() - length_, 0.0);
    wall.distance = radius_ + 0.5 * behind * behind / flare - r;
    wall.isNear = point.z() <= 0.0 && behind < 0.5 * flare && r > 0.0 && wall.distance < reach;
    if (!wall.isNear) return wall;
    wall.normal_W = {-point.x() / r, -point.y() / r, -behind / flare};
    const Eigen::Vector3d around(-point.y() / r, point.x() / r, 0.0);
    wall.shapeOperator_W = (1.0 / r) * around * around.transpose();
    return wall;
  }

  double radius_, length_;
};

/// A curled rod held straight in a tube, its tip 1 mm beyond the far end.
struct Sleeve {
  static constexpr double length = 10e-3;  // of the tube [m]
  static RodSpec spec()
  {
    RodSpec spec;
    spec.bending = 1e-5;
    spec.restCurvature = 1.0 / 8e-3;
    spec.startInside = length - 2e-3;
    spec.wallStiffness = 1e4;
    spec.nodes = 201;
    return spec;
  }
  Sleeve() : rod(std::make_shared<Trumpet>(spec().radius + 1e-6, length), spec())
  {
    rod.move({0.0, 0.0, -3e-3}, 2e-3, 0.5);
  }
  /// Moves in (or out) and returns the work of the hand [J].
  double workOver(double distance)
  {
    constexpr int steps = 1000;
    double work = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double before = rod.readings().axialForce;
      rod.move({0.0, 0.0, -distance / steps}, 2e-3);
      work += 0.5 * (before + rod.readings().axialForce) * distance / steps;
    }
    return work;
  }
  TestRod rod;
};

/// EI kappa^2 / 2 [J/m]
double storedPerLength()
{
  const RodSpec spec = Sleeve::spec();
  return 0.5 * spec.bending * spec.restCurvature * spec.restCurvature;
}

TEST(StraightenedCurl, GivesItsEnergyToTheHandAsItLeavesTheTubeAndTakesItBack)
{
  Sleeve sleeve;
  constexpr double distance = 4e-3;
  const double stored = storedPerLength() * distance;
  const double out = sleeve.workOver(distance);
  EXPECT_NEAR(out, -stored, test::tolerance(0.01, "nodes 0.1 mm apart") * stored);
  const double in = sleeve.workOver(-distance);
  EXPECT_NEAR(in, stored, test::tolerance(0.01, "nodes 0.1 mm apart") * stored);
  EXPECT_GT(out + in, 0.0);  // losses are supplied by the hand
}

}  // namespace
}  // namespace perilymph

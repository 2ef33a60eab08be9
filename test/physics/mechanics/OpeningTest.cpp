// SPDX-License-Identifier: BSD-3-Clause

// The opening: its rim touches the array from outside, and ribs on the array touch it.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// A rod in a hole; the lumen behind it is too wide to touch.
RodSpec inHole(double holeRadius, double startInside)
{
  RodSpec spec;
  spec.bending = 1e-5;
  spec.startInside = startInside;
  spec.opening = mechanics::cochleostomy(meters(2.0 * holeRadius));
  spec.wallStiffness = 1e4;
  return spec;
}

std::shared_ptr<const anatomy::Lumen> wideTube()
{
  return std::make_shared<anatomy::StraightTube>(5e-3);
}

/// A cantilever from the middle of the first link, in the tweezers, to the rim: side load on the
/// rim when the tweezers are `offset` beside the middle of the hole.
struct SideLoad {
  double free;       ///< Length between tweezers and rim [m].
  double stiffness;  ///< 3 EI / L^3 [N/m]
  double force;      ///< [N]
  double energy;     ///< In the bend and in the rim [J].
};

SideLoad sideLoad(const RodSpec& spec, double depth, double offset)
{
  SideLoad load{};
  load.free = spec.length - depth - 0.5 * spec.length / (spec.nodes - 1);
  load.stiffness = 3.0 * spec.bending / std::pow(load.free, 3);
  const double slack = 0.5 * spec.opening->width.si() - spec.radius + 1e-6;  // half the onset
  load.force = (offset - slack) / (1.0 / load.stiffness + 1.0 / spec.wallStiffness);
  load.energy = 0.5 * load.force * (offset - slack);
  return load;
}

TEST(RimOfTheOpening, HoldsASideLoadAsTheEndOfACantileverWhereverTheNodesAre)
{
  RodSpec spec = inHole(0.27e-3, 8e-3);
  spec.nodes = 41;  // 0.5 mm apart: 1.2 mm of travel take several nodes across the plane
  constexpr double offset = 0.2e-3;
  TestRod rod(wideTube(), spec);
  rod.move({offset, 0.0, 0.0}, 1e-3, 0.2);
  for (int i = 0; i < 120; ++i) {
    rod.move({0.0, 0.0, -0.01e-3}, 2e-3);
    const SideLoad expected = sideLoad(spec, 8e-3 + 0.01e-3 * (i + 1), offset);
    ASSERT_NEAR(rod.readings().rimForce, expected.force,
                test::tolerance(0.02, "chain of links") * expected.force)
        << i;
  }
}

TEST(RimOfTheOpening, TakesTheEnergyOfTheBendFromTheHandAndGivesItBack)
{
  const RodSpec spec = inHole(0.27e-3, 8e-3);
  constexpr double offset = 0.2e-3;
  TestRod rod(wideTube(), spec);
  rod.move({offset, 0.0, 0.0}, 1e-3, 0.2);
  const auto travel = [&](double direction) {
    double work = 0.0;
    for (int i = 0; i < 400; ++i) {
      const double before = rod.readings().axialForce;
      rod.move({0.0, 0.0, -direction * 0.01e-3}, 2e-3);
      work += 0.5 * (before + rod.readings().axialForce) * direction * 0.01e-3;
    }
    return work;
  };
  const double in = travel(1.0);
  const double back = travel(-1.0);
  const double stored = sideLoad(spec, 12e-3, offset).energy - sideLoad(spec, 8e-3, offset).energy;
  EXPECT_NEAR(in, stored, test::tolerance(0.03, "chain of links") * stored);
  // nothing is dissipated but the perilymph's drag, 0.05 N.s/m2 on the rod's length, 4 mm each way
  const double drag = 0.05 * spec.length * 2e-3 * 8e-3;
  EXPECT_NEAR(in + back, drag, test::tolerance(0.003, "damping of the rod") * stored);
}

TEST(RimOfTheOpening, RubsWithCoulombsForce)
{
  RodSpec spec = inHole(0.27e-3, 8e-3);
  spec.friction = 0.2;
  constexpr double offset = 0.2e-3;
  TestRod rod(wideTube(), spec);
  rod.move({offset, 0.0, 0.0}, 1e-3, 0.2);
  rod.move({0.0, 0.0, -1.1e-3}, 2e-3);
  rod.move({0.0, 0.0, 0.1e-3}, 2e-3);
  const double out = rod.readings().axialForce;
  rod.move({0.0, 0.0, -0.1e-3}, 2e-3);
  const double in = rod.readings().axialForce;
  // pushing and pulling forces at the same position differ by twice the friction
  const double expected = 2.0 * spec.friction * sideLoad(spec, 9.1e-3, offset).force;
  EXPECT_NEAR(in - out, expected, test::tolerance(0.03, "friction bends the rod") * expected);
}

TEST(RimOfTheOpening, PushesAlongTheNormalOfItsEllipse)
{
  RodSpec spec = inHole(0.5e-3, 10e-3);
  spec.opening = mechanics::roundWindow();
  const double a = 0.5 * spec.opening->width.si(), b = 0.5 * spec.opening->height.si();
  for (const double angle : {0.0, 0.4, 0.9, 1.5, 2.5, 4.0, 5.5}) {
    TestRod rod(wideTube(), spec);
    rod.move({1.2e-3 * std::cos(angle), 1.2e-3 * std::sin(angle), 0.0}, 2e-3, 0.2);
    ASSERT_GT(rod.readings().rimForce, 1e-3);
    // intersection of the center line with the plane, from the two adjacent nodes
    const auto& x = rod.state().position_W;
    std::size_t i = 0;
    while (x[i + 1].z() > 0.0) ++i;
    const Eigen::Vector3d at = x[i] + x[i].z() / (x[i].z() - x[i + 1].z()) * (x[i + 1] - x[i]);
    // the nearest point of the ellipse, by search
    double best = 1.0, place = 0.0;
    for (int k = 0; k < 20000; ++k) {
      const double t = 2.0 * pi * k / 20000;
      const double distance = std::hypot(a * std::cos(t) - at.x(), b * std::sin(t) - at.y());
      if (distance < best) best = distance, place = t;
    }
    const Eigen::Vector2d normal =
        Eigen::Vector2d(std::cos(place) / a, std::sin(place) / b).normalized();
    const Eigen::Vector2d push = -rod.state().rim.force_W.head<2>().normalized();
    EXPECT_NEAR(push.dot(normal), 1.0, test::tolerance(2e-5, "curve between nodes")) << angle;
  }
}

TEST(RimOfTheOpening, StopsATipThatMissesTheHole)
{
  RodSpec spec = inHole(0.3e-3, -1e-3);
  spec.bending = 1e-4;
  TestRod rod(wideTube(), spec);
  rod.move({1e-3, 0.0, 0.0}, 1e-3);
  rod.move({0.0, 0.0, -0.68e-3}, 2e-3);
  const double top = spec.radius + spec.opening->edgeRadius.si();
  const double overlap = rod.readings().rimForce / spec.wallStiffness;
  EXPECT_GT(rod.readings().axialForce, 0.1);
  EXPECT_NEAR(rod.state().position_W.back().z(), top - overlap, test::tolerance(2e-6, "onset"));
}

TEST(RimOfTheOpening, LeavesAnArrayAloneThatPassesItsMiddle)
{
  const RodSpec spec = inHole(0.3e-3, -1e-3);
  TestRod rod(wideTube(), spec);
  for (int i = 0; i < 500; ++i) {
    rod.move({0.0, 0.0, -0.02e-3}, 2e-3);
    ASSERT_EQ(rod.readings().rimForce, 0.0);
    ASSERT_LT(std::fabs(rod.readings().axialForce), 5e-6);  // drag
  }
}

/// A stiff rod in the center of a hole that is narrower than its rib.
struct Ribbed {
  Ribbed() : rod(wideTube(), spec()) {}
  static RodSpec spec()
  {
    RodSpec spec = inHole(0.28e-3, 8e-3);
    spec.bending = 1e-4;
    spec.ribHeight = height;
    spec.ribLength = 2.0 * (reach - spec.opening->edgeRadius.si());  // the rim's radius adds to it
    spec.ribsFromTip = {millimeters(9)};
    return spec;
  }
  /// Overlap of the rib with the hole when its middle is x before the plane.
  static double overlap(double x)
  {
    const double q = x / reach;
    return q * q < 1.0 ? 0.25e-3 + height * std::pow(1.0 - q * q, 2) - 0.28e-3 : 0.0;
  }
  static constexpr double height = 0.06e-3, reach = 0.3e-3;
  TestRod rod;
};

TEST(MarkerRib, ResistsByTheSlopeOfItsFlank)
{
  Ribbed ribbed;
  double maximum = 0.0;
  for (int i = 0; i < 1000; ++i) {
    ribbed.rod.move({0.0, 0.0, -0.001e-3}, 2e-3);
    maximum = std::max(maximum, ribbed.rod.readings().axialForce);
  }
  // pressed on both sides by k (overlap - half the onset) along the radius; along the array by that
  // times the slope of the flank
  double expected = 0.0;
  for (double x = 0.0; x < Ribbed::reach; x += 1e-7) {
    const double overlap = std::max(Ribbed::overlap(x) - 1e-6, 0.0);
    const double slope = (Ribbed::overlap(x - 1e-7) - Ribbed::overlap(x)) / 1e-7;
    expected = std::max(expected, 2.0 * 1e4 * overlap * slope);
  }
  EXPECT_NEAR(maximum, expected, test::tolerance(0.01, "steps of 1 um") * expected);
}

TEST(MarkerRib, TakesTheEnergyOfPressingItInAndGivesItBack)
{
  Ribbed ribbed;
  const auto workOver = [&](int steps) {
    double work = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double before = ribbed.rod.readings().axialForce;
      ribbed.rod.move({0.0, 0.0, -0.001e-3}, 2e-3);
      work += 0.5 * (before + ribbed.rod.readings().axialForce) * 0.001e-3;
    }
    return work;
  };
  const double toTheCrest = workOver(1000);
  const double afterIt = workOver(500);
  // both sides, k (p^2 - p onset) / 2 each
  const double p = Ribbed::overlap(0.0);
  const double stored = 2.0 * 0.5 * 1e4 * (p * p - p * 2e-6);
  EXPECT_NEAR(toTheCrest, stored, test::tolerance(0.02, "onset, damping") * stored);
  EXPECT_NEAR(afterIt, -stored, test::tolerance(0.02, "onset, damping") * stored);
}

TEST(MarkerRib, NarrowerThanTheHolePassesWithoutForce)
{
  RodSpec spec = Ribbed::spec();
  spec.ribHeight = 0.02e-3;
  TestRod rod(wideTube(), spec);
  for (int i = 0; i < 100; ++i) {
    rod.move({0.0, 0.0, -0.02e-3}, 2e-3);
    ASSERT_EQ(rod.readings().rimForce, 0.0);
  }
}

}  // namespace
}  // namespace perilymph

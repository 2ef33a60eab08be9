// SPDX-License-Identifier: BSD-3-Clause

// Dry friction on a flat wall.

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

/// A short stiff rod whose tip is pressed onto a flat wall: a stylus.
struct Stylus {
  explicit Stylus(double friction)
      : rod(std::make_shared<anatomy::FlatWall>(0.3e-3 + 0.25e-3), spec(friction))
  {
    rod.move({0.0, 0.0, -0.32e-3}, 1e-3, 0.2);
  }
  static RodSpec spec(double friction)
  {
    RodSpec s;
    s.length = 5e-3;
    s.bending = 1e-4;
    s.friction = friction;
    s.wallStiffness = 1e4;
    s.nodes = 21;
    return s;
  }
  double normal() { return rod.state().normalForce.back(); }
  double friction() { return -rod.state().wallForce_W.back().x(); }
  TestRod rod;
};

TEST(TipOnFlatWall, IsHeldByStiffnessTimesPenetration)
{
  Stylus stylus(0.0);
  const double penetration = 0.25e-3 - (stylus.rod.state().position_W.back().z() + 0.55e-3);
  // linear beyond the onset of 2 um, half of which counts
  EXPECT_NEAR(stylus.normal(), 1e4 * (penetration - 1e-6), test::tolerance(1e-5, "solver"));
  EXPECT_NEAR(stylus.normal(), stylus.rod.readings().axialForce, test::tolerance(1e-5, "solver"));
}

TEST(TipOnFlatWall, SlidesWithCoulombsForce)
{
  Stylus stylus(0.2);
  stylus.rod.move({1e-3, 0.0, 0.0}, 2e-3);
  EXPECT_NEAR(stylus.friction(), 0.2 * stylus.normal(), test::tolerance(1e-4, "solver"));
}

TEST(TipOnFlatWall, NeverExceedsCoulombsForce)
{
  Stylus stylus(0.2);
  for (int i = 0; i < 400; ++i) {
    const double x = 0.3e-3 * std::sin(0.05 * i) - 0.3e-3 * std::sin(0.05 * (i - 1));
    stylus.rod.move({x, 0.5 * x, 0.0}, 1.0);
    const Eigen::Vector3d force = stylus.rod.state().wallForce_W.back();
    // the pressure that bounds it is expected, and renewed beyond this error
    ASSERT_LE(std::hypot(force.x(), force.y()),
              0.2 * stylus.normal() + mechanics::SolverParameters{}.maxLag);
  }
}

TEST(TipOnFlatWall, SticksUntilTheStartingForce)
{
  Stylus stylus(0.2);
  stylus.rod.changeable().parts.friction = {0.3, 0.1, 0.05, millimetersPerSecond(0.1)};
  double maximum = 0.0;
  for (int i = 0; i < 300; ++i) {
    stylus.rod.move({2e-6, 0.0, 0.0}, 2e-3);
    maximum = std::max(maximum, stylus.friction() / stylus.normal());
  }
  EXPECT_NEAR(maximum, 0.3, test::tolerance(0.04, "one step of the spring"));
  // at 2 mm/s, far above the Stribeck speed, it slides with the kinetic coefficient
  EXPECT_NEAR(stylus.friction() / stylus.normal(), 0.1, test::tolerance(0.002, "Stribeck tail"));
}

}  // namespace
}  // namespace perilymph

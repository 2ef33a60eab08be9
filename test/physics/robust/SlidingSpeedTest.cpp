// SPDX-License-Identifier: BSD-3-Clause

// A stylus drawn over a flat wall whose friction depends on the speed.

#include <gtest/gtest.h>

#include "../mechanics/TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

/// Friction over normal force at the end of a stroke at a speed [m/s]. The stylus is short and
/// pressed lightly, so that its tip goes as fast as its base and does not spring ahead.
double frictionAt(double speed, const mechanics::FrictionLaw& law)
{
  test::RodSpec spec;
  spec.length = 3e-3;
  spec.bending = 1e-4;
  spec.wallStiffness = 1e4;
  spec.nodes = 21;
  test::TestRod rod(std::make_shared<anatomy::FlatWall>(0.3e-3 + 0.25e-3), spec);
  rod.changeable().parts.friction = law;
  rod.move({0.0, 0.0, -0.306e-3}, 1e-3, 0.2);
  rod.move({0.2e-3, 0.0, 0.0}, speed);
  return -rod.state().wallForce_W.back().x() / rod.state().normalForce.back();
}

TEST(StylusOnFlatWall, IsHeldBackAsMeasuredAtEachSpeed)
{
  mechanics::FrictionLaw law{0.24, 0.24, 0.1, millimetersPerSecond(0.1), {}};
  law.bySpeed = {{millimetersPerSecond(0.1), millimetersPerSecond(1.5), millimetersPerSecond(2.0)},
                 {0.24, 0.59, 0.45}};
  EXPECT_NEAR(frictionAt(0.1e-3, law), 0.24, test::tolerance(0.002, "the tip's own speed"));
  EXPECT_NEAR(frictionAt(1.5e-3, law), 0.59, test::tolerance(0.01, "the tip's own speed"));
  EXPECT_NEAR(frictionAt(2.0e-3, law), 0.45, test::tolerance(0.01, "the tip's own speed"));
}

}  // namespace
}  // namespace perilymph

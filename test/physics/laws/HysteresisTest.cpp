// SPDX-License-Identifier: BSD-3-Clause

// The work dissipated by dry friction in a closed loop: 2 mu N times the distance slid each way.

#include <gtest/gtest.h>

#include <cmath>

#include "../mechanics/TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

constexpr double friction = 0.2;
constexpr double stroke = 1e-3;     // [m]
constexpr double pressed = 0.1e-3;  // [m] of the tip into the wall

RodSpec stylus()
{
  RodSpec spec;
  spec.length = 5e-3;
  spec.bending = 1e-5;
  spec.friction = friction;
  spec.wallStiffness = 1e3;
  spec.nodes = 41;
  return spec;
}

/// The tip of an upright stylus on a flat wall, moved back and forth until the loops are periodic.
struct Loop {
  explicit Loop(double distance)
      : rod(std::make_shared<anatomy::FlatWall>(0.3e-3 + stylus().radius), stylus())
  {
    rod.move({0.0, 0.0, -(0.3e-3 + pressed)}, 1e-3, 0.2);
    sweep(distance);
    sweep(-distance);
    lost = sweep(distance) + sweep(-distance);
  }

  /// Work of the hand over a displacement [J].
  double sweep(double distance)
  {
    constexpr int steps = 1000;
    double work = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double before = rod.readings().handForce_W.x();
      rod.move({distance / steps, 0.0, 0.0}, 1e-3);
      work -= 0.5 * (before + rod.readings().handForce_W.x()) * distance / steps;
    }
    return work;
  }

  TestRod rod;
  double lost = 0.0;  ///< Work of the hand per loop [J].
};

/// Displacement of the base before the tip slides in the opposite direction: both springs reverse.
///
/// One is the wall's own, the other a cantilever that also carries the normal force N: its tip
/// deflects by 3 (tan u - u) / u^3 times L^3 / (3 EI), u = L sqrt(N / EI) (Timoshenko and Gere).
double turningOver(double normal)
{
  const RodSpec spec = stylus();
  // the tweezers hold the first link: it bends from that link's middle on
  const double bent = spec.length - 0.5 * spec.length / (spec.nodes - 1);
  const double u = bent * std::sqrt(normal / spec.bending);
  const double yielding = std::pow(bent / u, 3) * (std::tan(u) - u) / spec.bending;
  return 2.0 * friction * normal * (yielding + 1.0 / spec.wallStiffness);
}

TEST(FrictionLoop, LosesTwiceTheFrictionForceTimesTheDistanceSlid)
{
  for (const double distance : {0.5 * stroke, stroke}) {
    Loop loop(distance);
    const double normal = loop.rod.state().normalForce.back();
    const double slid = distance - turningOver(normal);
    ASSERT_GT(slid, 0.3 * distance);
    const double expected = 2.0 * friction * normal * slid;
    EXPECT_NEAR(loop.lost, expected, test::tolerance(0.01, "drag, chain of links") * expected)
        << distance;
  }
}

TEST(FrictionLoop, LosesNothingWhereNothingSlides)
{
  Loop probe(stroke);
  const double normal = probe.rod.state().normalForce.back();
  const double distance = 0.45 * turningOver(normal);
  Loop loop(distance);
  EXPECT_NEAR(loop.lost, 0.0,
              test::tolerance(0.01, "drag, damping") * friction * normal * distance);
}

}  // namespace
}  // namespace perilymph

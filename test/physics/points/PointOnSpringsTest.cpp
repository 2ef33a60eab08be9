// SPDX-License-Identifier: BSD-3-Clause

// One point of the published set against closed forms: its spring and damper, the springs in a row
// down to the wall, the three coefficients of friction, and the friction added at the hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/advance.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

constexpr double length = 22e-3;

/// Two points, of which the tip alone is inside, beside a flat wall at x = 1 mm: a point of radius
/// 0.25 mm touches it at x = 0.75 mm. E is W.
struct TipBesideAWall {
  explicit TipBesideAWall(const FrictionLaw& friction, double startInside = 2e-3)
      : model(InsertionModel::build(parts(friction, startInside))), state(*model)
  {
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    drive.handPosition_W = model->startBase_W;
  }
  static ModelParts parts(const FrictionLaw& friction, double startInside)
  {
    ModelParts parts;
    parts.kind = ModelKind::points;
    parts.nodes = 2;
    parts.friction = friction;
    parts.lumen = std::make_shared<anatomy::StraightTube>(1e-3);
    parts.array.length = meters(length);
    parts.array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
    parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-6)}};
    parts.array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
    parts.startInside = meters(startInside);
    anatomy::Surface wall;
    wall.points = {{1e-3, -20e-3, 1e-3}, {1e-3, 20e-3, 1e-3}, {1e-3, 0.0, -40e-3}};
    wall.triangles = {{0, 2, 1}};
    parts.hapticSurface = std::make_shared<anatomy::Surface>(wall);
    return parts;
  }
  /// Moves the hand by `motion_W` at `speed` [m/s], then waits.
  void move(const Vector3d& motion_W, double speed, int rest = 0)
  {
    const int ticks = static_cast<int>(std::ceil(motion_W.norm() / (speed * model->timeStep)));
    const Vector3d from = drive.handPosition_W;
    for (int i = 1; i <= ticks + rest; ++i) {
      drive.handPosition_W = from + std::min(1.0, static_cast<double>(i) / ticks) * motion_W;
      advance(*model, state, drive);
      maximum = std::max(maximum, state.readings.axialForce);
    }
  }
  double normal() const { return state.normalForce.back(); }

  std::shared_ptr<const InsertionModel> model;
  InsertionState state;
  Drive drive;
  double maximum = -1.0;  ///< Greatest axial force seen [N].
};

const FrictionLaw smooth{0.0, 0.0, 0.0, millimetersPerSecond(0.1)};

TEST(FreePoint, SwingsBackLikeAMassOnASpringAndDamper)
{
  TipBesideAWall scene(smooth);
  ModelParts parts = scene.model->parts;
  parts.timeStep = milliseconds(0.1);
  parts.nodes = 12;
  const auto model = InsertionModel::build(parts);
  InsertionState state(*model);
  // m x'' + c x' + k x = 0 with the twelfth part of 17.8943 g, 1 N.s/m and 350 N/m
  const double mass = 0.0178943 / 12;
  const double decay = 1.0 / (2.0 * mass);
  const double swing = std::sqrt(350.0 / mass - decay * decay);
  const double start = 0.1e-3;
  state.position_W[0].y() += start;  // at the tweezers, where it turns nothing
  double greatest = 0.0;
  for (int i = 1; i <= 200; ++i) {
    advance(*model, state, scene.drive);
    const double t = 1e-4 * i;
    const double expected =
        start * std::exp(-decay * t) * (std::cos(swing * t) + decay / swing * std::sin(swing * t));
    greatest = std::max(greatest, std::fabs(state.position_W[0].y() - expected));
  }
  EXPECT_LT(greatest, 0.03 * start);  // one step of 0.1 ms is a twentieth of its period over 2 pi
}

TEST(PressedTip, PushesBackThroughItsSpringsInARow)
{
  // point to carrier, point to wall, carrier to tweezers at the end of its arm
  const double perForce = 1.0 / 350.0 + 1.0 / 441.0 + length * length / 0.2;
  for (const double beyond : {0.1e-3, 0.5e-3, 1.0e-3}) {
    TipBesideAWall scene(smooth);
    scene.move({0.75e-3 + beyond, 0.0, 0.0}, 2e-3, 500);
    const double expected = beyond / perForce;
    EXPECT_NEAR(scene.normal(), expected, 0.01 * expected) << beyond;
    EXPECT_NEAR(scene.state.readings.handForce_W.x(), -expected, 0.01 * expected) << beyond;
    EXPECT_NEAR(scene.state.readings.handTorque_W.norm(), expected * length,
                0.02 * expected * length);
  }
}

TEST(PressedTip, LetsGoAsSoonAsItsGoalIsFree)
{
  TipBesideAWall scene({});
  scene.move({1.2e-3, 0.0, 0.0}, 2e-3, 100);
  ASSERT_GT(scene.normal(), 0.0);
  // the published turning spring is hardly damped: it takes seconds to come to rest
  scene.move({-1.2e-3, 0.0, 0.0}, 2e-3, 5000);
  EXPECT_EQ(scene.state.readings.contacts, 0);
  EXPECT_LT(scene.state.readings.handForce_W.norm(), 1e-6);
}

TEST(SlidingTip, IsFeltTwiceByTheHandAsThePublishedAlgorithmAddsFriction)
{
  // The surface drags with dynamic x normal; the algorithm adds dynamic x |F_x| once more.
  TipBesideAWall scene({});
  scene.move({1.25e-3, 0.0, 0.0}, 2e-3, 300);
  const double normal = scene.normal();
  scene.move({0.0, 0.0, -3e-3}, 0.5e-3);
  EXPECT_TRUE(scene.state.isSliding.back());
  EXPECT_NEAR(scene.state.readings.axialForce, 2.0 * 0.0395 * normal, 0.02 * 0.0395 * normal);
}

TEST(SlidingTip, StartsOnlyAboveTheStartingCoefficient)
{
  TipBesideAWall scene({});
  scene.move({1.25e-3, 0.0, 0.0}, 2e-3, 300);
  const double normal = scene.normal();
  scene.move({0.0, 0.0, -0.5e-3}, 0.1e-3);
  // what the hand meets at most: starting by the surface, dynamic by the algorithm
  EXPECT_NEAR(scene.maximum, (0.0605 + 0.0395) * normal, 0.03 * 0.1 * normal);
}

TEST(WithdrawnTip, HasItsFrictionTakenOff)
{
  TipBesideAWall scene({});
  scene.move({1.25e-3, 0.0, 0.0}, 2e-3, 300);
  scene.move({0.0, 0.0, -2e-3}, 0.5e-3);
  const double normal = scene.normal();
  scene.move({0.0, 0.0, 1e-3}, 0.5e-3);
  EXPECT_NEAR(scene.state.readings.axialForce, -2.0 * 0.0395 * normal, 0.02 * 0.0395 * normal);
}

TEST(FreeCarrier, HangsOnASpringHandWithItsWholeMass)
{
  // one degree of freedom to first order: 441 N/m hold 17.9 g through the stiffer points
  TipBesideAWall scene(smooth);
  scene.drive.coupling = Coupling::spring;
  scene.drive.couplingStiffness = 441.0;
  scene.drive.handPosition_W.y() += 0.1e-3;
  // Two points in a row with the hand: 441 and 2 x 350 N/m; half a period is the first overshoot.
  const double stiffness = 1.0 / (1.0 / 441.0 + 1.0 / 700.0);
  const double half = std::acos(-1.0) * std::sqrt(0.0178943 / stiffness);
  int reversal = 0;
  double before = 0.0;
  for (int i = 1; i < 200 && reversal == 0; ++i) {
    advance(*scene.model, scene.state, scene.drive);
    const double at = scene.state.position_W[0].y() + scene.state.position_W[1].y();
    if (at < before) reversal = i - 1;
    before = at;
  }
  EXPECT_NEAR(reversal * 1e-3, half, 0.15 * half);
}

}  // namespace
}  // namespace perilymph::mechanics

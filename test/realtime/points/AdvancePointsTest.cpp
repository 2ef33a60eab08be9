// SPDX-License-Identifier: BSD-3-Clause

// The real-time guarantees of the tick for the published point set: no allocation and no overflow,
// for any motion of the hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "perilymph/anatomy/HapticSurface.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/AllocationGuard.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

struct Points {
  explicit Points(int count = 12, double startInside_mm = 2.0)
  {
    static const auto scala = anatomy::buildPublished({}, millimeters(1));
    static const auto surface = std::make_shared<anatomy::Surface>(anatomy::hapticSurface(*scala));
    ModelParts parts;
    parts.kind = ModelKind::points;
    parts.nodes = count;
    parts.lumen = scala;
    parts.hapticSurface = surface;
    parts.startInside = millimeters(startInside_mm);
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    model = InsertionModel::build(parts);
    state = std::make_unique<InsertionState>(*model);
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    drive.handPosition_W = model->startBase_W;
  }
  void tick() { advance(*model, *state, drive); }
  void pushTo(double travel)
  {
    for (double at = 0.0; at <= travel; at += 0.02e-3) {
      drive.handPosition_W = model->startBase_W + at * model->startAxis_W;
      tick();
    }
  }
  std::shared_ptr<const InsertionModel> model;
  std::unique_ptr<InsertionState> state;
  Drive drive;
};

TEST(PointSetTick, AllocatesNothingInDeepContact)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  Points points;
  points.pushTo(16e-3);
  ASSERT_GT(points.state->readings.contacts, 0);
  const test::AllocationGuard guard;
  for (int i = 0; i < 500; ++i) {
    points.drive.coupling = i % 2 == 0 ? Coupling::rigid : Coupling::spring;
    points.drive.couplingStiffness = 441.0;
    points.drive.handPosition_W -= 0.01e-3 * points.model->entry.out_W;
    points.tick();
  }
  points.state->reset(*points.model);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(guard.frees(), 0u);
}

TEST(PointSetTick, StaysFiniteAndBoundedInAHundredThousandTicksOfRandomMotion)
{
  // up to 200 mm/s, reversals, tilts, both couplings; and more points than are stable
  for (const int count : {12, 64}) {
    Points points(count);
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Vector3d start = points.model->startBase_W;
    Vector3d velocity = Vector3d::Zero();
    Vector3d tilt = Vector3d::Zero();
    const int ticks = count == 12 ? 100'000 : 20'000;
    for (int i = 0; i < ticks; ++i) {
      if (i % 50 == 0) velocity = 0.2 * Vector3d(any(random), any(random), any(random));
      if (i % 400 == 0)
        points.drive.coupling = any(random) > 0.0 ? Coupling::rigid : Coupling::spring;
      points.drive.couplingStiffness = 441.0;
      points.drive.couplingDamping = 1.0;
      Vector3d next = points.drive.handPosition_W + 1e-3 * velocity;
      for (int k = 0; k < 3; ++k) next[k] = std::clamp(next[k], start[k] - 0.02, start[k] + 0.02);
      points.drive.handVelocity_W = 1e3 * (next - points.drive.handPosition_W);
      points.drive.handPosition_W = next;
      tilt = 0.999 * tilt + 0.01 * Vector3d(any(random), any(random), any(random));
      points.drive.handAxis_W = (points.model->startAxis_W + tilt).normalized();
      points.tick();
      ASSERT_TRUE(points.state->readings.isFinite) << i;
      for (std::size_t k = 0; k < points.state->position_W.size(); ++k) {
        ASSERT_TRUE(points.state->position_W[k].allFinite()) << i;
        ASSERT_TRUE(points.state->wallForce_W[k].allFinite()) << i;
        // half of 3 x 2 x 2 cm in each direction, a diagonal of 2.1 cm; no proxy is ahead of its
        // point
        const Vector3d off = points.state->position_W[k] - points.state->points.place_W[k];
        ASSERT_LT(off.norm(), 0.0207) << i;
      }
    }
  }
}

TEST(PointSetTick, SaysWhenNumbersHaveOverflowed)
{
  for (const double poison :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points points;
    points.pushTo(8e-3);
    points.drive.handPosition_W.x() = poison;
    for (int i = 0; i < 5; ++i) points.tick();
    EXPECT_FALSE(points.state->readings.isFinite) << poison;
    points.state->reset(*points.model);
    points.drive.handPosition_W = points.model->startBase_W;
    points.tick();
    EXPECT_TRUE(points.state->readings.isFinite);
  }
}

TEST(PointSetTick, SurvivesAStartBeyondTheWall)
{
  // at a depth of ten millimeters the tip of a straight carrier is in the bone
  Points points(12, 10.0);
  for (int i = 0; i < 2000; ++i) {
    points.tick();
    ASSERT_TRUE(points.state->readings.isFinite);
  }
  EXPECT_GT(points.state->readings.contacts, 0);  // and its proxy is not
}

TEST(PointSetTick, LagsASpringHandByForceOverStiffness)
{
  Points points;
  points.pushTo(8e-3);
  points.drive.coupling = Coupling::spring;
  points.drive.couplingStiffness = 441.0;
  points.drive.couplingDamping = 3.0;
  for (int i = 0; i < 5000; ++i) points.tick();
  const Vector3d lag = points.state->base_W - points.drive.handPosition_W;
  EXPECT_GT(lag.norm(), 0.05e-3);
  EXPECT_LT((441.0 * lag - points.state->readings.handForce_W).norm(), 1e-4);
}

}  // namespace
}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "points/PointSetModel.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {
namespace {

ModelParts parts(int points = 12)
{
  ModelParts parts;
  parts.kind = ModelKind::points;
  parts.lumen = std::make_shared<anatomy::StraightTube>(1e-3);
  parts.array.length = millimeters(22);
  parts.array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
  parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-6)}};
  parts.array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  anatomy::Surface wall;
  wall.points = {{1e-3, -5e-3, 0.0}, {1e-3, 5e-3, 0.0}, {1e-3, 0.0, -9e-3}};
  wall.triangles = {{0, 2, 1}};
  parts.hapticSurface = std::make_shared<anatomy::Surface>(wall);
  parts.nodes = points;
  return parts;
}

std::string refusal(const ModelParts& parts)
{
  try {
    InsertionModel::build(parts);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(PointSetModel, WeighsWhatCarrierAndTweezersWeigh)
{
  for (const int points : {2, 12, 64}) {
    const auto model = InsertionModel::build(parts(points));
    EXPECT_NEAR(points * model->points->pointMass, 0.0178943, 1e-15);
  }
}

TEST(PointSetModel, TurnsLikeABoxOfThePublishedSize)
{
  // m (b^2 + c^2) / 12 of 3 x 2 x 2 cm
  const auto model = InsertionModel::build(parts());
  EXPECT_NEAR(model->points->inertia[0], 0.0178943 * (4e-4 + 4e-4) / 12, 1e-18);
  EXPECT_NEAR(model->points->inertia[1], 0.0178943 * (9e-4 + 4e-4) / 12, 1e-18);
  EXPECT_NEAR(model->points->inertia[2], 0.0178943 * (9e-4 + 4e-4) / 12, 1e-18);
}

TEST(PointSetModel, NeverStepsLongerThanThePublishedLoop)
{
  for (const double step_ms : {0.1, 0.5, 1.0, 1.5, 3.3, 10.0}) {
    ModelParts some = parts();
    some.timeStep = milliseconds(step_ms);
    const auto model = InsertionModel::build(some);
    EXPECT_LE(model->points->substep, 1e-3 * (1 + 1e-9)) << step_ms;
    EXPECT_NEAR(model->points->substep * model->points->substeps, 1e-3 * step_ms, 1e-15);
  }
}

TEST(PointSetModel, RefusesNumbersOfPointsThatMakeNoCarrier)
{
  EXPECT_THAT(refusal(parts(1)), testing::HasSubstr("must have 2 to 256"));
  EXPECT_THAT(refusal(parts(257)), testing::HasSubstr("must have 2 to 256"));
  EXPECT_EQ(refusal(parts(2)), "accepted");
}

TEST(PointSetModel, RefusesToTouchNothing)
{
  ModelParts none = parts();
  none.hapticSurface = nullptr;
  EXPECT_THAT(refusal(none), testing::HasSubstr("haptic surface"));
}

TEST(PointSetModel, ChangesTheFingerprintWithItsSurface)
{
  const auto one = InsertionModel::build(parts());
  ModelParts moved = parts();
  auto surface = std::make_shared<anatomy::Surface>(*moved.hapticSurface);
  surface->points[0][0] += 1e-9;
  moved.hapticSurface = surface;
  EXPECT_EQ(one->fingerprint, InsertionModel::build(parts())->fingerprint);
  EXPECT_NE(one->fingerprint, InsertionModel::build(moved)->fingerprint);
}

TEST(PointSetState, StartsAsItResets)
{
  const auto model = InsertionModel::build(parts());
  const InsertionState fresh(*model);
  InsertionState used(*model);
  used.points.turn_W.x() = 0.1;
  used.points.turnedAt = 5e-3;
  used.position_W[3].x() += 1e-3;
  EXPECT_NE(used.fingerprint(), fresh.fingerprint());
  used.reset(*model);
  EXPECT_EQ(used.fingerprint(), fresh.fingerprint());
}

}  // namespace
}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/InsertionModel.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "lumen/PlainLumens.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {
namespace {

ModelParts contourInATube()
{
  ModelParts parts;
  parts.lumen = std::make_shared<anatomy::StraightTube>(1e-3);
  parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
  return parts;
}

TEST(InsertionModel, StartsTheTipWhereItWasToldTo)
{
  for (const double inside_mm : {-5.0, 0.0, 2.0}) {
    ModelParts parts = contourInATube();
    parts.startInside = millimeters(inside_mm);
    const auto model = InsertionModel::build(parts);
    const InsertionState state(*model);
    EXPECT_NEAR(-state.position_W.back().z(), inside_mm / 1e3, 1e-12);
  }
}

TEST(InsertionModel, WallStiffnessDoesNotDependOnTheNumberOfNodes)
{
  const auto total = [](int nodes) {
    ModelParts parts = contourInATube();
    parts.nodes = nodes;
    const auto model = InsertionModel::build(parts);
    double sum = 0.0;
    for (const double stiffness : model->wallStiffness) sum += stiffness;
    return sum;
  };
  EXPECT_NEAR(total(50), total(400), 0.02 * total(400));
}

TEST(InsertionModel, AimsAtTheMiddleOfTheOpening)
{
  ModelParts parts = contourInATube();
  parts.opening = cochleostomy();
  parts.opening->outward = millimeters(0.3);
  parts.opening->vertical = millimeters(-0.2);
  parts.startInside = millimeters(0);
  const InsertionState state(*InsertionModel::build(parts));
  EXPECT_LT((state.position_W.back() - Eigen::Vector3d(0.3e-3, -0.2e-3, 0.0)).norm(), 1e-12);
}

TEST(InsertionModel, RefusesASolverThatCannotSolve)
{
  ModelParts idle = contourInATube(), loose = contourInATube();
  idle.solver.maxTries = 0;
  loose.solver.forceTolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(InsertionModel::build(idle), std::invalid_argument);
  EXPECT_THROW(InsertionModel::build(loose), std::invalid_argument);
}

TEST(InsertionModel, HasAPartitionOnlyInAScalaTympani)
{
  ModelParts parts = contourInATube();
  EXPECT_FALSE(InsertionModel::build(parts)->partitionRange.holds(1.0));
  parts.partitionStrength = newtons(0.1);
  EXPECT_THROW(InsertionModel::build(parts), std::invalid_argument);
}

TEST(InsertionModel, WeighsAsMuchAsItsSilicone)
{
  const auto model = InsertionModel::build(contourInATube());
  double mass = 0.0;
  for (const double nodeMass : model->mass) mass += nodeMass;
  // 25 mm of 0.5 to 0.8 mm silicone: between 5.6 and 14.5 mg
  EXPECT_GT(mass, 5.6e-6);
  EXPECT_LT(mass, 14.5e-6);
}

TEST(InsertionModel, ChangesItsFingerprintWithEveryPart)
{
  const auto print = [](auto change) {
    ModelParts parts = contourInATube();
    change(parts);
    return InsertionModel::build(parts)->fingerprint;
  };
  const auto same = print([](ModelParts&) {});
  EXPECT_EQ(same, print([](ModelParts&) {}));
  EXPECT_NE(same, print([](ModelParts& p) { p.nodes = 101; }));
  EXPECT_NE(same, print([](ModelParts& p) { p.friction.kineticCoefficient = 0.04; }));
  EXPECT_NE(same, print([](ModelParts& p) { p.timeStep = milliseconds(0.5); }));
  EXPECT_NE(same, print([](ModelParts& p) { p.approachTilt = degrees(1); }));
  EXPECT_NE(same, print([](ModelParts& p) { p.opening = roundWindow(); }));
  EXPECT_NE(print([](ModelParts& p) { p.opening = cochleostomy(); }), print([](ModelParts& p) {
              p.opening = cochleostomy();
              p.array.ribHeight = millimeters(0.2);
            }));
}

TEST(InsertionModel, RefusesImpossibleSettings)
{
  const auto refused = [](auto change) {
    ModelParts parts = contourInATube();
    change(parts);
    try {
      InsertionModel::build(parts);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using testing::HasSubstr;
  EXPECT_THAT(refused([](ModelParts& p) { p.nodes = 5; }),
              HasSubstr("5 nodes; it must have 8 to 1024"));
  EXPECT_THAT(refused([](ModelParts& p) { p.timeStep = milliseconds(50); }),
              HasSubstr("0.1 to 10 ms"));
  EXPECT_THAT(refused([](ModelParts& p) { p.startInside = millimeters(30); }), HasSubstr("30.0"));
  EXPECT_THAT(refused([](ModelParts& p) { p.friction.kineticCoefficient = 0.5; }),
              HasSubstr("Friction"));
  for (const double stiffness : {0.0, -441.0, 2e5})
    EXPECT_THAT(
        refused([stiffness](ModelParts& p) { p.wall.perSamplePoint = newtonsPerMeter(stiffness); }),
        HasSubstr("must be above 0 and at most 100000 N/m"));
  EXPECT_THAT(refused([](ModelParts& p) {
                p.membrane = MembraneLaw{};
                p.membrane->perSamplePoint = newtonsPerMeter(500);
              }),
              HasSubstr("no stiffer than the wall"));
  EXPECT_THAT(refused([](ModelParts& p) { p.opening = cochleostomy(millimeters(0.3)); }),
              HasSubstr("wide enough for the tip"));
  EXPECT_THAT(refused([](ModelParts& p) {
                p.opening = roundWindow();
                p.opening->outward = millimeters(3);
              }),
              HasSubstr("within 2 mm"));
  EXPECT_THAT(refused([](ModelParts& p) {
                p.opening = roundWindow();
                p.opening->passage = millimeters(1);
              }),
              HasSubstr("only a round one can have a passage"));
  for (const double length_mm : {-1.0, 2.1})
    EXPECT_THAT(refused([length_mm](ModelParts& p) {
                  p.opening = cochleostomy();
                  p.opening->passage = millimeters(length_mm);
                }),
                HasSubstr("must be 0 to 2 mm"));
  EXPECT_THAT(refused([](ModelParts& p) {
                p.opening = cochleostomy();
                p.opening->passage = millimeters(1);
                p.opening->ribExitLoss = 1.1;
              }),
              HasSubstr("must be 0 to 1"));
}

}  // namespace
}  // namespace perilymph::mechanics

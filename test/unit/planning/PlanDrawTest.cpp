// SPDX-License-Identifier: BSD-3-Clause
#include "PlanDraw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "SyntheticPlan.h"
#include "perilymph/analysis/SampleStatistics.h"

namespace perilymph::test {
namespace {

using planning::PlanDraw;

/// Draws of the measured patient.
class PlanDraws : public testing::Test {
protected:
  void SetUp() override
  {
    const auto uncertainty = planning::shippedUncertainty();
    ASSERT_TRUE(uncertainty) << uncertainty.error().message;
    uncertainty_ = *uncertainty;
    const auto hand = analysis::shippedHand();
    ASSERT_TRUE(hand) << hand.error().message;
    hand_ = *hand;
  }
  PlanDraw draw(std::uint64_t number, std::uint64_t seed = 1) const
  {
    return planning::drawPlan(measuredPatient(), uncertainty_, hand_, seed, number);
  }
  analysis::SampleStatistics statisticsOf(const std::function<double(const PlanDraw&)>& value) const
  {
    std::vector<double> values;
    for (std::uint64_t i = 1; i <= 4000; ++i) values.push_back(value(draw(i)));
    return analysis::statisticsOf(values);
  }

  planning::Uncertainty uncertainty_;
  analysis::HandDistribution hand_;
};

TEST_F(PlanDraws, HaveTheMeansAndErrorsOfTheMeasures)
{
  const auto a =
      statisticsOf([](const PlanDraw& d) { return inMillimeters(d.patient.basalTurn->a); });
  const auto b =
      statisticsOf([](const PlanDraw& d) { return inMillimeters(d.patient.basalTurn->b); });
  const auto h =
      statisticsOf([](const PlanDraw& d) { return inMillimeters(*d.patient.basalTurn->h); });
  EXPECT_NEAR(a.mean, 9.2, 4.0 * a.standardError);
  EXPECT_NEAR(a.standardDeviation, 0.1, 0.005);
  EXPECT_NEAR(b.mean, 6.8, 4.0 * b.standardError);
  EXPECT_NEAR(b.standardDeviation, 0.2, 0.01);
  EXPECT_NEAR(h.mean, 4.0, 4.0 * h.standardError + 0.01);  // limited at the highest whole cochlea
  EXPECT_NEAR(h.standardDeviation, 0.3, 0.02);
}

TEST_F(PlanDraws, TurnTheApproachAsStated)
{
  const auto tilt = statisticsOf([](const PlanDraw& d) { return inDegrees(d.tilt); });
  EXPECT_NEAR(tilt.mean, 0.0, 4.0 * tilt.standardError);
  EXPECT_NEAR(tilt.standardDeviation, inDegrees(uncertainty_.tiltDeviation), 0.3);
}

TEST_F(PlanDraws, HaveStiffnessFactorsOfMeanOneAndTheGivenDeviation)
{
  const auto factor =
      statisticsOf([](const PlanDraw& d) { return planning::stiffnessFactor(d, 0.4); });
  EXPECT_NEAR(factor.mean, 1.0, 0.03);
  EXPECT_NEAR(factor.standardDeviation, 0.4, 0.03);
  EXPECT_EQ(planning::stiffnessFactor(draw(1), 0.0), 1.0);
}

TEST_F(PlanDraws, HaveIndividualShapesAndTissueWithinTheStatedRanges)
{
  const auto a1 = statisticsOf([](const PlanDraw& d) { return d.sharing[0]; });
  EXPECT_NEAR(a1.mean, 0.0, 4.0 * a1.standardError);
  EXPECT_NEAR(a1.standardDeviation, 1.0, 0.05);
  const auto section = statisticsOf([](const PlanDraw& d) { return d.shape.section; });
  EXPECT_NEAR(section.mean, 1.0, 4.0 * section.standardError);
  EXPECT_NEAR(section.standardDeviation, uncertainty_.sectionDeviation, 0.005);
  const auto lining =
      statisticsOf([](const PlanDraw& d) { return std::log(inMillimeters(d.lining)); });
  EXPECT_NEAR(lining.mean, std::log(0.08), 4.0 * lining.standardError);  // 0.04 to 0.16
  for (std::uint64_t i = 1; i <= 200; ++i) {
    EXPECT_GE(draw(i).membrane.si(), uncertainty_.membraneLow.si());
    EXPECT_LE(draw(i).membrane.si(), uncertainty_.membraneHigh.si());
    const PlanDraw one = draw(i);
    EXPECT_NEAR(one.shape.half.a().si(), one.patient.basalTurn->a.si(), 1e-12);
  }
}

TEST_F(PlanDraws, DependOnSeedAndNumberAlone)
{
  EXPECT_EQ(draw(7).patient.basalTurn->a.si(), draw(7).patient.basalTurn->a.si());
  EXPECT_NE(draw(7).patient.basalTurn->a.si(), draw(8).patient.basalTurn->a.si());
  EXPECT_NE(draw(7).patient.basalTurn->a.si(), draw(7, 2).patient.basalTurn->a.si());
}

TEST_F(PlanDraws, ChangeWhatIsDrawnAndNothingElse)
{
  session::InsertionParameters nominal;
  nominal.array.bending = {{millimeters(0), millimeters(20)},
                           {BendingStiffness::fromSi(1e-6), BendingStiffness::fromSi(2e-6)}};
  nominal.approachTilt = degrees(1);
  const PlanDraw one = draw(3);
  const auto parameters = planning::drawnParameters(nominal, one, 1.5, std::nullopt);
  EXPECT_DOUBLE_EQ(parameters.array.bending.value[1].si(), 3e-6);
  EXPECT_DOUBLE_EQ(parameters.approachTilt.si(), (degrees(1) + one.tilt).si());
  EXPECT_EQ(parameters.cochlea.patient.basalTurn->b.si(), one.patient.basalTurn->b.si());
  EXPECT_EQ(parameters.speed.si(), nominal.speed.si());  // the surgeon's comes with the hand
  EXPECT_EQ(parameters.nodes, nominal.nodes);
  EXPECT_EQ(parameters.timeStep.si(), nominal.timeStep.si());
}

TEST_F(PlanDraws, HaveTheNodesAndTheTimeStepOfTheResolution)
{
  session::InsertionParameters nominal;
  nominal.array.bending = {{millimeters(0)}, {BendingStiffness::fromSi(1e-6)}};
  const auto parameters =
      planning::drawnParameters(nominal, draw(3), 1.0, planning::Resolution{40, milliseconds(2)});
  EXPECT_EQ(parameters.nodes, 40);
  EXPECT_EQ(parameters.timeStep.si(), milliseconds(2).si());
}

TEST(Uncertainty, OfAnArrayFollowsTheConfidenceInItsStiffness)
{
  const auto uncertainty = planning::shippedUncertainty();
  ASSERT_TRUE(uncertainty) << uncertainty.error().message;
  electrode::ArrayDesign array;
  EXPECT_EQ(uncertainty->stiffnessOf(array), uncertainty->lowStiffness);
  array.provenance = {{"bending", {"measured", electrode::Confidence::high}}};
  EXPECT_EQ(uncertainty->stiffnessOf(array), uncertainty->highStiffness);
  EXPECT_LT(uncertainty->highStiffness, uncertainty->lowStiffness);
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#include "PlanDraw.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PlanRequest.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/SyntheticPlan.h"

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

TEST_F(PlanDraws, HaveTheCorrelationsOfTheErrors)
{
  anatomy::Patient patient = measuredPatient();
  patient.basalTurn->h = millimeters(3.5);  // far from the limits of H
  patient.errors->ab = 0.6;
  patient.errors->ah = -0.5;
  patient.errors->bh = 0.2;
  std::array<std::vector<double>, 3> values;
  for (std::uint64_t i = 1; i <= 4000; ++i) {
    const auto drawn = planning::drawPlan(patient, uncertainty_, hand_, 1, i);
    const anatomy::BasalTurn& turn = *drawn.patient.basalTurn;
    values[0].push_back(inMillimeters(turn.a));
    values[1].push_back(inMillimeters(turn.b));
    values[2].push_back(inMillimeters(*turn.h));
  }
  const auto correlation = [&](std::size_t i, std::size_t k) {
    const auto a = analysis::statisticsOf(values[i]), b = analysis::statisticsOf(values[k]);
    double sum = 0.0;
    for (std::size_t n = 0; n < values[i].size(); ++n)
      sum += (values[i][n] - a.mean) * (values[k][n] - b.mean);
    return sum /
           (static_cast<double>(values[i].size()) * a.standardDeviation * b.standardDeviation);
  };
  // four standard errors of a correlation from 4000 draws are 0.06 at most
  EXPECT_NEAR(correlation(0, 1), 0.6, 0.06);
  EXPECT_NEAR(correlation(0, 2), -0.5, 0.06);
  EXPECT_NEAR(correlation(1, 2), 0.2, 0.06);
  EXPECT_NEAR(analysis::statisticsOf(values[2]).standardDeviation, 0.3, 0.015);
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

TEST_F(PlanDraws, HaveAPackingOfWiresEvenInItsLogarithm)
{
  // from 0.06 to 1.2: mean and deviation of a uniform distribution of the logarithm
  const auto packing = statisticsOf([](const PlanDraw& d) { return std::log(d.packing); });
  EXPECT_NEAR(packing.mean, 0.5 * std::log(0.06 * 1.2), 4.0 * packing.standardError);
  EXPECT_NEAR(packing.standardDeviation, std::log(1.2 / 0.06) / std::sqrt(12.0), 0.03);
}

TEST_F(PlanDraws, PackTheWiresOfAllStraightArraysAlikeAndLeaveTheOthers)
{
  EXPECT_EQ(uncertainty_.packing.low, 0.06);
  EXPECT_EQ(uncertainty_.packing.high, 1.2);
  PlanDraw drawn = draw(1);
  drawn.packing = 0.3;
  const auto shipped = [](const char* name) {
    const auto file = findByName("array", "plugins/electrodes", name);
    EXPECT_TRUE(file) << name;
    return *electrode::loadArray(*file);
  };
  EXPECT_EQ(uncertainty_.stiffnessOf(shipped("flex28")), uncertainty_.mediumStiffness);
  EXPECT_EQ(uncertainty_.stiffnessOf(shipped("contour")), uncertainty_.lowStiffness);
  for (const char* name : {"hifocus-slimj", "flex28"}) {
    session::InsertionParameters nominal;
    nominal.array = shipped(name);
    const auto parameters = planning::drawnParameters(nominal, drawn, 1.0, std::nullopt);
    EXPECT_NEAR(*electrode::wirePacking(parameters.array), 0.3, 0.003) << name;
  }
  session::InsertionParameters nominal;
  nominal.array = shipped("contour");
  EXPECT_EQ(planning::drawnParameters(nominal, drawn, 1.0, std::nullopt).array.bending.value,
            nominal.array.bending.value);
}

// What is inserted from a plan is what the plan shows: the middle of what it draws.
TEST_F(PlanDraws, HaveTheScenarioInTheirMiddle)
{
  for (const char* array : {"flex28", "slim-straight", "flexsoft", "medel-standard"}) {
    const auto scenario = session::loadScenario(planning::PlanRequest{}.scenario,
                                                {{"array", array}, {"stop_travel_mm", "10"}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    const electrode::ArrayDesign& inserted = scenario->array();
    EXPECT_NEAR(*electrode::wirePacking(inserted), uncertainty_.packing.median(), 0.005) << array;
    const session::InsertionParameters& parameters = scenario->parameters();
    const double lining = inMillimeters(parameters.wall.lining),
                 membrane = parameters.membrane->perSamplePoint.si();
    EXPECT_NEAR(
        lining,
        std::sqrt(inMillimeters(uncertainty_.liningLow) * inMillimeters(uncertainty_.liningHigh)),
        0.005);
    EXPECT_NEAR(membrane, std::sqrt(uncertainty_.membraneLow.si() * uncertainty_.membraneHigh.si()),
                0.05);
    if (!inserted.taper) continue;
    EXPECT_NEAR(inMillimeters(inserted.diameter.at(inserted.contactsFromTip.back())), 1.05, 1e-9)
        << array;
  }
}

// A draw replaces the middle that the scenario states; it does not add to it.
TEST_F(PlanDraws, OfAnArrayAreTheSameWhateverTheScenarioStates)
{
  PlanDraw drawn = draw(1);
  drawn.packing = 0.9;
  drawn.taper = 0.2;
  for (const char* array : {"flexsoft", "medel-standard", "slim-straight"}) {
    const auto bending = [&](const session::Overrides& more) {
      session::Overrides overrides = {{"array", array}, {"stop_travel_mm", "10"}};
      overrides.insert(overrides.end(), more.begin(), more.end());
      const auto scenario = session::loadScenario(planning::PlanRequest{}.scenario, overrides);
      EXPECT_TRUE(scenario) << scenario.error().message;
      return planning::drawnParameters(scenario->parameters(), drawn, 1.0, std::nullopt)
          .array.bending;
    };
    const auto middle = bending({}),
               other = bending({{"wire_packing", "0.06"}, {"taper_fraction", "1"}});
    ASSERT_EQ(middle.value.size(), other.value.size());
    for (std::size_t i = 0; i < middle.value.size(); ++i)
      EXPECT_NEAR(middle.value[i] / other.value[i], 1.0, 1e-6) << array << ", knot " << i;
  }
}

TEST_F(PlanDraws, HaveATaperEvenInItsRange)
{
  const auto taper = statisticsOf([](const PlanDraw& d) { return d.taper; });
  EXPECT_NEAR(taper.mean, 0.5, 4.0 * taper.standardError);
  EXPECT_NEAR(taper.standardDeviation, 1.0 / std::sqrt(12.0), 0.01);
}

TEST_F(PlanDraws, TaperTheArraysThatStateARangeAndNoOther)
{
  PlanDraw drawn = draw(1);
  drawn.packing = 0.3;
  const auto parameters = [&](const char* name, double taper) {
    session::InsertionParameters nominal;
    const auto file = findByName("array", "plugins/electrodes", name);
    EXPECT_TRUE(file) << name;
    nominal.array = *electrode::loadArray(*file);
    drawn.taper = taper;
    return planning::drawnParameters(nominal, drawn, 1.0, std::nullopt).array;
  };
  // silicone of 2 MPa in 0.8, 1.05 and 1.3 mm, and 12 wires of 3.2213e-9 N m^2 with c = 0.3; files have
  // three digits
  const double wires = 3.2213e-9 * (12.0 + 0.3 * 144.0);
  const Length lastContact = millimeters(27.4);
  for (const auto& [taper, width] :
       {std::pair{0.0, 0.8e-3}, std::pair{0.5, 1.05e-3}, std::pair{1.0, 1.3e-3}}) {
    const electrode::ArrayDesign standard = parameters("medel-standard", taper);
    EXPECT_NEAR(standard.diameter.at(lastContact).si(), width, 1e-9);
    const double silicone = 2e6 * pi * width * width * width * width / 64.0;
    EXPECT_NEAR(standard.bending.at(lastContact).si(), silicone + wires, 2e-9);
    EXPECT_NEAR(parameters("flexsoft", taper).diameter.at(lastContact).si(), width, 1e-9);
  }
  const electrode::ArrayDesign thin = parameters("flex28", 0.0), thick = parameters("flex28", 1.0);
  EXPECT_EQ(thin.diameter.value, thick.diameter.value);
  EXPECT_EQ(thin.bending.value, thick.bending.value);
}

TEST_F(PlanDraws, HaveIndividualShapesAndTissueWithinTheStatedRanges)
{
  const auto a1 = statisticsOf([](const PlanDraw& d) { return d.sharing[0]; });
  EXPECT_NEAR(a1.mean, 0.0, 4.0 * a1.standardError);
  EXPECT_NEAR(a1.standardDeviation, 1.0, 0.05);
  EXPECT_NE(draw(1).shape.half.a1, draw(2).shape.half.a1);
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

TEST_F(PlanDraws, VaryAlongTheScalaWithTheStatedDeviationsAndCorrelations)
{
  using Function = double (*)(const anatomy::IndividualShape&, double);
  struct Case {
    const char* name;
    Function function;
    double mean, deviation;
    Angle correlation;
  };
  const Case cases[] = {
      {"section", [](const auto& shape, double angle) { return shape.sectionAt(angle); }, 1.0,
       uncertainty_.section.standardDeviation, uncertainty_.section.correlation},
      {"course", [](const auto& shape, double angle) { return shape.course.at(angle); }, 0.0,
       uncertainty_.course.standardDeviation, uncertainty_.course.correlation},
      {"radius", [](const auto& shape, double angle) { return shape.radius.at(angle); }, 0.0,
       uncertainty_.radius.standardDeviation, uncertainty_.radius.correlation}};
  for (const Case& one : cases) {
    const double from = degrees(70.0).si(), to = from + one.correlation.si();
    const auto here =
        statisticsOf([&](const PlanDraw& d) { return one.function(d.shape, from) - one.mean; });
    const auto there =
        statisticsOf([&](const PlanDraw& d) { return one.function(d.shape, to) - one.mean; });
    EXPECT_NEAR(here.mean, 0.0, 4.0 * here.standardError) << one.name;
    // four standard errors of a standard deviation from 4000 draws
    EXPECT_NEAR(here.standardDeviation / one.deviation, 1.0, 0.045) << one.name;
    EXPECT_NEAR(there.standardDeviation / one.deviation, 1.0, 0.045) << one.name;
    const auto product = statisticsOf([&](const PlanDraw& d) {
      return (one.function(d.shape, from) - one.mean) * (one.function(d.shape, to) - one.mean);
    });
    // exp(-1/2) one correlation length apart; logarithms of sections, which the factors nearly are
    EXPECT_NEAR(product.mean / (here.standardDeviation * there.standardDeviation), std::exp(-0.5),
                0.06)
        << one.name;
  }
}

TEST_F(PlanDraws, HaveAHeightOfTheirOwnOnlyIfNoneWasMeasured)
{
  EXPECT_EQ(draw(1).shape.height, 1.0);
  anatomy::Patient patient = measuredPatient();
  patient.basalTurn->h = std::nullopt;
  std::vector<double> heights;
  for (std::uint64_t i = 1; i <= 4000; ++i)
    heights.push_back(planning::drawPlan(patient, uncertainty_, hand_, 1, i).shape.height);
  const auto height = analysis::statisticsOf(heights);
  EXPECT_NEAR(height.mean, 1.0, 4.0 * height.standardError);
  EXPECT_NEAR(height.standardDeviation, 0.24 / 3.26, 0.005);  // Medan, 36 ears
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

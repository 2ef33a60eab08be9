// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/PriorPredictive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/validation/Validation.h"
#include "prior/InputDraw.h"

namespace perilymph::validation {
namespace {

DeclaredRanges ranges()
{
  auto shipped = shippedRanges();
  EXPECT_TRUE(shipped) << shipped.error().message;
  return *shipped;
}

TEST(DeclaredRanges, AreThoseOfTheGuide)
{
  const DeclaredRanges shipped = ranges();
  const auto range = [&](Input input) { return shipped.inputs[static_cast<std::size_t>(input)]; };
  EXPECT_EQ(range(Input::startLow).low, 1.0);
  EXPECT_EQ(range(Input::startHigh).high, 3.0);
  EXPECT_TRUE(range(Input::stylet).isLogarithmic);
  for (const InputRange& each : shipped.inputs) {
    EXPECT_LT(each.low, each.high);
    EXPECT_FALSE(each.source.empty());
    EXPECT_THAT(each.declared, testing::StartsWith("2026-11-2"));
  }
}

TEST(DeclaredRanges, NameTheInputThatIsMissing)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "few.toml") << "label = 'x'\nvariability = 'published-experiment'\n";
  const auto few = loadRanges(folder / "few.toml");
  ASSERT_FALSE(few);
  EXPECT_THAT(few.error().message, testing::HasSubstr("start_mm is missing"));
}

TEST(DrawnInputs, StayWithinTheirRangesAndAgreeWithEachOther)
{
  const DeclaredRanges shipped = ranges();
  double before = 0.0;
  for (std::uint64_t number = 1; number <= 200; ++number) {
    const InputValues values = drawInputs(shipped, 1, number);
    EXPECT_EQ(values, drawInputs(shipped, 1, number));
    for (std::size_t i = 0; i < inputCount; ++i) {
      EXPECT_GE(values[i], shipped.inputs[i].low) << inputNames[i];
      EXPECT_LE(values[i], shipped.inputs[i].high) << inputNames[i];
    }
    EXPECT_LE(valueOf(values, Input::startLow), valueOf(values, Input::startHigh));
    // the text stops every insertion where the second rib touches
    EXPECT_GE(valueOf(values, Input::secondRib), valueOf(values, Input::startHigh) + 16.7 - 1e-9);
    EXPECT_NE(valueOf(values, Input::wall), before);
    before = valueOf(values, Input::wall);
  }
}

TEST(DrawnInputs, KeepTheEnergyOfTheRibWhateverThePassage)
{
  const auto request = shippedPrior();
  ASSERT_TRUE(request) << request.error().message;
  InputValues inputs = drawInputs(request->ranges, 1, 1);
  const auto set = [&](Input input, double value) {
    inputs[static_cast<std::size_t>(input)] = value;
  };
  set(Input::ribHeight, 0.178);
  set(Input::firstRib, 17.0);
  for (const double hole_mm : {0.85, 1.0, 1.15})
    for (const double modulus_MPa : {1.32, 2.0, 2.97}) {
      set(Input::passageDiameter, hole_mm);
      set(Input::modulus, modulus_MPa);
      const session::InsertionParameters drawn = withInputs(request->nominal, inputs);
      const double radius = 0.5 * drawn.array.sectionAt(millimeters(17)).within.si();
      const double interference = radius + drawn.array.ribHeight.si() - 0.5e-3 * hole_mm;
      // that of 0.178 mm on a carrier of this radius, in a passage of 1.0 mm and at 2.0 MPa
      const double declared = radius + 0.178e-3 - 0.5e-3;
      EXPECT_NEAR(modulus_MPa * interference * interference, 2.0 * declared * declared, 1e-15);
      EXPECT_EQ(drawn.opening->passage, drawn.cochlea.leadIn);
    }
}

TEST(StoppedRecord, EndsWithTheRestAndItsRelaxation)
{
  const StoppedRecord record =
      stoppedRecord({0.0161, 0.0163, 0.0164, 0.0166}, {0.10, 0.10, 0.10, 0.14}, millimeters(16.5),
                    seconds(0.55), 0.2, milliseconds(50));
  ASSERT_EQ(record.travel.size(), 3u + 11u);
  EXPECT_EQ(record.travel[3], 0.0165);
  // between the samples at 16.4 and 16.6 mm the force is 0.12 N; after 0.5 s 1 - 1/e of 20 % is lost
  EXPECT_NEAR(record.force[3 + 9], 0.12 * (1.0 - 0.2 * (1.0 - std::exp(-1.0))), 1e-12);
  EXPECT_TRUE(stoppedRecord({0.01}, {0.1}, millimeters(16.5), seconds(0), 0.2, milliseconds(50))
                  .travel.size() == 1u);
}

/// 32 repetitions whose forces lie by a step above and below a middle in all combinations: their
/// covariance is the square of the step times 32 / 31 on the diagonal.
std::vector<RepeatedExperiment> factorial(double step, double slope)
{
  constexpr std::array<double, 6> middle = {0.088, 0.085, 0.09, 0.13, 0.14, 0.13};
  std::vector<RepeatedExperiment> all;
  for (unsigned pattern = 0; pattern < 32; ++pattern) {
    RepeatedExperiment one;
    one.number = pattern + 1;
    one.force[0] = middle[0];
    for (std::size_t k = 1; k < 6; ++k) {
      const double side = (pattern >> (k - 1)) % 2 == 0 ? -1.0 : 1.0;
      one.force[k] = middle[k] + side * step;
      one.slope[k] = slope;
    }
    one.inputs[0] = one.force[1];
    all.push_back(one);
  }
  return all;
}

TEST(PriorSummary, AddsTheExperimentsErrorsToTheSpreadOfTheInputs)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  constexpr double step = 0.012;
  const auto summary = summarize(factorial(step, 0.0), *experiment);
  ASSERT_TRUE(summary) << summary.error().message;
  ASSERT_EQ(summary->anchors.size(), 5u);
  ASSERT_EQ(summary->joint.size(), 2u);
  // 80.7 at 0.085, 88 to 94 at 0.09 inside, the lower end 141.6 at 0.13, 150.9 at 0.14, 125.4 at 0.13
  constexpr std::array<double, 5> away = {-0.0043, 0.0, 0.0116, 0.0109, -0.0046};
  constexpr std::array<double, 5> deviation = {0.0219, 0.0219, 0.0265, 0.0189, 0.0385};
  double distance = 0.0;
  for (std::size_t k = 0; k < 5; ++k)
    distance +=
        away[k] * away[k] / (step * step * 32.0 / 31.0 + deviation[k] * deviation[k] / 11.0);
  EXPECT_NEAR(summary->joint[0].distance, distance, 1e-9);
  EXPECT_NEAR(summary->joint[0].pValue, chiSquareTail(distance, 5), 1e-12);
  EXPECT_NEAR(summary->joint[0].counted, summary->joint[0].pValue, 0.2);  // of 32
  EXPECT_GT(summary->joint[1].distance, 0.0);
  for (const PredictedAnchor& anchor : summary->anchors) {
    EXPECT_NEAR(anchor.deviation, step * std::sqrt(32.0 / 31.0), 1e-12);
    EXPECT_NEAR(anchor.rank, 0.5, 1e-12);
    EXPECT_TRUE(anchor.isInside);
    EXPECT_LT(anchor.low90WithError, anchor.low90);
  }
  EXPECT_NEAR(summary->anchors[0].correlation[0], 1.0, 1e-12);  // the input is that force
  EXPECT_NEAR(summary->anchors[1].correlation[0], 0.0, 1e-12);
  EXPECT_EQ(summary->anchors[0].correlation[1], 0.0);  // constant
}

TEST(PriorSummary, CarriesTheErrorOfTheFittedForceToTheOthers)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  constexpr double step = 0.012, slope = 1.3;
  const auto summary = summarize(factorial(step, slope), *experiment);
  ASSERT_TRUE(summary);
  // Sherman and Morrison: (A + u u')^-1 = A^-1 - A^-1 u u' A^-1 / (1 + u' A^-1 u)
  constexpr std::array<double, 5> away = {-0.0043, 0.0, 0.0116, 0.0109, -0.0046};
  constexpr std::array<double, 5> deviation = {0.0219, 0.0219, 0.0265, 0.0189, 0.0385};
  const double u = slope * 0.0186 / std::sqrt(11.0);
  double plain = 0.0, mixed = 0.0, own = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double variance = step * step * 32.0 / 31.0 + deviation[k] * deviation[k] / 11.0;
    plain += away[k] * away[k] / variance;
    mixed += away[k] * u / variance;
    own += u * u / variance;
  }
  EXPECT_NEAR(summary->joint[0].distance, plain - mixed * mixed / (1.0 + own), 1e-9);
}

TEST(PriorSummary, LeavesOutWhatHasNoFit)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  std::vector<RepeatedExperiment> all = factorial(0.01, 0.0);
  all.push_back(all.front());
  all.back().reason = "stiffness beyond its bounds";
  all.back().force.fill(9.0);
  const auto summary = summarize(all, *experiment);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->counted, 32);
  EXPECT_EQ(summary->leftOut, 1);
  EXPECT_LT(summary->anchors[0].mean, 0.1);
  all.resize(10);
  const auto few = summarize(all, *experiment);
  ASSERT_FALSE(few);
  EXPECT_THAT(few.error().message, testing::HasSubstr("Only 10 of 10"));
}

TEST(RepeatedExperiment, IsFittedToTheForceAtTheBasalTurn)
{
  auto request = shippedPrior();
  ASSERT_TRUE(request) << request.error().message;
  request->nominal.nodes = 24;
  request->variability.timeStep = milliseconds(10);
  const auto one = repeatExperiment(*request, 1);
  ASSERT_TRUE(one) << one.error().message;
  const auto again = repeatExperiment(*request, 1);
  ASSERT_TRUE(again);
  EXPECT_EQ(priorCsv({*one}), priorCsv({*again}));
  if (!one->reason.empty()) GTEST_SKIP() << one->reason;
  EXPECT_NEAR(one->force[0], 0.088, 1e-12);
  for (const double force : one->force) EXPECT_GT(force, 0.03);
  EXPECT_GT(one->scale, 0.1);
}

}  // namespace
}  // namespace perilymph::validation

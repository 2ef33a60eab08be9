// SPDX-License-Identifier: BSD-3-Clause

// The published experiment repeated with many seeds: every study has a result.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/session/Calibration.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::validation {
namespace {

ValidationRequest studyOf(std::uint64_t seed, int runs)
{
  const auto references = validationReferences();
  EXPECT_TRUE(references);
  ValidationRequest request = *shippedValidation(*references);
  request.seed = seed;
  request.runs = runs;
  request.runsPerSource = 0;
  request.jobs = 2;
  return request;
}

class Seeds : public testing::TestWithParam<int> {};

TEST_P(Seeds, GiveAStudyInWhichNearlyEveryInsertionReachesTheEnd)
{
  const auto result = validate(studyOf(static_cast<std::uint64_t>(GetParam()), STUDY_RUNS), {});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->runs, STUDY_RUNS);
  // Seeds 1 to 8 lose none of 1600; a study that lost a twentieth would describe another experiment.
  EXPECT_LE(static_cast<int>(result->incomplete.size()), std::max(1, STUDY_RUNS / 20));
  for (const IncompleteInsertion& each : result->incomplete)
    EXPECT_NE(each.end, haptics::InsertionEnd::fault) << each.fault;
}

INSTANTIATE_TEST_SUITE_P(Study, Seeds, testing::Range(1, STUDY_SEEDS + 1));

TEST(Study, CountsAnArrayThatSlipsOutOfTheOpeningAndGoesOn)
{
  // carriers less straight than the experiment's, pushed from its smallest depth through a thin rim
  ValidationRequest request = studyOf(5, 31);
  request.variability.curvatureDeviation = 0.04;
  request.variability.startLow = millimeters(1);
  request.variability.startHigh = millimeters(3);
  request.nominal.opening->passage = millimeters(0);
  request.nominal.wall.perSamplePoint = newtonsPerMeter(441);
  request.nominal.wall.rim = newtonsPerMeter(441);
  request.nominal.array = session::calibrated(request.nominal.array, 1.47, 0.024);
  std::atomic<int> curves{0};
  request.onCurve = [&](const std::vector<double>&) { ++curves; };
  const auto result = validate(request, {});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->incomplete.size(), 2u);
  EXPECT_EQ(curves, 29);
  for (const IncompleteInsertion& each : result->incomplete) {
    EXPECT_EQ(each.end, haptics::InsertionEnd::outOfOpening);
    // A carrier that kept over a tenth of its free curvature; its tip never met the outer wall.
    const DrawnInsertion drawn = drawInsertion(request.nominal, request.variability,
                                               SpreadSources::all(), request.seed, each.number - 1);
    EXPECT_GT(drawn.parameters.array.stylet.residualCurvature, 0.1);
    EXPECT_LT(each.maxDepth, 0.003);
    EXPECT_LT(each.maxForce, 0.1);
  }
  EXPECT_EQ(completionSentence(result->runs, result->incomplete),
            "29 of 31 insertions reached the end; 2 bowed in front of the opening and slipped out "
            "of it (numbers 25 and 30).");
  EXPECT_THAT(summaryJson(request, *result), testing::HasSubstr("\"completed\": 29"));
  const figures::Figure figure = simulationFigure(*result, request.experiment);
  EXPECT_EQ(figure.curves.front().label, "mean of 29 simulated insertions");
  EXPECT_THAT(figure.notes, testing::Contains(testing::HasSubstr("29 of 31")));
}

TEST(Study, OfWhichNothingReachesTheEndSaysWhatHappened)
{
  ValidationRequest request = studyOf(1, 2);
  request.nominal.array.stylet.residualCurvature = 0.3;
  request.variability.startHigh = request.variability.startLow;
  const auto result = validate(request, {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("0 of 2 insertions reached the end; 2 "));
}

}  // namespace
}  // namespace perilymph::validation

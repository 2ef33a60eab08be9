// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/Validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <set>
#include <stop_token>
#include <thread>

#include "perilymph/figures/Svg.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/validation/CalibrationFit.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::validation {
namespace {

/// Few, coarse insertions, to keep the run short.
ValidationRequest smallRequest(int runs = 6)
{
  ValidationRequest request;
  request.variability =
      *loadVariability(resource("resources/validation/published-experiment.toml"));
  request.variability.timeStep = milliseconds(10);
  request.nominal = session::loadScenario("contour-published", {{"nodes", "24"}})->parameters();
  request.experiment = *analysis::shippedReference("todd-naghdy-experiment");
  request.runs = runs;
  request.runsPerSource = 2;
  request.jobs = 2;
  return request;
}

TEST(Validation, GivesTheSameBytesWhateverTheJobs)
{
  ValidationRequest request = smallRequest(4);
  request.jobs = 1;
  const auto one = validate(request, {});
  request.jobs = 3;
  const auto three = validate(request, {});
  ASSERT_TRUE(one && three);
  EXPECT_EQ(profileCsv(*one), profileCsv(*three));
  EXPECT_EQ(differenceCsv(*one), differenceCsv(*three));
  EXPECT_EQ(summaryJson(request, *one), summaryJson(request, *three));
  EXPECT_EQ(figures::svg(figures::draw(simulationFigure(*one, request.experiment))),
            figures::svg(figures::draw(simulationFigure(*three, request.experiment))));
}

TEST(Validation, WithAnotherSeedIsAnotherStudyOfTheSameThing)
{
  ValidationRequest request = smallRequest(12);
  const auto one = validate(request, {});
  request.seed = 2;
  const auto two = validate(request, {});
  ASSERT_TRUE(one && two);
  EXPECT_NE(profileCsv(*one), profileCsv(*two));
  // Two means of the same quantity differ by less than 1.96 standard errors of their difference at
  // 95 of 100 depths. Depths of one curve are correlated, so half is required of few runs.
  int near = 0;
  for (std::size_t i = 0; i < one->profile.size(); ++i) {
    const analysis::SampleStatistics difference =
        analysis::differenceOf(one->profile[i].force, two->profile[i].force);
    if (std::fabs(difference.mean) <= 1.96 * difference.standardError) ++near;
  }
  EXPECT_GE(near, static_cast<int>(one->profile.size()) / 2);
}

TEST(Validation, RunsEveryTenthOfAMillimeterToTheEndOfThePublishedAxis)
{
  const auto result = validate(smallRequest(2), {});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->profile.size(), 166u);
  for (std::size_t i = 0; i < 166; ++i)
    EXPECT_NEAR(inMillimeters(meters(result->profile[i].travel)), 0.1 * static_cast<double>(i),
                1e-9);
  EXPECT_EQ(result->anchors.size(), 4u);
}

TEST(Validation, NamesAFractionForEverySourceAndTheyAddUp)
{
  const auto result = validate(smallRequest(2), {});
  ASSERT_TRUE(result);
  std::set<SpreadSource> named;
  double sum = 0.0;
  for (const SourceSpread& spread : result->spreads) {
    named.insert(spread.source);
    sum += spread.fraction;
  }
  EXPECT_EQ(named.size(), allSpreadSources.size());
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(Validation, EndsWhenAskedTo)
{
  std::stop_source stop;
  std::size_t told = 0;
  const auto result = validate(
      smallRequest(50),
      [&](std::size_t done, std::size_t) {
        told = done;
        stop.request_stop();
      },
      stop.get_token());
  ASSERT_FALSE(result);
  EXPECT_LT(told, 50u);
  EXPECT_THAT(result.error().message, testing::HasSubstr("Stopped"));
}

TEST(Validation, SaysWhenAThreadRunsOutOfMemory)
{
  ValidationRequest request = smallRequest(2);
  request.onCurve = [](const std::vector<double>&) { throw std::bad_alloc(); };
  const auto result = validate(request, {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("needs more memory than is available"));
}

TEST(Validation, TellsItsProgressInTheCallersThreadAndNeverBackward)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::size_t before = 0, last = 0, all = 0;
  const auto result = validate(smallRequest(3), [&](std::size_t done, std::size_t count) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GE(done, before);
    before = last = done;
    all = count;
    return true;
  });
  ASSERT_TRUE(result);
  EXPECT_EQ(last, all);
}

TEST(Validation, OfOneInsertionIsRefused)
{
  const auto result = validate(smallRequest(1), {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("at least 2"));
}

/// A result whose mean curve is known.
ValidationResult resultWith(double (*force)(double travel_mm), double standardDeviation)
{
  ValidationResult result;
  result.runs = 200;
  for (int i = 0; i <= 165; ++i) {
    analysis::SampleStatistics statistics{force(0.1 * i), standardDeviation,
                                          standardDeviation / std::sqrt(200.0)};
    result.profile.push_back({millimeters(0.1 * i).si(), statistics});
  }
  return result;
}

TEST(ProfileTable, HasTheColumnsThatToolsRelyOn)
{
  const ValidationResult result = resultWith([](double x) { return 0.01 * x; }, 0.02);
  const std::string csv = profileCsv(result);
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "travel_mm,mean_N,sd_N,sem_N,ci95_low_N,ci95_high_N");
  EXPECT_THAT(csv, testing::HasSubstr("\n0.3,"));  // not 0.30000000000000004
  EXPECT_THAT(csv, testing::HasSubstr("\n16.5,"));
}

TEST(Verdicts, ListAgreementAndDisagreement)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  ValidationResult result;
  AnchorComparison hit;
  hit.experiment = experiment->points[0];
  hit.simulator = {0.0880, 0.02, 0.001};
  hit.isWithinStandardDeviation = true;
  AnchorComparison miss;
  miss.experiment = experiment->points[2];
  miss.simulator = {0.1009, 0.02, 0.001};
  miss.difference = {-0.0500, 0.02, 0.0057};
  hit.difference = {0.0, 0.02, 0.0057};
  result.anchors = {hit, miss};
  const auto verdicts = verdictsOf(result, *experiment);
  EXPECT_TRUE(verdicts[0].isMet);
  EXPECT_FALSE(verdicts[1].isMet);
  EXPECT_EQ(verdicts[0].found, "88.0 mN");
  EXPECT_EQ(verdicts[0].what, "mean force at 10.6 mm, peak");
  EXPECT_EQ(verdicts[0].wanted, "88.0 ± 11.2 mN");  // 1.96 standard errors of a difference of means
  EXPECT_EQ(verdicts[2].found, "50.0 mN");          // the largest difference
  EXPECT_EQ(verdicts[2].wanted, "at most 27.0 mN");
  EXPECT_FALSE(verdicts[2].isMet);
}

TEST(Verdicts, JudgeMeansByTheErrorsOfMeans)
{
  auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  ValidationResult result;
  // 15 mN: within one printed standard deviation of 18.6 mN, but not within 1.96 standard errors
  AnchorComparison anchor;
  anchor.experiment = experiment->points[0];
  anchor.simulator = {0.1030, 0.004, 0.0003};
  const double error = std::hypot(0.0186 / std::sqrt(11.0), 0.0003);
  anchor.difference = {0.0150, 0.019, error};
  anchor.isWithinStandardDeviation = true;
  result.anchors = {anchor};
  // raw, printed 95 ± 13.2 mN: 1.96 standard errors are 7.8 mN
  result.rawPeak = analysis::SampleStatistics{0.0880, 0.004, 0.0003};
  auto verdicts = verdictsOf(result, *experiment);
  EXPECT_FALSE(verdicts.front().isMet);
  const auto raw = [&] {
    for (const Verdict& each : verdicts)
      if (each.what == "mean raw force at the basal turn") return each;
    ADD_FAILURE();
    return Verdict{};
  };
  EXPECT_TRUE(raw().isMet);
  EXPECT_EQ(raw().wanted, "95.0 ± 7.8 mN");
  result.rawPeak->mean = 0.0860;
  verdicts = verdictsOf(result, *experiment);
  EXPECT_FALSE(raw().isMet);
  // where their number is not known, only the standard deviation is left
  experiment->insertions = 0.0;
  verdicts = verdictsOf(result, *experiment);
  EXPECT_TRUE(verdicts.front().isMet);
}

TEST(Verdicts, JudgeTheSpreadAtEachPrintedValue)
{
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  ASSERT_EQ(experiment->insertions, 11.0);
  ValidationResult result;
  // too narrow twice, and wide enough at the end that the mean over all is as wide as the experiment
  constexpr double found[] = {0.004, 0.005, 0.014, 0.040};
  for (std::size_t i = 0; i < 4; ++i) {
    AnchorComparison anchor;
    anchor.experiment = experiment->points.at(i);
    anchor.simulator = {anchor.experiment.mean, found[i], 0.001};
    result.anchors.push_back(anchor);
  }
  std::vector<Verdict> spreads;
  for (const Verdict& each : verdictsOf(result, *experiment))
    if (each.what.starts_with("standard deviation")) spreads.push_back(each);
  ASSERT_EQ(spreads.size(), 4u);
  EXPECT_EQ(spreads[0].what, "standard deviation at 10.6 mm, peak");
  EXPECT_EQ(spreads[0].found, "4.0 mN");
  // 18.6 mN times sqrt(10 / 20.4832) and sqrt(10 / 3.24697): Abramowitz and Stegun, table 26.8
  EXPECT_EQ(spreads[0].wanted, "13.0 to 32.6 mN");
  EXPECT_FALSE(spreads[0].isMet);
  EXPECT_FALSE(spreads[1].isMet);
  EXPECT_EQ(spreads[2].wanted, "13.2 to 33.2 mN");
  EXPECT_TRUE(spreads[2].isMet);
  EXPECT_TRUE(spreads[3].isMet);
  analysis::Reference unknown = *experiment;
  unknown.insertions = 0.0;
  for (const Verdict& each : verdictsOf(result, unknown))
    EXPECT_FALSE(each.what.starts_with("standard deviation")) << each.what;
}

TEST(ChiSquare, IsExceededWithTheProbabilityOfItsTables)
{
  // the same tables
  EXPECT_NEAR(chiSquareExceededBy(0.025, 10), 20.4832, 1e-4);
  EXPECT_NEAR(chiSquareExceededBy(0.975, 10), 3.24697, 1e-5);
  EXPECT_NEAR(chiSquareExceededBy(0.05, 1), 3.84146, 1e-5);
  EXPECT_NEAR(chiSquareExceededBy(0.95, 5), 1.145476, 1e-6);
}

TEST(ChiSquare, GivesTheProbabilityOfMoreThanAValue)
{
  // Quantiles of the chi-square distribution (Abramowitz and Stegun 1964, table 26.8).
  EXPECT_NEAR(chiSquareTail(3.84146, 1), 0.05, 1e-6);
  EXPECT_NEAR(chiSquareTail(6.63490, 1), 0.01, 1e-6);
  EXPECT_NEAR(chiSquareTail(5.99146, 2), 0.05, 1e-6);
  EXPECT_NEAR(chiSquareTail(7.81473, 3), 0.05, 1e-6);
  EXPECT_NEAR(chiSquareTail(11.0705, 5), 0.05, 1e-6);
  EXPECT_NEAR(chiSquareTail(16.8119, 6), 0.01, 1e-6);
  EXPECT_EQ(chiSquareTail(7.0, 0), 1.0);
}

TEST(Agreement, CountsPredictedForcesByTheStandardErrorsOfTheirMeans)
{
  ValidationResult result;
  AnchorComparison fitted;
  fitted.experiment.feature = fittedFeature;
  fitted.difference = {0.030, 0.02, 0.010};  // not predicted
  AnchorComparison predicted;
  predicted.difference = {-0.020, 0.02, 0.010};
  result.anchors = {fitted, predicted};
  IntervalComparison interval;
  interval.difference = 0.015;
  interval.standardError = 0.005;
  result.intervals = {interval};
  const Agreement agreement = agreementOf(result);
  EXPECT_DOUBLE_EQ(agreement.largest, 0.020);
  EXPECT_DOUBLE_EQ(agreement.chiSquare, 4.0 + 9.0);
  EXPECT_EQ(agreement.degreesOfFreedom, 2);
  EXPECT_DOUBLE_EQ(agreement.pValue, std::exp(-6.5));
}

}  // namespace
}  // namespace perilymph::validation

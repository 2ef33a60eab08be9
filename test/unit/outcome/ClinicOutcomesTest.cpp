// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicOutcomes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "perilymph/foundation/Seal.h"

namespace perilymph::outcome {
namespace {

/// A plan whose simulations end at 1 to 99 mm/3, so that percentiles are known.
MeasuredOutcome outcomeAt(double depth_mm, const std::string& utc,
                          const std::string& array = "flex28")
{
  MeasuredOutcome outcome;
  outcome.surgeryUtc = utc;
  outcome.array = array;
  outcome.surgery.array = array;
  outcome.depth_mm = {depth_mm, 0.0};
  for (int i = 1; i <= 99; ++i) {
    outcome.plan.depths_mm.push_back(i / 3.0);
    outcome.plan.angles_deg.push_back(10.0 * i);
  }
  outcome.plan.insertable_mm = 34.0;  // beyond all depths of these tests
  outcome.plan.friction = 0.165;
  return outcome;
}

TEST(PercentileAmong, IsTheRankOfAFurtherValueWidenedByItsError)
{
  const std::vector<double> simulated = {1.0, 2.0, 3.0};
  EXPECT_DOUBLE_EQ(percentileAmong(simulated, {0.0, 0.0}), 0.125);
  EXPECT_DOUBLE_EQ(percentileAmong(simulated, {2.5, 0.0}), 0.625);
  EXPECT_DOUBLE_EQ(percentileAmong(simulated, {2.0, 5.0}), 0.5);
  EXPECT_NEAR(percentileAmong(simulated, {2.5, 1e6}), 0.5, 1e-6);
}

TEST(ClinicOutcomes, CountCoverageWithWilsonIntervalsByArray)
{
  std::vector<MeasuredOutcome> outcomes;
  // depths i + 0.5 of 99: percentiles 0.1, 0.3, 0.5, 0.97 with flex28, 0.02 with flex24
  for (const double percent : {10.0, 30.0, 50.0, 97.0})
    outcomes.push_back(outcomeAt(percent / 3.0, "2026-01-01T00:00:00Z"));
  outcomes.push_back(outcomeAt(2.0 / 3.0, "2026-01-02T00:00:00Z", "flex24"));
  const auto clinic = compareOutcomes(outcomes);
  ASSERT_TRUE(clinic) << clinic.error().message;
  ASSERT_EQ(clinic->arrays.size(), 3u);
  const ArrayOutcomes &all = clinic->arrays[0], &flex24 = clinic->arrays[1],
                      &flex28 = clinic->arrays[2];
  EXPECT_EQ(all.array, "");
  EXPECT_EQ(flex24.array, "flex24");
  EXPECT_EQ(flex28.depth.all, 4u);
  EXPECT_EQ(flex28.depth.inHalf, 2u);
  EXPECT_EQ(flex28.depth.inNinety, 3u);
  EXPECT_EQ(all.depth.inNinety, 3u);
  // Wilson, 3 of 4: (p + z^2/2n +- z sqrt(p q / n + z^2 / 4 n^2)) / (1 + z^2 / n) with z = 1.96
  EXPECT_NEAR(flex28.depth.ninety().low, 0.3006, 1e-4);
  EXPECT_NEAR(flex28.depth.ninety().high, 0.9544, 1e-4);
  EXPECT_EQ(std::accumulate(all.depthPercentiles.begin(), all.depthPercentiles.end(), 0u), 5u);
  EXPECT_EQ(all.depthPercentiles[0], 1u);
  EXPECT_EQ(all.depthPercentiles[9], 1u);
  // no reason for the stop was given
  EXPECT_NE(outcomesText(*clinic).find("0 of 5 outcomes are informative"), std::string::npos);
}

TEST(ClinicOutcomes, AreRefusedBeyondTheLengthOfTheirArray)
{
  MeasuredOutcome outcome = outcomeAt(28.8, "2026-01-01");
  outcome.plan.insertable_mm = 28.0;
  outcome.depth_mm.sd = 0.3;
  EXPECT_TRUE(checkOutcome(outcome, "ear"));  // within three errors
  outcome.depth_mm.value = 53.6;
  const auto checked = checkOutcome(outcome, "ear");
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().message.find(
                "The inserted length of ear is 53.6 mm, and flex28 is 28 mm long."),
            0u)
      << checked.error().message;
  outcome.plan.insertable_mm = 0.0;  // not known
  EXPECT_TRUE(checkOutcome(outcome, "ear"));
}

TEST(ClinicOutcomes, AreScoredInTheOrderOfSurgery)
{
  planning::StopDraws stops;
  stops.logFrictionSd = 0.3465;
  for (int i = -10; i <= 10; ++i) {
    planning::StopDraw draw;
    draw.logFriction = 0.06 * i;
    draw.intended_mm = draw.end_mm = 60.0;
    for (std::size_t g = 0; g < planning::stopShifts; ++g)
      draw.stop_mm[g] = 20.0 + 10.0 * (planning::stopShift(g) - draw.logFriction);
    stops.draws.push_back(draw);
  }
  std::vector<MeasuredOutcome> outcomes = {outcomeAt(26.0, "2026-05-01T00:00:00Z"),
                                           outcomeAt(25.0, "2024-03-01T00:00:00Z"),
                                           outcomeAt(24.0, "2025-03-01T00:00:00Z")};
  for (MeasuredOutcome& each : outcomes) {
    each.plan.stops = stops;
    each.surgery.stopReason = StopReason::resistance;
  }
  const auto clinic = compareOutcomes(outcomes);
  ASSERT_TRUE(clinic) << clinic.error().message;
  ASSERT_EQ(clinic->ears.size(), 3u);
  EXPECT_EQ(clinic->ears[0].year, 2024);
  EXPECT_EQ(clinic->ears[2].year, 2026);
  // nothing is known before the first
  EXPECT_EQ(clinic->ears[0].resistance->logClinic, clinic->ears[0].resistance->logShipped);
  EXPECT_NE(clinic->ears[1].resistance->logClinic, clinic->ears[1].resistance->logShipped);
  // the last one's scores need the first two alone: without it, they are the same
  outcomes.erase(outcomes.begin());
  const auto before = compareOutcomes(outcomes);
  ASSERT_TRUE(before);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(before->ears[i].resistance->logClinic, clinic->ears[i].resistance->logClinic);
  // another friction: f counts from one
  outcomes.push_back(outcomeAt(26.0, "2027-05-01T00:00:00Z"));
  outcomes.back().plan.stops = stops;
  outcomes.back().plan.friction = 0.12;
  const auto mixed = compareOutcomes(outcomes);
  ASSERT_TRUE(mixed);
  EXPECT_FALSE(mixed->ears[2].resistance);
}

TEST(ClinicOutcomes, LearnTheShiftOfAnglesFromTheAnglesAlone)
{
  std::vector<MeasuredOutcome> outcomes(8, outcomeAt(11.0, "2026-01-01T00:00:00Z"));
  // simulations have 30 degrees a millimeter, exactly: 330 degrees at 11 mm
  for (MeasuredOutcome& each : outcomes) each.angle_deg = Uncertain{350.0, 10.0};
  const auto clinic = compareOutcomes(outcomes);
  ASSERT_TRUE(clinic);
  // precision 8 / 10^2 beside 1 / 20^2
  EXPECT_NEAR(clinic->angleOffset.mean_deg, 20.0 * 0.08 / (0.08 + 0.0025), 1e-6);
  EXPECT_EQ(clinic->resistance.cells(), planning::resistancePrior());
}

TEST(ClinicOutcomes, AreWrittenWithoutADateAndWithAMeaningForEveryColumn)
{
  const auto clinic = compareOutcomes({outcomeAt(11.0, "2026-07-19T00:00:00Z")});
  ASSERT_TRUE(clinic);
  const std::string json = outcomesJson(*clinic), csv = outcomesCsv(*clinic);
  EXPECT_EQ(sealIn(json, true), Seal::intact);
  for (const std::string& text : {json, csv, outcomesText(*clinic)})
    EXPECT_EQ(text.find("07-19"), std::string::npos);
  const std::string dictionary = outcomesDictionaryCsv();
  EXPECT_EQ(std::count(dictionary.begin(), dictionary.end(), '\n'),
            static_cast<std::ptrdiff_t>(outcomesColumns().size()) + 1);
  const auto commasIn = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  const std::size_t end = csv.find('\n');
  EXPECT_EQ(commasIn(csv.substr(0, end)), commasIn(csv.substr(end + 1)));
  const auto figures = outcomesFigures(*clinic);
  ASSERT_EQ(figures.size(), 2u);
  const figures::FigureAxis& ears = figures[1].second.y;  // there is no half ear
  EXPECT_EQ(ears.tick, std::floor(ears.tick));
  EXPECT_GE(ears.tick, 1.0);
  EXPECT_EQ(ears.decimals, 0);
}

TEST(ClinicOutcomes, RefuseValuesThatNoEarHasInOneSentence)
{
  const auto refused = [](const MeasuredOutcome& outcome) {
    const auto clinic = compareOutcomes({outcome});
    return clinic ? std::string() : std::string(clinic.error().message);
  };
  EXPECT_NE(refused(outcomeAt(80.0, "2026")).find("The inserted length [mm] of ear 1"),
            std::string::npos);
  EXPECT_NE(refused(outcomeAt(std::nan(""), "2026")).find("The inserted length"),
            std::string::npos);
  auto negative = outcomeAt(11.0, "2026");
  negative.depth_mm.sd = -0.1;
  EXPECT_NE(refused(negative).find("standard deviation -0.1"), std::string::npos);
  auto wide = outcomeAt(11.0, "2026");
  wide.depth_mm.sd = 1e5;
  EXPECT_NE(refused(wide).find("0 to 120"), std::string::npos);
  auto empty = outcomeAt(11.0, "2026");
  empty.plan.depths_mm.clear();
  EXPECT_NE(refused(empty).find("has no simulation of flex28"), std::string::npos);
  auto surgery = outcomeAt(11.0, "2026");
  surgery.surgery.attempts = 0;
  EXPECT_NE(refused(surgery).find("Attempts is"), std::string::npos);
  const auto none = compareOutcomes({});
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->ears.empty());
}

}  // namespace
}  // namespace perilymph::outcome

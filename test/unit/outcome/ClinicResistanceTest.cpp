// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicResistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "perilymph/analysis/RandomStream.h"

namespace perilymph::outcome {
namespace {

using planning::frictionShifts;
using planning::ResistanceCells;
using planning::StopDraw;
using planning::StopDraws;
using planning::stopShifts;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Place of no shift on both grids.
constexpr std::size_t middleF = (frictionShifts - 1) / 2, middleG = (stopShifts - 1) / 2;

double at(const ResistanceCells& cells, std::size_t f, std::size_t g)
{
  return cells[f * stopShifts + g];
}

double sumOf(const ResistanceCells& cells)
{
  return std::accumulate(cells.begin(), cells.end(), 0.0);
}

/// A simulation in which depth falls with friction and rises with the limit: L = 20 + 10 (g - u).
StopDraw linearDraw(double logFriction)
{
  StopDraw draw;
  draw.logFriction = logFriction;
  draw.intended_mm = 60.0;
  draw.end_mm = 60.0;
  for (std::size_t g = 0; g < stopShifts; ++g)
    draw.stop_mm[g] = 20.0 + 10.0 * (planning::stopShift(g) - logFriction);
  return draw;
}

/// Simulations at the quantiles of N(0, s^2): equally probable frictions, without chance.
StopDraws linearDraws(std::size_t count, double sd = 0.3465)
{
  StopDraws draws;
  draws.logFrictionSd = sd;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    double low = -6.0, high = 6.0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (0.5 * std::erfc(-middle / std::numbers::sqrt2) < wanted ? low : high) = middle;
    }
    draws.draws.push_back(linearDraw(sd * low));
  }
  return draws;
}

InsertedLength lengthOf(double length_mm, Evidence evidence)
{
  return {evidence, length_mm, 0.3, 28.0, 2026};
}

TEST(ResistanceGrid, CoversThreeDeviationsOfBothShiftsAndAddsUpToOne)
{
  EXPECT_DOUBLE_EQ(planning::frictionShift(0), -0.84);
  EXPECT_DOUBLE_EQ(planning::frictionShift(frictionShifts - 1), 0.84);
  EXPECT_NEAR(planning::frictionShift(middleF), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(planning::stopShift(stopShifts - 1), 0.75);
  const ResistanceCells prior = planning::resistancePrior();
  EXPECT_NEAR(sumOf(prior), 1.0, 1e-12);
  double f2 = 0.0, g2 = 0.0;
  for (std::size_t f = 0; f < frictionShifts; ++f)
    for (std::size_t g = 0; g < stopShifts; ++g) {
      f2 += at(prior, f, g) * planning::frictionShift(f) * planning::frictionShift(f);
      g2 += at(prior, f, g) * planning::stopShift(g) * planning::stopShift(g);
    }
  // a normal cut at three deviations has 0.9733 of its variance; both ends of the grid count in full
  EXPECT_NEAR(std::sqrt(f2), 0.28, 0.28 * 0.02);
  EXPECT_NEAR(std::sqrt(g2), 0.25, 0.25 * 0.02);
}

TEST(FrictionWeights, AddUpToOneAndGiveTheFrictionsOfEarsInTheClinic)
{
  const StopDraws draws = linearDraws(4000);
  for (const std::size_t f : {middleF - 5, middleF, middleF + 5}) {
    const auto weights = planning::frictionWeights(draws, f);
    double sum = 0.0, mean = 0.0, square = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      sum += weights[k];
      mean += weights[k] * draws.draws[k].logFriction;
      square += weights[k] * draws.draws[k].logFriction * draws.draws[k].logFriction;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    // kappa: N(f, 0.20^2 + 0.10^2), whatever the frictions were drawn from
    EXPECT_NEAR(mean, planning::frictionShift(f), 0.01);
    EXPECT_NEAR(std::sqrt(square - mean * mean), std::sqrt(0.05), 0.01);
  }
}

TEST(Likelihood, OfOneSimulationIsANormalDensityOrDistribution)
{
  StopDraws one;
  one.logFrictionSd = 0.3465;
  one.draws = {linearDraw(0.0)};
  const double s = std::sqrt(0.3 * 0.3 + 0.7 * 0.7);
  const auto resisted = likelihoodOf(lengthOf(21.0, Evidence::resisted), one);
  const auto censored = likelihoodOf(lengthOf(21.0, Evidence::censored), one);
  for (const std::size_t g : {middleG - 3, middleG, middleG + 4}) {
    const double off = (one.draws[0].stop_mm[g] - 21.0) / s;
    const double density = std::exp(-0.5 * off * off) / std::sqrt(2.0 * std::numbers::pi) / s;
    EXPECT_NEAR(at(resisted, middleF, g), 0.95 * density + 0.05 / 28.0, 1e-12);
    EXPECT_NEAR(at(resisted, 3, g), at(resisted, middleF, g),
                1e-12);  // one simulation has weight 1
    EXPECT_NEAR(at(censored, middleF, g), 0.5 * std::erfc(-off / std::numbers::sqrt2), 1e-12);
  }
  for (const double each : likelihoodOf(lengthOf(21.0, Evidence::none), one)) EXPECT_EQ(each, 1.0);
}

TEST(Likelihood, CountsASimulationThatNeverStopsAsNoStopAndAsACensoredOne)
{
  StopDraws one;
  one.logFrictionSd = 0.3465;
  one.draws = {linearDraw(0.0)};
  one.draws[0].stop_mm.fill(infinity);
  EXPECT_NEAR(at(likelihoodOf(lengthOf(21.0, Evidence::resisted), one), 0, 0), 0.05 / 28.0, 1e-12);
  EXPECT_EQ(at(likelihoodOf(lengthOf(21.0, Evidence::censored), one), 0, 0), 1.0);
}

TEST(Posterior, IsThePriorWithoutInformativeOutcomes)
{
  ResistancePosterior posterior;
  const StopDraws draws = linearDraws(64);
  for (int i = 0; i < 20; ++i) {
    const auto score = posterior.add(lengthOf(15.0, Evidence::none), draws);
    EXPECT_EQ(score.logClinic, 0.0);
    EXPECT_EQ(score.percentile, score.shippedPercentile);
  }
  EXPECT_EQ(posterior.cells(), planning::resistancePrior());
  EXPECT_EQ(posterior.count(Evidence::none), 20u);
  EXPECT_FALSE(posterior.isOffered());
}

TEST(Posterior, IsTemperedByOneHalf)
{
  const StopDraws draws = linearDraws(64);
  const InsertedLength inserted = lengthOf(17.0, Evidence::resisted);
  ResistancePosterior posterior;
  posterior.add(inserted, draws);
  const ResistanceCells prior = planning::resistancePrior(),
                        likelihood = likelihoodOf(inserted, draws);
  const auto ratio = [&](const ResistanceCells& cells) {
    return at(cells, middleF + 4, middleG) / at(cells, middleF - 4, middleG + 2);
  };
  EXPECT_NEAR(ratio(posterior.cells()), ratio(prior) * std::sqrt(ratio(likelihood)),
              1e-9 * ratio(posterior.cells()));
  EXPECT_NEAR(sumOf(posterior.cells()), 1.0, 1e-12);
}

/// A clinic whose lengths follow L = 20 + 10 (g - f - e) with e between ears, exactly the simulations' law.
ResistancePosterior clinicWith(double f, double g, std::size_t patients)
{
  const StopDraws draws = linearDraws(128);
  analysis::RandomStream random(8'750'005, 1, 1);
  ResistancePosterior posterior;
  for (std::size_t i = 0; i < patients; ++i) {
    const double ear = 0.2 * random.normal();
    posterior.add(lengthOf(20.0 + 10.0 * (g - f - ear) + 0.3 * random.normal(), Evidence::resisted),
                  draws);
  }
  return posterior;
}

TEST(Posterior, RecoversTheShiftOfStopLengthsWhereTheModelIsExact)
{
  for (const double shift : {-0.4, 0.0, 0.4}) {
    const ResistancePosterior posterior = clinicWith(-0.5 * shift, 0.5 * shift, 60);
    // only g - f is in the lengths. Its error: 0.2 / sqrt(60) between ears, and twice the SD of the
    // tempered posterior, sqrt(2 / 60) (0.2 + 0.1)
    EXPECT_NEAR(posterior.meanStopShift() - posterior.meanFrictionShift(), shift, 0.1) << shift;
    // both share it by the variances of their priors: 0.25^2 to 0.28^2
    EXPECT_NEAR(posterior.meanStopShift(), shift * 0.25 * 0.25 / (0.25 * 0.25 + 0.28 * 0.28), 0.1);
  }
}

TEST(Posterior, NeverNarrowsWhatDiffersBetweenEars)
{
  const ResistancePosterior posterior = clinicWith(0.0, 0.0, 200);
  const planning::WeightedDepths depths = planning::depthsIn(posterior.cells(), linearDraws(1000));
  // 10 mm a unit of ln friction: at least 0.20 of it between ears, +-1.645 of it in the 90 % band
  const planning::Band band = depths.band();
  EXPECT_GT(band.high - band.low, 2.0 * 1.645 * 10.0 * 0.20);
  // and the prior's is wider: sqrt(0.28^2 + 0.25^2 + 0.05) instead of some sqrt(0.05)
  const planning::Band prior =
      planning::depthsIn(planning::resistancePrior(), linearDraws(1000)).band();
  EXPECT_GT(prior.high - prior.low, 1.3 * (band.high - band.low));
}

TEST(Posterior, ScoresEveryPatientByThoseBefore)
{
  const StopDraws draws = linearDraws(128);
  ResistancePosterior posterior;
  const InsertedLength inserted = lengthOf(26.0, Evidence::resisted);
  const auto first = posterior.add(inserted, draws);
  EXPECT_EQ(first.logClinic, first.logShipped);
  EXPECT_EQ(first.percentile, first.shippedPercentile);
  const auto second = posterior.add(inserted, draws);
  EXPECT_EQ(second.logShipped, first.logShipped);
  EXPECT_GT(second.logClinic, second.logShipped);
  EXPECT_LT(second.percentile, second.shippedPercentile);
  EXPECT_FALSE(second.isOffered);
}

TEST(Posterior, IsOfferedFromFiveStopsAndAGainOfThreeOn)
{
  const StopDraws draws = linearDraws(128);
  ResistancePosterior posterior;
  for (int i = 0; i < 40; ++i) {
    const bool isBefore = posterior.isOffered();
    EXPECT_EQ(isBefore, posterior.count(Evidence::resisted) >= 5 && posterior.logScore() >= 3.0);
    EXPECT_EQ(posterior.add(lengthOf(26.0, Evidence::resisted), draws).isOffered, isBefore);
  }
  EXPECT_TRUE(posterior.isOffered());
  // censored lengths alone never offer it
  ResistancePosterior censored;
  for (int i = 0; i < 40; ++i) censored.add(lengthOf(30.0, Evidence::censored), draws);
  EXPECT_FALSE(censored.isOffered());
}

TEST(Posterior, StaysFiniteWhereNoSimulationExplainsALength)
{
  ResistancePosterior posterior;
  const StopDraws draws = linearDraws(32);
  for (int i = 0; i < 200; ++i) posterior.add(lengthOf(59.0, Evidence::censored), draws);
  EXPECT_NEAR(sumOf(posterior.cells()), 1.0, 1e-9);
}

TEST(Evidence, IsWhatTheSurgeonSaysUnlessTheArrayIsDisplacedOrWasInsertedAgain)
{
  Surgery surgery;
  EXPECT_EQ(evidenceOf(surgery, false), Evidence::none);
  surgery.stopReason = StopReason::resistance;
  EXPECT_EQ(evidenceOf(surgery, false), Evidence::resisted);
  EXPECT_EQ(evidenceOf(surgery, true), Evidence::none);
  surgery.attempts = 2;
  EXPECT_EQ(evidenceOf(surgery, false), Evidence::none);
  surgery.attempts = 1;
  for (const StopReason reason : {StopReason::mark, StopReason::hearing, StopReason::bleeding}) {
    surgery.stopReason = reason;
    EXPECT_EQ(evidenceOf(surgery, false), Evidence::censored);
  }
  for (const StopReason reason : {StopReason::buckling, StopReason::other}) {
    surgery.stopReason = reason;
    EXPECT_EQ(evidenceOf(surgery, false), Evidence::none);
  }
}

TEST(WeightedDepths, HaveTheQuantilesOfAFurtherValue)
{
  planning::WeightedDepths depths;
  constexpr std::size_t count = 99;
  for (std::size_t i = 1; i <= count; ++i)
    depths.depths_mm.emplace_back(static_cast<double>(i), 1.0 / count);
  depths.effective = count;
  // the i-th of n is the quantile i / (n + 1)
  EXPECT_NEAR(depths.band().low, 5.0, 1e-9);
  EXPECT_NEAR(depths.band().median, 50.0, 1e-9);
  EXPECT_NEAR(depths.band().high, 95.0, 1e-9);
  EXPECT_NEAR(depths.percentile(50.0, 0.0), 0.5, 1e-9);
  EXPECT_NEAR(depths.percentile(0.0, 0.0), 0.5 / 100.0, 1e-9);
  EXPECT_NEAR(depths.percentile(1000.0, 1.0), 99.5 / 100.0, 1e-9);
}

TEST(AngleOffset, IsTheMeanOfANormalWithTwentyDegreesBefore)
{
  AngleOffset offset;
  for (int i = 0; i < 4; ++i) offset.add(30.0, 20.0);
  // five equal weights, one of them at 0
  EXPECT_NEAR(offset.mean_deg, 24.0, 1e-9);
  EXPECT_NEAR(offset.sd_deg, 20.0 / std::sqrt(5.0), 1e-9);
}

planning::ClinicResistance someClinic()
{
  ResistancePosterior posterior = clinicWith(0.2, -0.1, 12);
  return posterior.resistance(0.165);
}

TEST(ClinicResistanceFile, IsReadAsItWasWritten)
{
  const planning::ClinicResistance clinic = someClinic();
  const std::string text = planning::clinicResistanceText(clinic);
  const auto read = planning::clinicResistanceIn(text, "clinic.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->resisted, 12u);
  EXPECT_EQ(read->censored, 0u);
  EXPECT_EQ(read->firstYear, 2026);
  EXPECT_EQ(read->lastYear, 2026);
  EXPECT_DOUBLE_EQ(read->friction, 0.165);
  EXPECT_EQ(read->number.size(), 64u);
  for (std::size_t i = 0; i < clinic.cells.size(); ++i)
    EXPECT_NEAR(read->cells[i], clinic.cells[i], 1e-5 * clinic.cells[i] + 1e-12);
  // neither a code nor a date: years alone
  EXPECT_EQ(text.find("2026-"), std::string::npos);
}

TEST(ClinicResistanceFile, RefusesWhatWasChangedAndWhatIsNone)
{
  const std::string text = planning::clinicResistanceText(someClinic());
  std::string changed = text;
  changed.replace(changed.find("\"stopped_by_resistance\": 12"), 27,
                  "\"stopped_by_resistance\": 13");
  const auto refused = planning::clinicResistanceIn(changed, "clinic.json");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("was changed after the program wrote it"),
            std::string::npos);
  for (const std::string& bad :
       {std::string("no JSON"), std::string("[1]"), std::string("{}"), text.substr(0, 400)}) {
    const auto none = planning::clinicResistanceIn(bad, "clinic.json");
    ASSERT_FALSE(none) << bad;
    EXPECT_NE(none.error().message.find("clinic.json is not the resistance of a clinic"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace perilymph::outcome

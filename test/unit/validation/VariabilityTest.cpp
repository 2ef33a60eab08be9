// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/Variability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"

namespace perilymph::validation {
namespace {

using testing::HasSubstr;

const char* shipped = "resources/validation/published-experiment.toml";

class DrawnInsertions : public testing::Test {
protected:
  void SetUp() override
  {
    const auto loaded = loadVariability(resource(shipped));
    ASSERT_TRUE(loaded) << loaded.error().message;
    variability = *loaded;
    const auto scenario = session::loadScenario(variability.scenario);
    ASSERT_TRUE(scenario) << scenario.error().message;
    nominal = scenario->parameters();
  }

  DrawnInsertion drawn(SpreadSources sources, std::uint64_t number)
  {
    return drawInsertion(nominal, variability, sources, 1, number);
  }

  Variability variability;
  session::InsertionParameters nominal;
};

TEST_F(DrawnInsertions, StartTwoMillimetersInsideWithinThreeTenths)
{
  std::vector<double> starts_mm;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const double start_mm =
        inMillimeters(drawn(SpreadSources::all(), number).parameters.startInside);
    EXPECT_GE(start_mm, 1.7);
    EXPECT_LE(start_mm, 2.3);
    starts_mm.push_back(start_mm);
  }
  // uniform: mean 2, standard deviation 0.6 / sqrt(12)
  const analysis::SampleStatistics statistics = analysis::statisticsOf(starts_mm);
  EXPECT_NEAR(statistics.mean, 2.0, 4.0 * 0.6 / std::sqrt(12.0 * 400.0));
  EXPECT_NEAR(statistics.standardDeviation, 0.6 / std::sqrt(12.0), 0.018);
}

TEST_F(DrawnInsertions, KeepTheMeanOfTheFriction)
{
  std::vector<double> factors;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const mechanics::FrictionLaw law = drawn(SpreadSources::all(), number).parameters.friction;
    factors.push_back(law.kineticCoefficient / nominal.friction.kineticCoefficient);
    EXPECT_LE(law.kineticCoefficient, law.staticCoefficient);
    EXPECT_LE(law.stoppingCoefficient, law.kineticCoefficient);
  }
  const analysis::SampleStatistics statistics = analysis::statisticsOf(factors);
  EXPECT_NEAR(statistics.mean, 1.0, 4.0 * variability.frictionDeviation / std::sqrt(2000.0));
  EXPECT_NEAR(statistics.standardDeviation, variability.frictionDeviation, 0.03);
}

TEST_F(DrawnInsertions, WithoutASourceKeepTheScenariosOwnValues)
{
  const DrawnInsertion same = drawn(SpreadSources::none(), 5);
  EXPECT_EQ(same.parameters.startInside, nominal.startInside);
  EXPECT_EQ(same.parameters.approachTilt, nominal.approachTilt);
  EXPECT_EQ(same.parameters.approachTurn, nominal.approachTurn);
  EXPECT_EQ(same.parameters.friction.kineticCoefficient, nominal.friction.kineticCoefficient);
  EXPECT_EQ(same.parameters.array.stylet.residualCurvature, nominal.array.stylet.residualCurvature);
  EXPECT_EQ(same.push.speed, nominal.speed.si());
  EXPECT_EQ(same.push.tremorAmplitude, 0.0);
  EXPECT_EQ(same.noiseDeviation, 0.0);
}

TEST_F(DrawnInsertions, DrawTheSameForOneSourceWhicheverOthersAct)
{
  const DrawnInsertion all = drawn(SpreadSources::all(), 17);
  EXPECT_EQ(drawn(SpreadSources::only(SpreadSource::start), 17).parameters.startInside,
            all.parameters.startInside);
  EXPECT_EQ(
      drawn(SpreadSources::only(SpreadSource::friction), 17).parameters.friction.kineticCoefficient,
      all.parameters.friction.kineticCoefficient);
  EXPECT_EQ(drawn(SpreadSources::only(SpreadSource::motion), 17).push.tremorPhase,
            all.push.tremorPhase);
}

TEST_F(DrawnInsertions, KeepTheNoiseOfTheCellBelowTwoMillinewtons)
{
  EXPECT_LE(variability.noiseDeviation, millinewtons(2));
}

TEST_F(DrawnInsertions, SayForEverySourceWhereItComesFrom)
{
  ASSERT_EQ(variability.provenance.size(), 7u);
  for (const auto& [table, source] : variability.provenance) EXPECT_GT(source.size(), 20u) << table;
}

TEST(VariabilityFile, IsRefusedWithTheLineOfTheError)
{
  const test::TemporaryFolder folder;
  const auto changed = [&](const std::string& from, const std::string& to) {
    const auto loaded =
        loadVariability(test::copyChanged(resource(shipped), folder / "v.toml", {{from, to}}));
    return loaded ? "accepted" : loaded.error().message;
  };
  EXPECT_THAT(changed("sd_N = 0.001", "sd_N = 3.0"), HasSubstr("sd_N"));
  EXPECT_THAT(changed("high_mm = 2.3", "high_mm = 0.5"), HasSubstr("below low_mm"));
  EXPECT_THAT(changed("tremor_Hz = 8.1", "tremor_hertz = 8.1"), HasSubstr("tremor_Hz"));
  EXPECT_THAT(changed("dt_ms = 5.0", "dt_ms = 7.0"), HasSubstr("without rest"));
}

}  // namespace
}  // namespace perilymph::validation

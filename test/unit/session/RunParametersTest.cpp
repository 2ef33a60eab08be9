// SPDX-License-Identifier: BSD-3-Clause

// The engine parameters that a device requires, and those that a replay reads back.

#include "perilymph/session/RunParameters.h"

#include <gtest/gtest.h>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

constexpr double timeStep = 1e-3;

device::DeviceTraits forceDevice()
{
  device::DeviceTraits traits;
  traits.rendersForce = true;
  traits.maxForce = 2.0;
  traits.nominalPeriod = 2e-3;
  traits.maxStiffness = 300.0;
  traits.maxDamping = 0.5;
  return traits;
}

TEST(RunParameters, TakeTheLowerBoundOfForceOfScenarioAndDevice)
{
  haptics::EngineSettings settings;
  for (const double limit : {1.0, 3.0}) {
    settings.safety.maxForce = limit;
    const RunParameters run = runParameters(settings.safety, forceDevice(), timeStep);
    EXPECT_EQ(withRunParameters(settings, run).safety.maxForce, std::min(limit, 2.0));
  }
}

TEST(RunParameters, CoupleADeviceThatRendersForcesByASpringWithinItsBounds)
{
  const RunParameters run = runParameters({}, forceDevice(), timeStep);
  EXPECT_TRUE(run.feelsForce);
  EXPECT_LE(run.maxStiffness, 300.0);
  EXPECT_LE(run.maxDamping, 0.5);
  const haptics::EngineSettings settings = withRunParameters({}, run);
  EXPECT_EQ(settings.coupling, mechanics::Coupling::spring);
  EXPECT_EQ(settings.samplePeriod, 2e-3);
  EXPECT_EQ(settings.maxStiffness, run.maxStiffness);
}

TEST(RunParameters, LeaveTheCouplingOfADeviceWithoutForceToTheScenario)
{
  const RunParameters run = runParameters({}, {}, timeStep);
  for (const auto coupling : {mechanics::Coupling::rigid, mechanics::Coupling::spring}) {
    haptics::EngineSettings settings;
    settings.coupling = coupling;
    EXPECT_EQ(withRunParameters(settings, run).coupling, coupling);
  }
}

TEST(RunParameters, AreReadBackFromARecordingToTheLastBit)
{
  const test::TemporaryFolder folder;
  RecordingFacts facts = test::someFacts();
  facts.run = runParameters({}, forceDevice(), timeStep);
  facts.run.reach = 0.1 + 0.2;
  {
    auto recording = Recording::create(folder / "run.insertion", facts);
    ASSERT_TRUE(recording);
    ASSERT_TRUE((*recording)->close());
  }
  const auto recorded = RecordedInsertion::open(folder / "run.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  const RunParameters& read = recorded->facts().run;
  EXPECT_EQ(read.samplePeriod, facts.run.samplePeriod);
  EXPECT_EQ(read.maxForce, facts.run.maxForce);
  EXPECT_EQ(read.offTime, facts.run.offTime);
  EXPECT_EQ(read.reach, facts.run.reach);
  EXPECT_EQ(read.feelsForce, facts.run.feelsForce);
  EXPECT_EQ(read.maxStiffness, facts.run.maxStiffness);
  EXPECT_EQ(read.maxDamping, facts.run.maxDamping);
}

}  // namespace
}  // namespace perilymph::session

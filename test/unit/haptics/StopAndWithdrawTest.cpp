// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

using device::ScriptedDevice;
using Kind = Command::Kind;

constexpr double nanometer = 1e-9;

/// Distance to the stop. A base on a spring decelerates on arrival, and travel is measured along
/// the array, which this strains by some nanometers.
double nearness(mechanics::Coupling coupling)
{
  return coupling == mechanics::Coupling::rigid ? nanometer : 50 * nanometer;
}

EngineSettings stoppingAt(double travel, mechanics::Coupling coupling)
{
  EngineSettings settings;
  settings.stopTravel = travel;
  settings.coupling = coupling;
  return settings;
}

class Stop : public testing::TestWithParam<mechanics::Coupling> {};

TEST_P(Stop, IsExactWhateverTheSpeed)
{
  for (const double speed_mm_s : {0.7, 2.0, 33.0}) {
    test::InsertionRig rig(test::insertionInTube(), stoppingAt(3e-3, GetParam()),
                           millimetersPerSecond(speed_mm_s));
    rig.start();
    ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000)) << speed_mm_s;
    EXPECT_NEAR(rig.output().travel, 3e-3, nearness(GetParam())) << speed_mm_s;
  }
}

TEST_P(Stop, HoldsAgainstAHandThatPushesOn)
{
  test::InsertionRig rig(test::insertionInTube(), stoppingAt(1e-3, GetParam()));
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  for (int i = 0; i < 1000; ++i) {
    rig.tick();
    ASSERT_EQ(rig.output().workflow, Workflow::finished);
    ASSERT_NEAR(rig.output().travel, 1e-3, nearness(GetParam()));
  }
}

TEST_P(Stop, HoldsAgainstAHandThatPullsUntilItIsAskedToWithdraw)
{
  test::InsertionRig rig(test::insertionInTube(), stoppingAt(1e-3, GetParam()));
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  rig.device().move(ScriptedDevice::Motion::withdraw);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_NEAR(rig.output().travel, 1e-3, nearness(GetParam()));

  rig.send(Kind::withdraw);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_LT(rig.output().travel, 0.9e-3);
}

TEST_P(Stop, IsFinishedAgainWhenTheTipIsBackAtItsStart)
{
  test::InsertionRig rig(test::insertionInTube(), stoppingAt(1e-3, GetParam()));
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  rig.device().move(ScriptedDevice::Motion::withdraw);
  rig.send(Kind::withdraw);
  ASSERT_EQ(rig.tick().output.workflow, Workflow::inserting);
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  constexpr double oneTickOfMotion = 2e-3 * 1e-3;
  EXPECT_NEAR(rig.output().travel, 0.0, 2.0 * oneTickOfMotion);

  // nothing is left to withdraw
  rig.send(Kind::withdraw);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::finished);
}

INSTANTIATE_TEST_SUITE_P(Couplings, Stop,
                         testing::Values(mechanics::Coupling::rigid, mechanics::Coupling::spring),
                         [](const auto& coupling) {
                           return coupling.param == mechanics::Coupling::rigid ? "Rigid" : "Spring";
                         });

TEST(Withdraw, TurnsAroundInTheMiddleOfAnInsertionToo)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(1), 10'000));
  rig.device().move(ScriptedDevice::Motion::withdraw);
  rig.send(Kind::withdraw);
  EXPECT_EQ(rig.tick().output.workflow, Workflow::inserting);
  EXPECT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  EXPECT_LE(rig.output().travel, nanometer);
}

TEST(Withdraw, EndsWhereItBeganAndStaysThere)
{
  test::InsertionRig rig(test::insertionInTube(), stoppingAt(1e-3, mechanics::Coupling::rigid));
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  rig.device().move(ScriptedDevice::Motion::withdraw);
  rig.send(Kind::withdraw);
  rig.tick();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  const double travel = rig.output().travel;
  EXPECT_NEAR(travel, 0.0, nanometer);
  rig.device().move(ScriptedDevice::Motion::insert);
  rig.send(Kind::withdraw);
  for (int i = 0; i < 100; ++i) rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::finished);
  EXPECT_NEAR(rig.output().travel, travel, nanometer);
}

}  // namespace
}  // namespace perilymph::haptics

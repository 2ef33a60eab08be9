// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lumen/PlainLumens.h"
#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

constexpr double styletFromTip = 1e-3;  // [m]
constexpr double holdDepth = 6e-3;      // [m]

std::shared_ptr<const mechanics::InsertionModel> withStylet()
{
  mechanics::ModelParts parts;
  parts.lumen = std::make_shared<anatomy::StraightTube>(5e-3);
  parts.array = test::plainArray();
  parts.array.hasStylet = true;
  parts.array.stylet.fromTip = meters(styletFromTip);
  parts.array.stylet.bending = newtonSquareMeters(1e-6);
  parts.nodes = 40;
  parts.startInside = millimeters(2);
  return mechanics::InsertionModel::build(std::move(parts));
}

test::InsertionRig offStylet()
{
  EngineSettings settings;
  settings.stopTravel = 12e-3;
  settings.styletHoldDepth = holdDepth;
  return test::InsertionRig(withStylet(), settings, millimetersPerSecond(5));
}

TEST(AdvanceOffStylet, LeavesTheStyletInUntilItsTipIsAtTheHoldDepth)
{
  test::InsertionRig rig = offStylet();
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(4.9)));  // its tip at 2 + 4.9 - 1 mm
  EXPECT_EQ(rig.output().styletWithdrawal, 0.0);
}

TEST(AdvanceOffStylet, HoldsTheStyletStillWhileTheArrayGoesOn)
{
  test::InsertionRig rig = offStylet();
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(5.5)));
  constexpr double oneTick = 5e-6;  // the stylet follows the array of the previous tick
  while (rig.output().workflow == Workflow::inserting) {
    const TickOutput& now = rig.output();
    ASSERT_NEAR(now.depth - styletFromTip - now.styletWithdrawal, holdDepth, 1.01 * oneTick);
    rig.tick();
  }
  EXPECT_NEAR(rig.output().styletWithdrawal, 14e-3 - styletFromTip - holdDepth, 2 * oneTick);
}

TEST(AdvanceOffStylet, NeverPushesTheStyletBackIn)
{
  test::InsertionRig rig = offStylet();
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(10)));
  const double out = rig.output().styletWithdrawal;
  rig.send(Command::Kind::withdraw);
  rig.device().move(device::ScriptedDevice::Motion::withdraw);
  for (int i = 0; i < 1000; ++i) rig.tick();
  EXPECT_LT(rig.output().travel, 9e-3);
  EXPECT_GE(rig.output().styletWithdrawal, out);
  EXPECT_LT(rig.output().styletWithdrawal, out + 1e-4);
}

TEST(AdvanceOffStylet, StillLetsTheStyletBePulledAtTheEnd)
{
  test::InsertionRig rig = offStylet();
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished));
  rig.send(Command::Kind::pullStylet, 20e-3);
  for (int i = 0; i < 5000; ++i) rig.tick();
  EXPECT_DOUBLE_EQ(rig.output().styletWithdrawal, 20e-3);
}

TEST(StandardTechnique, LeavesTheStyletInToTheEnd)
{
  EngineSettings settings;
  settings.stopTravel = 12e-3;
  test::InsertionRig rig(withStylet(), settings, millimetersPerSecond(5));
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished));
  EXPECT_EQ(rig.output().styletWithdrawal, 0.0);
}

}  // namespace
}  // namespace perilymph::haptics

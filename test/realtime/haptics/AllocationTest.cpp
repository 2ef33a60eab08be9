// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

using device::ScriptedDevice;
using Kind = Command::Kind;

class HapticTick : public testing::Test {
protected:
  void SetUp() override
  {
    if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  }
};

TEST_F(HapticTick, AllocatesNothingWithTheArrayAlongTheWall)
{
  test::InsertionRig rig = test::InsertionRig::fullyInserted();
  ASSERT_GT(rig.output().contacts, 5u);
  const test::AllocationGuard guard;
  for (int i = 0; i < 1000; ++i) rig.tick();
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(guard.frees(), 0u);
}

TEST_F(HapticTick, AllocatesNothingFromTheVeryFirstTickThroughTheWholeWorkflow)
{
  test::InsertionRig rig(test::insertionInRing());
  const test::AllocationGuard guard;
  rig.start();
  for (int i = 0; i < 500; ++i) rig.tick();
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 50; ++i) rig.tick();
  rig.device().move(ScriptedDevice::Motion::withdraw);
  rig.send(Kind::pullStylet, 1e-3);
  rig.send(Kind::withdraw);
  for (int i = 0; i < 600; ++i) rig.tick();
  rig.loop().requestStop();
  for (int i = 0; i < 50; ++i) rig.tick();
  rig.send(Kind::resume);
  for (int i = 0; i < 50; ++i) rig.tick();
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST_F(HapticTick, AllocatesNothingWhileItRestsAndWhenItEndsTheRest)
{
  EngineSettings settings;
  settings.restAfter = 0.1;
  InsertionEngine engine(test::insertionInRing(), settings);
  device::DeviceSample sample;
  sample.isValid = 1;
  CommandList arm;
  arm.count = 1;
  arm.items[0].kind = Kind::arm;
  const test::AllocationGuard guard;
  engine.tick(sample, arm);
  int rested = 0;
  for (int i = 0; i < 2000; ++i) {
    ++sample.sequence;
    // half a second held, half a second released
    sample.buttons = i % 1000 < 500 ? device::graspButton : 0u;
    rested += (engine.tick(sample, {}).status & resting) != 0 ? 1 : 0;
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_NEAR(rested, 2 * 400, 20);
}

TEST_F(HapticTick, AllocatesNothingInSpringCoupling)
{
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  test::InsertionRig rig(test::insertionInRing(), settings);
  rig.start();
  const test::AllocationGuard guard;
  for (int i = 0; i < 4000; ++i) rig.tick();
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace perilymph::haptics

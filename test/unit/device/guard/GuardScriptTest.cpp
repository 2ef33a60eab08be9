// SPDX-License-Identifier: BSD-3-Clause

// The messages between a program and the guard of its device.

#include "guard/GuardScript.h"

#include <gtest/gtest.h>

#include <vector>

namespace perilymph::device::guard {
namespace {

using Bytes = std::vector<std::uint8_t>;

Script filled()
{
  Script script(50);
  const Bytes zero = {2, 0, 0}, off = {9, 1};
  EXPECT_TRUE(script.addNoForce({false, zero}));
  EXPECT_TRUE(script.addSwitchOff({true, off}));
  return script;
}

TEST(GuardScript, ArrivesAsItWasSent)
{
  const Script sent = filled();
  Script taken;
  ASSERT_TRUE(taken.take(sent.bytes()));
  EXPECT_EQ(taken.patience_ms(), 50);
  ASSERT_EQ(taken.noForceLines(), 1u);
  ASSERT_EQ(taken.lines(), 2u);
  EXPECT_FALSE(taken.line(0).isFeature);
  EXPECT_TRUE(taken.line(1).isFeature);
  EXPECT_EQ(Bytes(taken.line(1).bytes.begin(), taken.line(1).bytes.end()), (Bytes{9, 1}));
}

TEST(GuardScript, TellsItsSizeInItsHead)
{
  const Script script = filled();
  EXPECT_EQ(Script::sizeBehind(script.bytes().first(Script::head)),
            script.bytes().size() - Script::head);
}

TEST(GuardScript, IsNotTakenWhenAPieceIsMissing)
{
  const Script script = filled();
  for (std::size_t size = 0; size < script.bytes().size(); ++size)
    EXPECT_FALSE(Script().take(script.bytes().first(size))) << size;
}

TEST(GuardScript, IsNotTakenFromAnotherVersion)
{
  const Script script = filled();
  Bytes bytes(script.bytes().begin(), script.bytes().end());
  bytes[0] = version + 1;
  EXPECT_FALSE(Script().take(bytes));
}

TEST(GuardScript, RefusesAReportItHasNoRoomFor)
{
  Script script;
  const Bytes large(Script::capacity, 1);
  EXPECT_FALSE(script.addNoForce({false, large}));
  EXPECT_EQ(script.lines(), 0u);
}

}  // namespace
}  // namespace perilymph::device::guard

// SPDX-License-Identifier: BSD-3-Clause

// Tests of the scene used for devices, without any device.

#include "FlatWallScene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "perilymph/test/Tolerance.h"

namespace perilymph::hidstack {
namespace {

/// The force on a hand that moved in by a distance and stays there [N].
double forceAt(double way)
{
  const auto engine = flatWallEngine(1e-3);
  haptics::CommandList commands;
  commands.count = 1;
  commands.items[0].kind = haptics::Command::Kind::arm;
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  haptics::TickOutput output;
  for (int i = 0; i < 3000; ++i) {
    ++sample.sequence;
    sample.position_D[2] = -std::min(way, 1e-6 * i);
    output = engine->tick(sample, commands);
    commands.count = 0;
  }
  return output.wrench_D.force_D[2];
}

TEST(FlatWallScene, PushesNobodyBeforeTheWall)
{
  EXPECT_NEAR(forceAt(0.9 * freeWay), 0.0, test::tolerance(1e-5, "the solver leaves 2 uN"));
}

TEST(FlatWallScene, PushesBackLikeTheCouplingAlone)
{
  for (const double penetration : {0.2e-3, 0.4535e-3, 1e-3}) {
    const double force = couplingStiffness * penetration;
    EXPECT_NEAR(forceAt(freeWay + penetration), force,
                test::tolerance(0.01 * force, "rod and wall are not quite rigid"));
  }
}

}  // namespace
}  // namespace perilymph::hidstack

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/HapticLoop.h"

#include <gtest/gtest.h>

#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

/// A device that stores the forces written to it.
class ListeningDevice final : public device::HapticDevice {
public:
  device::DeviceTraits traits() const override
  {
    device::DeviceTraits traits;
    traits.name = "Listener";
    traits.rendersForce = true;
    traits.maxForce = 0.5;
    return traits;
  }
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override
  {
    device::DeviceSample sample;
    sample.sequence = ++sequence_;
    sample.isValid = 1;
    return sample;
  }
  void write(const device::Wrench& wrench_D) noexcept override
  {
    ++writes;
    shown = wrench_D;
  }

  int writes = 0;
  device::Wrench shown;

private:
  std::uint64_t sequence_ = 0;
};

TEST(HapticLoop, WritesOneWrenchATick)
{
  ListeningDevice device;
  HapticLoop loop(device,
                  std::make_unique<InsertionEngine>(test::insertionInTube(), EngineSettings{}));
  for (int i = 0; i < 10; ++i) loop.runOnce();
  EXPECT_EQ(device.writes, 10);
}

TEST(HapticLoop, LowersTheGreatestForceToTheDevicesOwn)
{
  ListeningDevice device;
  HapticLoop loop(device,
                  std::make_unique<InsertionEngine>(test::insertionInTube(), EngineSettings{}));
  EXPECT_EQ(loop.engine().safetyLimits().maxForce, 0.5);
}

TEST(HapticLoop, ShowsZeroForceWhenItStops)
{
  ListeningDevice device;
  {
    HapticLoop loop(device,
                    std::make_unique<InsertionEngine>(test::insertionInTube(), EngineSettings{}));
    loop.runOnce();
    device.shown.force_D = {1.0, 1.0, 1.0};
  }
  EXPECT_EQ(device.shown.force_D, (std::array<double, 3>{}));
}

TEST(HapticLoop, TakesEightRequestsAndSaysBusyToTheNinth)
{
  ListeningDevice device;
  HapticLoop loop(device,
                  std::make_unique<InsertionEngine>(test::insertionInTube(), EngineSettings{}));
  Command command;
  command.kind = Command::Kind::withdraw;
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(loop.send(command)) << i;
  EXPECT_FALSE(loop.send(command));
  loop.runOnce();
  EXPECT_TRUE(loop.send(command));
  TickRecord record;
  ASSERT_TRUE(loop.take(record));
  EXPECT_EQ(record.commands.count, 8u);
}

TEST(HapticLoop, HasAPictureBeforeTheFirstTick)
{
  ListeningDevice device;
  const auto model = test::insertionInTube();
  HapticLoop loop(device, std::make_unique<InsertionEngine>(model, EngineSettings{}));
  ASSERT_TRUE(loop.refresh());
  EXPECT_EQ(loop.latest().nodes, static_cast<std::uint32_t>(model->nodes));
  EXPECT_EQ(loop.latest().output.depth, 2e-3);
}

TEST(HapticLoop, PicturesTheArrayWhereItIs)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.start();
  for (int i = 0; i < 301; ++i) rig.tick();
  ASSERT_TRUE(rig.loop().refresh());
  const Snapshot& picture = rig.loop().latest();
  EXPECT_EQ(picture.tick, 300u);
  // straight along -z, the tip 2 mm and 0.6 mm of travel inside
  constexpr double oneFloat = 1e-8;
  EXPECT_NEAR(picture.node_W[picture.nodes - 1][2], -2.6e-3, oneFloat);
  EXPECT_NEAR(picture.node_W[0][2], 22e-3 - 2.6e-3, oneFloat);
  EXPECT_EQ(picture.measuredRate, 0.0);
}

TEST(HapticLoop, CountsTheRecordsNobodyTook)
{
  ListeningDevice device;
  HapticLoop loop(device,
                  std::make_unique<InsertionEngine>(test::insertionInTube(), EngineSettings{}));
  for (int i = 0; i < 10'000; ++i) loop.runOnce();
  std::uint64_t taken = 0;
  TickRecord record;
  while (loop.take(record)) EXPECT_EQ(record.tick, taken++);
  EXPECT_GE(taken, 4000u);  // several seconds
  EXPECT_EQ(loop.statistics().lostRecords, 10'000 - taken);
  EXPECT_EQ(loop.statistics().ticks, 10'000u);
}

}  // namespace
}  // namespace perilymph::haptics

// SPDX-License-Identifier: BSD-3-Clause

// A 10 kHz device with a 10 kHz engine in virtual time: the whole cycle from report to report, with
// the threads of the device layer.

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "lumen/PlainLumens.h"
#include "perilymph/haptics/CouplingLimit.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/test/PlainModels.h"
#include "perilymph/test/TenKilohertzHand.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::haptics {
namespace {

constexpr double period = test::TenKilohertzHand::period;  // [s]
constexpr double stiffness = 441.0;                        // of the coupling [N/m]
constexpr double freeWay = 0.5e-3;                         // of the tip before the wall [m]
constexpr int ticksASecond = 10'000;

/// A rod so short and stiff that its compliance is below a thousandth of the coupling's.
std::shared_ptr<const mechanics::InsertionModel> stiffRodBeforeAWall()
{
  mechanics::ModelParts parts;
  parts.lumen = std::make_shared<anatomy::FlatWall>(2e-3 + 0.25e-3 + freeWay);
  parts.array = test::plainArray();
  parts.array.length = millimeters(12);
  parts.array.insertable = millimeters(10);
  parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-4)}};
  parts.friction = {};
  parts.friction.staticCoefficient = parts.friction.kineticCoefficient =
      parts.friction.stoppingCoefficient = 0.0;
  parts.wall.perSamplePoint = newtonsPerMeter(1e6);
  parts.wall.lining = millimeters(0.001);
  parts.nodes = 8;
  parts.timeStep = Duration::fromSi(period);
  parts.startInside = millimeters(2);
  return mechanics::InsertionModel::build(std::move(parts));
}

class TenKilohertz : public testing::Test, protected test::TenKilohertzHand {
protected:
  void start()
  {
    ASSERT_TRUE(hand->open());
    EngineSettings settings;
    settings.coupling = mechanics::Coupling::spring;
    settings.couplingStiffness = stiffness;
    settings.samplePeriod = hand->traits().nominalPeriod;
    loop = std::make_unique<HapticLoop>(
        *hand, std::make_unique<InsertionEngine>(stiffRodBeforeAWall(), settings));
    loop->send({Command::Kind::arm});
  }
  TickRecord tick()
  {
    loop->runOnce();
    TickRecord record;
    EXPECT_TRUE(loop->take(record));
    return record;
  }
  /// After a second the hand moves to 1 mm in steps of 10 um at 5 mm/s and stays there, 0.5 mm
  /// behind the wall.
  TickRecord goIntoTheWall()
  {
    TickRecord record;
    for (int i = 0; i < 2 * ticksASecond; ++i) {
      if (i > ticksASecond && i % 20 == 0 && inward_10um < 100) ++inward_10um;
      report();
      record = tick();
    }
    return record;
  }

  /// Virtual time continues while the writer, a real thread, waits for a processor: a force that
  /// takes 5 ms of it looks as if the device did not accept it.
  bool wasStarved() const { return hand->health()->blockedWrites > 0; }

  std::unique_ptr<device::HidDevice> hand = device();
  std::unique_ptr<HapticLoop> loop;
};

TEST_F(TenKilohertz, IsMeasuredOnOpeningAndBeginsTheTicks)
{
  start();
  EXPECT_NEAR(hand->traits().nominalPeriod, period, 1e-9);
  EXPECT_TRUE(followsReports(hand->traits(), period));
  EXPECT_EQ(hand->await(Duration::fromSi(period)), device::Awaited::cannot);  // before a read
  hand->read();
  EXPECT_EQ(hand->await(Duration::fromSi(period)), device::Awaited::fresh);
}

TEST_F(TenKilohertz, PushesWithTheSpringsForceAtTheWall)
{
  start();
  const TickRecord record = goIntoTheWall();
  if (wasStarved()) GTEST_SKIP() << "This machine gave the writer's thread no time.";
  ASSERT_EQ(record.output.workflow, Workflow::inserting);
  const double force = stiffness * (1e-3 - freeWay);  // K x, by hand: 0.2205 N
  EXPECT_NEAR(record.output.wrench_D.force_D[2], force, 0.01 * force);
  EXPECT_EQ(hand->health()->reading.lost, 0u);
}

TEST_F(TenKilohertz, ShowsTheDeviceTheForceItComputed)
{
  start();
  const TickRecord record = goIntoTheWall();
  const double shown = std::round(record.output.wrench_D.force_D[2] * 1e3) * 1e-3;  // in mN
  EXPECT_TRUE(test::waitUntil([&] {
    if (std::abs(hid.forces().back()[2] - shown) <= 0.5e-3) return true;
    report();
    tick();
    return false;
  }));
}

TEST_F(TenKilohertz, IsStaleAfterThreeMillisecondsNotAfterThreePeriods)
{
  start();
  const TickRecord before = goIntoTheWall();
  if (wasStarved()) GTEST_SKIP() << "This machine gave the writer's thread no time.";
  ASSERT_GT(before.output.wrench_D.force_D[2], 0.2);
  // The device is silent while the loop runs.
  int ticksUntilStale = 0;
  TickRecord record;
  do {
    now += period_ns;
    record = tick();
    ++ticksUntilStale;
  } while ((record.output.status & staleSample) == 0 && ticksUntilStale < 1000);
  EXPECT_NEAR(ticksUntilStale * period, 3e-3, 1.5 * period);
  // Off within the 3 ms that SafetyLimits says; 0.22 N of 3.3 N sooner.
  for (int i = 0; i < 30; ++i) {
    now += period_ns;
    record = tick();
  }
  EXPECT_EQ(record.output.wrench_D.force_D[2], 0.0);
}

TEST(CouplingLimitAtTenKilohertz, IsTenTimesThatOfOneKilohertzWithoutADelay)
{
  device::DeviceTraits traits = test::fakeTraits();
  traits.handleDamping = 0.5;
  const double slow = couplingLimit(traits, 1e-3).stiffness;
  traits.nominalPeriod = period;
  EXPECT_NEAR(couplingLimit(traits, period).stiffness, 10.0 * slow, 1e-6);
  // 0.75 b / (T/2 + td) with td = 0.3 ms
  traits.transportDelay = 0.3e-3;
  EXPECT_NEAR(couplingLimit(traits, period).stiffness, 0.75 * 0.5 / 0.35e-3, 1e-6);
}

}  // namespace
}  // namespace perilymph::haptics

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/InsertionEngine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

using device::ScriptedDevice;
using Kind = Command::Kind;

double length(const std::array<double, 3>& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

TEST(InsertionEngine, ShowsThePhysicalForceOnceItHasFadedIn)
{
  test::InsertionRig rig(test::insertionInRing());
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(8), 10'000));
  const TickOutput& now = rig.output();
  ASSERT_GT(now.axialForce, 1e-3);  // it pushes against the hand
  // E = W in this scene, so D = W
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(now.wrench_D.force_D[k], now.force_W[k], 1e-9);
}

TEST(InsertionEngine, ScalesOnlyTheForceItShows)
{
  test::InsertionRig plain(test::insertionInRing());
  EngineSettings settings;
  settings.forceScale = 5.0;
  test::InsertionRig scaled(test::insertionInRing(), settings);
  plain.start();
  scaled.start();
  for (int i = 0; i < 4000; ++i) {
    plain.tick();
    scaled.tick();
  }
  EXPECT_EQ(scaled.output().force_W, plain.output().force_W);
  EXPECT_NEAR(scaled.output().wrench_D.force_D[2], 5.0 * plain.output().wrench_D.force_D[2], 1e-9);
}

TEST(InsertionEngine, ShowsNoForceToAHandThatDoesNotHold)
{
  test::InsertionRig rig(test::insertionInRing());
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(8), 10'000));
  rig.device().move(ScriptedDevice::Motion::hold);
  // 0.1 N a tick: at most 4 ticks for forces below 0.4 N
  for (int i = 0; i < 4; ++i) rig.tick();
  EXPECT_EQ(length(rig.output().wrench_D.force_D), 0.0);
  EXPECT_GT(length(rig.output().force_W), 1e-3);  // the array still presses
}

TEST(InsertionEngine, SettlesAtTheHandLessForceOverStiffnessInSpringCoupling)
{
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  test::InsertionRig rig(test::insertionInRing(), settings);
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(8), 10'000));
  rig.device().setSpeed(0.0);
  for (int i = 0; i < 3000; ++i) rig.tick();
  const TickOutput& now = rig.output();
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(settings.couplingStiffness * (now.proxy_W[k] - now.device_W[k]), now.force_W[k],
                1e-4);
}

TEST(InsertionEngine, TakesHoldOfASpringWithoutMovingTheArray)
{
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  test::InsertionRig rig(test::insertionInRing(), settings);
  rig.start();
  ASSERT_TRUE(rig.runUntilTravel(millimeters(8), 10'000));
  rig.device().move(ScriptedDevice::Motion::hold);
  for (int i = 0; i < 500; ++i) rig.tick();
  const auto paused_W = rig.output().proxy_W;
  const double force = rig.output().axialForce;
  ASSERT_GT(force, 1e-3);

  rig.device().setSpeed(0.0);
  rig.device().move(ScriptedDevice::Motion::insert);
  for (int i = 0; i < 200; ++i) rig.tick();
  // with an initially relaxed spring the array would move back by F / K
  const double sinking = force / settings.couplingStiffness;
  EXPECT_NEAR(rig.output().proxy_W[2], paused_W[2], 0.02 * sinking);
}

TEST(InsertionEngine, ScalesTheMotion)
{
  EngineSettings settings;
  settings.motionScale = 0.5;
  test::InsertionRig rig(test::insertionInTube(), settings);
  rig.start();
  for (int i = 0; i < 501; ++i) rig.tick();
  EXPECT_NEAR(rig.output().travel, 0.5 * 2e-3 * 0.5, 1e-9);
}

TEST(InsertionEngine, GivesTheSameBitsForTheSameSamplesAndCommands)
{
  const auto model = test::insertionInRing();
  test::InsertionRig rig(model);
  InsertionEngine again(model, {});
  rig.start();
  for (int i = 0; i < 3000; ++i) {
    if (i == 1500) rig.send(Kind::withdraw);
    if (i == 1500) rig.device().move(ScriptedDevice::Motion::withdraw);
    const TickRecord& record = rig.tick();
    const TickOutput output = again.tick(record.sample, record.commands);
    ASSERT_EQ(output.force_W, record.output.force_W) << i;
    ASSERT_EQ(output.wrench_D.force_D, record.output.wrench_D.force_D) << i;
    ASSERT_EQ(output.status, record.output.status) << i;
    ASSERT_EQ(again.fingerprint(), rig.engine().fingerprint()) << i;
  }
}

TEST(InsertionEngine, SettlesEveryTickOfAPlainInsertion)
{
  test::InsertionRig rig(test::insertionInRing());
  rig.start();
  int ticksNotConverged = 0;
  for (int i = 0; i < 8000; ++i)
    if ((rig.tick().output.status & notConverged) != 0) ++ticksNotConverged;
  EXPECT_EQ(ticksNotConverged, 0);
}

TEST(InsertionEngine, ShowsThePeakOfEveryTickNotOfThosePictured)
{
  test::InsertionRig rig(test::insertionInRing());
  rig.start();
  double force = 0.0, travel = 0.0;
  std::uint64_t ofPicture = 0, peakTick = 0;
  Snapshot snapshot;
  for (std::uint64_t i = 0; i < 6000; ++i) {
    if (i == 4000) rig.device().move(ScriptedDevice::Motion::withdraw);  // the peak is behind
    const TickOutput& now = rig.tick().output;
    if (now.axialForce > force) {
      force = now.axialForce;
      travel = now.travel;
      peakTick = i;
    }
    if (i % 67 != 3) continue;
    rig.engine().fill(snapshot);
    ofPicture = i;
    ASSERT_EQ(snapshot.peak.force, force) << i;
    ASSERT_EQ(snapshot.peak.travel, travel) << i;
  }
  EXPECT_GT(force, 1e-3);
  EXPECT_LT(peakTick, ofPicture - 67);
  EXPECT_NE(peakTick % 67, 3u);  // between two pictures
}

/// An opening at the origin; derived classes define the wall.
class OpenLumen : public anatomy::Lumen {
public:
  anatomy::Entry entry() const noexcept final { return {}; }
  anatomy::LumenTrack startTrack() const noexcept final { return {}; }
  void addTo(Hash&) const noexcept final {}
};

/// A plain array in front of a lumen.
test::InsertionRig startedIn(std::shared_ptr<const anatomy::Lumen> lumen)
{
  mechanics::ModelParts parts;
  parts.lumen = std::move(lumen);
  parts.array = test::plainArray();
  parts.nodes = 40;
  test::InsertionRig rig(mechanics::InsertionModel::build(parts));
  rig.start();
  return rig;
}

/// A wall at a different position in each query.
class RestlessLumen final : public OpenLumen {
public:
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double>,
                   std::span<anatomy::LumenTrack>,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    isLeft_ = !isLeft_;
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      walls[i] = {};
      walls[i].isNear = true;
      walls[i].normal_W = Eigen::Vector3d::UnitX() * (isLeft_ ? 1.0 : -1.0);
      walls[i].distance = points_W[i].dot(walls[i].normal_W);
    }
  }

private:
  mutable bool isLeft_ = false;
};

TEST(InsertionEngine, SaysWhenATickFoundNoEquilibrium)
{
  test::InsertionRig rig = startedIn(std::make_shared<RestlessLumen>());
  int ticksNotConverged = 0;
  for (int i = 0; i < 30; ++i) {
    const TickOutput& output = rig.tick().output;
    const bool isLarge = rig.engine().state().readings.residual > 1e-4;  // [N]
    EXPECT_EQ((output.status & notConverged) != 0, isLarge) << i;
    ticksNotConverged += isLarge ? 1 : 0;
  }
  EXPECT_GT(ticksNotConverged, 0);
}

/// A tube whose wall is NaN beyond a depth.
class BrokenLumen final : public OpenLumen {
public:
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double>,
                   std::span<anatomy::LumenTrack>,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      walls[i] = {};
      if (points_W[i].z() > -3e-3) continue;
      walls[i].isNear = true;
      walls[i].distance = std::numeric_limits<double>::quiet_NaN();
      walls[i].normal_W.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
};

class Overflow : public testing::Test {
protected:
  static test::InsertionRig overflown()
  {
    test::InsertionRig rig = startedIn(std::make_shared<BrokenLumen>());
    if (!rig.runUntil(Workflow::fault, 2000)) throw std::runtime_error("It never overflowed.");
    return rig;
  }
};

TEST_F(Overflow, IsAFaultWithoutForceThatKeepsTheLastGoodFigures)
{
  test::InsertionRig rig = overflown();
  EXPECT_NE(rig.output().status & notFinite, 0u);
  for (int i = 0; i < 50; ++i) rig.tick();
  EXPECT_EQ(length(rig.output().wrench_D.force_D), 0.0);
  EXPECT_NEAR(rig.output().travel, 1e-3, 1e-4);
  EXPECT_TRUE(std::isfinite(rig.output().tip_W[2]));
}

TEST_F(Overflow, LeavesTheShapeInThePictureAsItWas)
{
  test::InsertionRig rig = overflown();
  for (int i = 0; i < 10; ++i) {
    rig.tick();
    ASSERT_TRUE(rig.loop().refresh());
    const Snapshot& picture = rig.loop().latest();
    for (std::size_t node = 0; node < picture.nodes; ++node)
      ASSERT_TRUE(std::isfinite(picture.node_W[node][2])) << node;
  }
}

TEST_F(Overflow, IsLeftByNoCommand)
{
  test::InsertionRig rig = overflown();
  for (const Kind kind : {Kind::resume, Kind::arm, Kind::withdraw}) {
    rig.send(kind);
    EXPECT_EQ(rig.tick().output.workflow, Workflow::fault);
    EXPECT_NE(rig.output().status & notFinite, 0u);
  }
}

TEST(LostDevice, IsAFaultFromEveryState)
{
  for (const bool isArmed : {false, true}) {
    InsertionEngine engine(test::insertionInTube(), {});
    CommandList commands;
    if (isArmed) {
      commands.count = 1;
      commands.items[0].kind = Kind::arm;
    }
    device::DeviceSample sample;
    sample.sequence = 1;
    sample.isValid = 1;
    engine.tick(sample, commands);
    sample.isValid = 0;
    const TickOutput output = engine.tick(sample, {});
    EXPECT_EQ(output.workflow, Workflow::fault);
    EXPECT_NE(output.status & deviceLost, 0u);
  }
}

}  // namespace
}  // namespace perilymph::haptics

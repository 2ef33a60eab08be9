// SPDX-License-Identifier: BSD-3-Clause

// A stiff array that is pushed through the cochlear partition, from a scenario.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/ContourFromBelow.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

constexpr double strength = 0.042;  // [N]

struct Push {
  explicit Push(const Overrides& changes)
  {
    Overrides overrides = test::contourFromBelow();
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    const auto scenario = loadScenario("surgery-flex28", overrides);
    EXPECT_TRUE(scenario) << scenario.error().message;
    const InsertionParameters& parameters = scenario->parameters();
    auto prepared = Insertion::prepare(
        parameters,
        std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()));
    EXPECT_TRUE(prepared);
    insertion = std::move(*prepared);
    EXPECT_TRUE(insertion->runToEnd([&](const haptics::TickRecord& record) { return note(record); },
                                    40'000));
  }

  bool note(const haptics::TickRecord& record)
  {
    const mechanics::InsertionState& now = state();
    unbalanced += (record.output.status & haptics::notConverged) != 0 ? 1 : 0;
    evaluations = std::max(evaluations, now.readings.evaluations);
    factorizations = std::max(factorizations, now.readings.factorizations);
    if (before_W) {
      work -= 0.5 * (force_W + now.readings.handForce_W).dot(now.base_W - *before_W);
      minWork = std::min(minWork, work);
    }
    before_W = now.base_W;
    force_W = now.readings.handForce_W;
    if (now.partition.isRuptured()) look();
    return true;
  }

  /// The deepest node in the bone around both scalae, and changes of side off the rupture.
  void look()
  {
    const mechanics::InsertionState& now = state();
    const mechanics::PartitionState& partition = now.partition;
    wasAbove.resize(now.position_W.size());
    for (std::size_t i = 0; i < now.position_W.size(); ++i) {
      anatomy::LumenTrack track = now.track[i];
      if (track.inLeadIn) continue;
      anatomy::WallPoint wall;
      const double reach = 10e-3;
      insertion->model().partition->both->nearestWall({&now.position_W[i], 1}, {&reach, 1},
                                                      {&track, 1}, {&wall, 1});
      if (track.angle > insertion->model().partition->range.begin)
        deepest = std::max(deepest, insertion->model().radius[i] - wall.distance);
      const bool isWhole = partition.at(now.track[i].angle).value >= 1.0;
      if (isWhole && partition.isAbove[i] != wasAbove[i] && wasWhole) ++changedSide;
      wasAbove[i] = partition.isAbove[i];
    }
    wasWhole = true;
    above = static_cast<int>(std::count(partition.isAbove.begin(), partition.isAbove.end(), 1));
    maxAbove = std::max(maxAbove, above);
  }

  const mechanics::InsertionState& state() const { return insertion->loop().engine().state(); }
  const mechanics::Rupture& rupture() const { return state().partition.first; }

  std::unique_ptr<Insertion> insertion;
  int unbalanced = 0, evaluations = 0, factorizations = 0, above = 0, maxAbove = 0;
  int changedSide = 0;    ///< Changes of side where the partition is whole.
  double deepest = -1.0;  ///< [m]
  double work = 0.0;      ///< Work of the hand [J].
  double minWork = 0.0;   ///< [J]

private:
  std::optional<Eigen::Vector3d> before_W;
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
  std::vector<unsigned char> wasAbove;
  bool wasWhole = false;
};

const Push& pushedIn()
{
  static const Push run({});
  return run;
}

TEST(Translocation, OfAStiffArrayTiltedUpward)
{
  const Push& run = pushedIn();
  ASSERT_TRUE(run.state().partition.isRuptured());
  EXPECT_GE(run.rupture().force, strength);
  EXPECT_LT(run.rupture().force, 1.02 * strength);
  EXPECT_GT(run.above, 10);
  EXPECT_EQ(run.changedSide, 0);
}

TEST(Translocation, IsShownNodeByNode)
{
  const Push& run = pushedIn();
  const auto shown = std::make_unique<haptics::Snapshot>();
  run.insertion->loop().engine().fill(*shown);
  EXPECT_EQ(shown->isAbove.count(), std::size_t(run.above));
  for (std::size_t i = 0; i < shown->nodes; ++i)
    EXPECT_EQ(shown->isAbove[i], run.state().partition.isAbove[i] != 0) << i;
  EXPECT_EQ(shown->ruptures, 1u);
}

TEST(Translocation, LeavesTheArrayWithinBoneAndItsStepsBalanced)
{
  const Push& run = pushedIn();
  const double lining = run.insertion->model().parts.wall.lining.si();
  EXPECT_LT(run.deepest, lining + 0.1e-3);
  EXPECT_LE(run.unbalanced, 2);  // of 4,250; each is balanced by the next
  EXPECT_LE(run.evaluations, mechanics::SolverParameters{}.maxEvaluations);
  EXPECT_LE(run.factorizations, mechanics::SolverParameters{}.maxFactorizations);
}

TEST(Translocation, IsAtTheSamePlaceForOtherTimeStepsAndNodes)
{
  const mechanics::Rupture& expected = pushedIn().rupture();
  const double length = pushedIn().insertion->model().spacing;
  for (const Overrides& changes :
       {Overrides{{"dt_ms", "0.5"}}, Overrides{{"nodes", "200"}}, Overrides{{"nodes", "50"}}}) {
    const Push run(changes);
    ASSERT_TRUE(run.state().partition.isRuptured());
    EXPECT_NEAR(inDegrees(radians(run.rupture().angle)), inDegrees(radians(expected.angle)), 1.5);
    EXPECT_NEAR(run.rupture().depth, expected.depth, 0.5 * length);
    EXPECT_NEAR(run.rupture().force, expected.force, 0.02 * strength);
  }
}

TEST(Translocation, GivesAHandNoEnergyOnTheWayInAndOut)
{
  const Push run({{"withdraw", "true"}, {"stop_travel_mm", "13"}});
  ASSERT_TRUE(run.state().partition.isRuptured());
  EXPECT_GT(run.maxAbove, 3);
  EXPECT_GT(run.minWork, -1e-6);
  EXPECT_GT(run.work, 0.0);
}

TEST(Translocation, IsInTheRecordingAndReplaysBitForBit)
{
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "translocation.insertion";
  Overrides overrides = test::contourFromBelow();
  overrides.emplace_back("nodes", "50");
  const auto scenario = loadScenario("surgery-flex28", overrides);
  ASSERT_TRUE(scenario);
  const InsertionParameters& parameters = scenario->parameters();
  mechanics::Rupture rupture;
  {
    auto insertion = Insertion::prepare(
        *scenario,
        std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()),
        file);
    ASSERT_TRUE(insertion) << insertion.error().message;
    ASSERT_TRUE((*insertion)->runToEnd([](const haptics::TickRecord&) { return true; }, 40'000));
    rupture = (*insertion)->loop().engine().state().partition.first;
    ASSERT_TRUE((*insertion)->closeRecording());
  }
  const auto verification = verify(file, {});
  ASSERT_TRUE(verification) << verification.error().message;
  EXPECT_TRUE(verification->isIdentical) << verification->damage;
  EXPECT_TRUE(verification->notes.empty());

  const auto recorded = RecordedInsertion::open(file);
  ASSERT_TRUE(recorded);
  haptics::TickOutput last;
  std::uint64_t ruptures = 0;
  ASSERT_TRUE(recorded->forEach([&](const haptics::TickRecord& record) {
    const auto ruptured = haptics::partitionRuptured;
    if ((record.output.status & ruptured) != 0 && (last.status & ruptured) == 0) ++ruptures;
    last = record.output;
    return true;
  }));
  EXPECT_EQ(ruptures, 1u);
  EXPECT_EQ(last.translocation.angle, rupture.angle);
  EXPECT_EQ(last.translocation.force, rupture.force);
  EXPECT_EQ(last.translocation.depth, rupture.depth);
  EXPECT_NE(last.status & haptics::translocated, 0u);
  EXPECT_GT(last.translocation.lengthAbove, 1e-3);
}

TEST(Translocation, GivesBackWhatItTookInLoopsWithoutFriction)
{
  const auto scenario = loadScenario("surgery-flex28", test::contourFromBelow());
  ASSERT_TRUE(scenario);
  InsertionParameters parameters = scenario->parameters();
  parameters.friction = {0.0, 0.0, 0.0, millimetersPerSecond(0.1)};
  const auto model = *buildModel(parameters, *buildAnatomy(parameters));
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handPosition_W = model->startBase_W;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;
  double work = 0.0;
  const auto advance = [&](double way) {
    const int steps = static_cast<int>(std::fabs(way) / (2e-3 * model->timeStep));
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector3d before_W = state.base_W;
      const Eigen::Vector3d force_W = state.readings.handForce_W;
      drive.handPosition_W -= (way / steps) * model->entry.out_W;
      mechanics::advance(*model, state, drive);
      work -= 0.5 * (force_W + state.readings.handForce_W).dot(state.base_W - before_W);
    }
  };
  advance(15e-3);
  ASSERT_TRUE(state.partition.isRuptured());
  EXPECT_GT(std::count(state.partition.isAbove.begin(), state.partition.isAbove.end(), 1), 3);
  double first = 0.0;
  for (int loop = 0; loop < 3; ++loop) {
    work = 0.0;
    advance(-5e-3);
    const double turned = work;
    advance(5e-3);
    EXPECT_GT(work, -1e-6) << loop;
    if (loop == 0) first = std::fabs(turned);
    if (loop > 0) {
      EXPECT_LT(work, 0.05 * first) << loop;
    }
  }
  EXPECT_GT(first, 20e-6);
}

}  // namespace
}  // namespace perilymph::session

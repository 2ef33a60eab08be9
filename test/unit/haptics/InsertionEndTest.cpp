// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/InsertionEnd.h"

#include <gtest/gtest.h>

#include <set>

#include "perilymph/haptics/EndDetector.h"
#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

constexpr double millimeter = 1e-3;

constexpr std::array allEnds = {
    InsertionEnd::none,    InsertionEnd::finished,     InsertionEnd::stoppedByResistance,
    InsertionEnd::buckled, InsertionEnd::outOfOpening, InsertionEnd::foldedTip,
    InsertionEnd::jammed,  InsertionEnd::fault,        InsertionEnd::refused};

TEST(InsertionEnd, HasANameOfItsOwnThatIsReadBack)
{
  std::set<std::string> names;
  for (const InsertionEnd end : allEnds) {
    EXPECT_EQ(endNamed(nameOf(end)), end) << nameOf(end);
    EXPECT_TRUE(names.insert(nameOf(end)).second) << nameOf(end);
  }
  EXPECT_EQ(endNamed("slipped out"), InsertionEnd::outOfOpening);
  EXPECT_EQ(endNamed("something else"), InsertionEnd::none);
}

TEST(InsertionEnd, IsReadFromTheStatusOfATick)
{
  TickOutput now;
  EXPECT_EQ(endOf(now), InsertionEnd::none);
  now.workflow = Workflow::finished;
  EXPECT_EQ(endOf(now), InsertionEnd::finished);
  for (const auto& [end, bit] : endEvents) {
    now.status = bit | forceSlewed;
    EXPECT_EQ(endOf(now), end);
    EXPECT_EQ(bitOf(end), bit);
    EXPECT_EQ(anyEnd & bit, bit);
  }
  now.status = allWell;
  now.workflow = Workflow::fault;
  EXPECT_EQ(endOf(now), InsertionEnd::fault);
}

/// A straight array 22 mm long in a straight tube, its tip 10 mm inside.
class Detected : public testing::Test {
protected:
  Detected() { put(10 * millimeter, 12 * millimeter); }

  /// Sets the depth, and the distance of the tweezers from the opening.
  void put(double depth, double distance)
  {
    const Eigen::Vector3d out_W = model_->entry.out_W;
    state_.base_W = model_->openingCenter_W + distance * out_W;
    state_.readings.depth = depth;
    for (std::size_t i = 0; i < state_.position_W.size(); ++i)
      state_.position_W[i] = model_->openingCenter_W - (depth - model_->fromTip[i]) * out_W;
  }

  InsertionEnd next(bool isWithdrawing = false)
  {
    return detector_.detect(*model_, state_, isWithdrawing);
  }

  std::shared_ptr<const mechanics::InsertionModel> model_ = test::insertionInTube();
  mechanics::InsertionState state_{*model_};
  EndDetector detector_{*model_, 0.0};
};

TEST_F(Detected, NothingOnAStraightArray) { EXPECT_EQ(next(), InsertionEnd::none); }

TEST_F(Detected, AForceAboveTwoNewtonsInAnyDirection)
{
  state_.readings.handForce_W = {0.0, 1.99, 0.0};
  EXPECT_EQ(next(), InsertionEnd::none);
  state_.readings.handForce_W = {0.0, 1.5, -1.5};
  EXPECT_EQ(next(), InsertionEnd::jammed);
  EXPECT_EQ(next(true), InsertionEnd::jammed);
}

TEST_F(Detected, TheForceAtWhichTheSurgeonStops)
{
  EndDetector stopping(*model_, 0.2);
  state_.readings.axialForce = 0.19;
  EXPECT_EQ(stopping.detect(*model_, state_, false), InsertionEnd::none);
  state_.readings.axialForce = 0.21;
  // the force of a step that has not found its balance is none of the array
  state_.isSettling = true;
  EXPECT_EQ(stopping.detect(*model_, state_, false), InsertionEnd::none);
  state_.isSettling = false;
  EXPECT_EQ(stopping.detect(*model_, state_, false), InsertionEnd::stoppedByResistance);
  EXPECT_EQ(stopping.detect(*model_, state_, true), InsertionEnd::none);
  EXPECT_EQ(next(), InsertionEnd::none);
}

TEST_F(Detected, AnArrayThatFoldsInFrontOfTheOpening)
{
  put(10 * millimeter, 8.1 * millimeter);
  EXPECT_EQ(next(), InsertionEnd::none);
  put(10 * millimeter, 7.9 * millimeter);
  EXPECT_EQ(next(), InsertionEnd::buckled);
  EXPECT_EQ(next(true), InsertionEnd::none);
}

TEST_F(Detected, TweezersAtTheBone)
{
  put(19.9 * millimeter, model_->radius.front() + 2e-9);
  EXPECT_EQ(next(), InsertionEnd::none);
  put(19.9 * millimeter, model_->radius.front());
  EXPECT_EQ(next(), InsertionEnd::buckled);
}

TEST_F(Detected, ATipPushedPastTheOpeningButNotOneThatIsDrawnOut)
{
  put(0.0, 22.1 * millimeter);
  EXPECT_EQ(next(), InsertionEnd::none);
  put(0.0, 21.4 * millimeter);
  EXPECT_EQ(next(), InsertionEnd::outOfOpening);
}

TEST_F(Detected, ATipThatPointsBack)
{
  const std::size_t n = state_.position_W.size();
  for (std::size_t i = n - 8; i < n; ++i)
    state_.position_W[i] = state_.position_W[2 * (n - 9) - i] + 0.3e-3 * Eigen::Vector3d::UnitX();
  EXPECT_EQ(next(), InsertionEnd::foldedTip);
}

TEST_F(Detected, ATipThatNoLongerAdvances)
{
  EXPECT_EQ(next(), InsertionEnd::none);
  const auto shape_W = state_.position_W;
  put(12.9 * millimeter, 9.1 * millimeter);
  state_.position_W = shape_W;
  EXPECT_EQ(next(), InsertionEnd::none);
  put(13.1 * millimeter, 8.9 * millimeter);
  state_.position_W = shape_W;
  EXPECT_EQ(next(), InsertionEnd::jammed);
}

TEST_F(Detected, NothingWhileTheTipAdvancesSlowly)
{
  EXPECT_EQ(next(), InsertionEnd::none);
  for (double depth = 10.0; depth < 20.0; depth += 0.5) {
    const Eigen::Vector3d tip_W = state_.position_W.back();
    put(depth * millimeter, (22.0 - depth) * millimeter);
    const Eigen::Vector3d lag_W = 0.8 * (state_.position_W.back() - tip_W);
    for (Eigen::Vector3d& node_W : state_.position_W) node_W -= lag_W;
    EXPECT_EQ(next(), InsertionEnd::none) << depth;
  }
}

TEST(InsertionEngine, KeepsTheForceAfterAStopByResistanceAndMayWithdraw)
{
  EngineSettings settings;
  settings.stopForce = 5e-3;
  test::InsertionRig rig(test::insertionInRing(), settings);
  rig.start();
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  EXPECT_EQ(endOf(rig.output()), InsertionEnd::stoppedByResistance);
  EXPECT_LT(rig.output().travel, settings.stopTravel);
  const double depth = rig.output().depth;
  for (int i = 0; i < 1000; ++i) rig.tick();
  EXPECT_NEAR(rig.output().depth, depth, 1e-3 * millimeter);
  EXPECT_GT(rig.output().wrench_D.force_D[2], 0.5 * settings.stopForce);

  rig.send(Command::Kind::withdraw);
  rig.device().move(device::ScriptedDevice::Motion::withdraw);
  rig.tick();
  EXPECT_EQ(rig.output().workflow, Workflow::inserting);
  ASSERT_TRUE(rig.runUntil(Workflow::finished, 10'000));
  EXPECT_NEAR(rig.output().travel, 0.0, 0.01 * millimeter);
  EXPECT_EQ(endOf(rig.output()), InsertionEnd::stoppedByResistance);
}

}  // namespace
}  // namespace perilymph::haptics

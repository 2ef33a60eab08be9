// SPDX-License-Identifier: BSD-3-Clause

// An array that goes through the cochlear partition: the wall tables above it are built before the
// first tick in real time, at the first rupture in virtual time, and the bits are the same.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "perilymph/mechanics/advance.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/ContourFromBelow.h"

namespace perilymph::session {
namespace {

/// What 15 mm of a push gave.
struct Push {
  std::vector<double> values;  ///< Force on the hand and position of the tip, step by step.
  std::uint64_t ruptured = 0;  ///< The step after which the partition was open; 0: none.
  std::size_t allocatedBefore = 0, allocatedSince = 0;  ///< In steps up to that one, and after it.
};

Push pushed(bool isPrepared)
{
  const auto scenario = loadScenario("surgery-flex28", test::contourFromBelow());
  EXPECT_TRUE(scenario);
  const InsertionParameters& parameters = scenario->parameters();
  const auto model = *buildModel(parameters, *buildAnatomy(parameters));
  if (isPrepared) model->prepareForRealTime();
  mechanics::InsertionState state(*model);
  mechanics::Drive drive;
  drive.handPosition_W = model->startBase_W;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;
  const double step = 2e-3 * model->timeStep;
  const auto steps = static_cast<std::uint64_t>(15e-3 / step);
  Push push;
  for (std::uint64_t k = 1; k <= steps; ++k) {
    drive.handPosition_W -= step * model->entry.out_W;
    const bool wasRuptured = state.partition.isRuptured();
    {
      const test::AllocationGuard guard;
      mechanics::advance(*model, state, drive);
      (wasRuptured ? push.allocatedSince : push.allocatedBefore) += guard.allocations();
    }
    if (!wasRuptured && state.partition.isRuptured()) push.ruptured = k;
    for (const Eigen::Vector3d& each : {state.readings.handForce_W, state.position_W.back()})
      push.values.insert(push.values.end(), each.data(), each.data() + 3);
  }
  return push;
}

TEST(TheTablesAboveThePartition, AreBuiltBeforeRealTimeOrAtTheFirstRuptureToTheSameBits)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  const Push prepared = pushed(true), virtually = pushed(false);
  ASSERT_GT(prepared.ruptured, 0u);
  EXPECT_EQ(prepared.allocatedBefore, 0u);
  EXPECT_EQ(prepared.allocatedSince, 0u);
  // of two tables, each of several arrays, nothing is built before they are read
  EXPECT_EQ(virtually.allocatedBefore, 0u);
  EXPECT_GT(virtually.allocatedSince, 10u);
  EXPECT_EQ(virtually.ruptured, prepared.ruptured);
  EXPECT_EQ(virtually.values, prepared.values);
}

}  // namespace
}  // namespace perilymph::session

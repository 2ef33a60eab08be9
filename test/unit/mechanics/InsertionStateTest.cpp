// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/InsertionState.h"

#include <gtest/gtest.h>

#include "lumen/PlainLumens.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/AllocationGuard.h"

namespace perilymph::mechanics {
namespace {

/// A Contour pushed into a narrow tube at 2 mm/s.
struct SlowInsertion {
  SlowInsertion() : model(InsertionModel::build(parts())), state(*model) {}

  static ModelParts parts()
  {
    ModelParts parts;
    parts.lumen = std::make_shared<anatomy::StraightTube>(0.45e-3);
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    parts.nodes = 40;
    parts.approachTilt = degrees(4);
    return parts;
  }

  void step(InsertionState& of) const
  {
    Drive drive;
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    drive.handPosition_W =
        model->startBase_W + (2e-6 * static_cast<double>(of.tick + 1)) * drive.handAxis_W;
    advance(*model, of, drive);
  }

  std::shared_ptr<const InsertionModel> model;
  InsertionState state;
};

TEST(InsertionState, CopiesContinueEquallyAndIndependently)
{
  SlowInsertion run;
  for (int i = 0; i < 300; ++i) run.step(run.state);
  ASSERT_GT(run.state.readings.wallForceTotal, 0.0);

  InsertionState copy = run.state;
  const std::uint64_t then = run.state.fingerprint();
  EXPECT_EQ(copy.fingerprint(), then);
  for (int i = 0; i < 50; ++i) run.step(copy);
  EXPECT_EQ(run.state.fingerprint(), then);
  for (int i = 0; i < 50; ++i) run.step(run.state);
  EXPECT_EQ(run.state.fingerprint(), copy.fingerprint());
}

TEST(InsertionState, IsAssignedFromAStateOfTheSameModelWithoutAllocating)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  SlowInsertion run;
  InsertionState other = run.state;
  for (int i = 0; i < 100; ++i) run.step(run.state);
  const test::AllocationGuard guard;
  other = run.state;
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(other.fingerprint(), run.state.fingerprint());
}

}  // namespace
}  // namespace perilymph::mechanics

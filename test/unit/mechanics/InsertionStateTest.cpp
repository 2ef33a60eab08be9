// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/InsertionState.h"

#include <gtest/gtest.h>

#include "lumen/PlainLumens.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/AllocationGuard.h"

namespace perilymph::mechanics {
namespace {

/// What the array holds of its bends.
enum class Memory { none, relaxation, yield };

/// A Contour pushed into a narrow tube at 2 mm/s.
struct SlowInsertion {
  explicit SlowInsertion(Memory memory = Memory::none)
      : model(InsertionModel::build(parts(memory))), state(*model)
  {
  }

  static ModelParts parts(Memory memory)
  {
    ModelParts parts;
    parts.lumen = std::make_shared<anatomy::StraightTube>(0.45e-3);
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    parts.nodes = 40;
    parts.approachTilt = degrees(4);
    if (memory == Memory::relaxation) {
      parts.relaxation.bending[0] = {0.3, seconds(0.1)};
      parts.relaxation.film = {0.4, seconds(0.05)};
    } else if (memory == Memory::yield) {
      electrode::Wires& wires = parts.array.wires.emplace();
      wires.number = {{millimeters(0)}, {20.0}};
      wires.diameter = millimeters(0.025);
      wires.modulus = megapascals(168e3);
      wires.coupling = 0.05;
      wires.yieldStress.value = megapascals(20);
    }
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

class InsertionStateOf : public testing::TestWithParam<Memory> {};

TEST_P(InsertionStateOf, CopiesContinueEquallyAndIndependently)
{
  SlowInsertion run(GetParam());
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

INSTANTIATE_TEST_SUITE_P(EachMemory, InsertionStateOf,
                         testing::Values(Memory::none, Memory::relaxation, Memory::yield));

TEST(InsertionState, OfARelaxingArrayIsRestoredByAReset)
{
  SlowInsertion run(Memory::relaxation);
  const std::uint64_t start = run.state.fingerprint();
  for (int i = 0; i < 300; ++i) run.step(run.state);
  InsertionState copy = run.state;
  copy.relaxedBend[0].along[20] += 1e-9;
  EXPECT_NE(copy.fingerprint(), run.state.fingerprint()) << "what it holds is part of it";
  copy = run.state;
  copy.frictionFilm_W[20].x() += 1e-9;
  EXPECT_NE(copy.fingerprint(), run.state.fingerprint());
  run.state.reset(*run.model);
  EXPECT_EQ(run.state.fingerprint(), start);
}

TEST(InsertionState, OfAYieldingArrayIsRestoredByAReset)
{
  SlowInsertion run(Memory::yield);
  const std::uint64_t start = run.state.fingerprint();
  for (int i = 0; i < 300; ++i) run.step(run.state);
  ASSERT_GT(run.state.readings.plasticWork, 0.0);
  for (MaterialBend& bend : run.state.plasticBend) {
    InsertionState copy = run.state;
    bend.across[20] += 1e-9;
    EXPECT_NE(copy.fingerprint(), run.state.fingerprint()) << "what stays bent is part of it";
  }
  run.state.reset(*run.model);
  EXPECT_EQ(run.state.fingerprint(), start);
  EXPECT_EQ(run.state.readings.plasticWork, 0.0);
}

TEST_P(InsertionStateOf, IsAssignedFromAStateOfTheSameModelWithoutAllocating)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  SlowInsertion run(GetParam());
  InsertionState other = run.state;
  for (int i = 0; i < 100; ++i) run.step(run.state);
  const test::AllocationGuard guard;
  other = run.state;
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(other.fingerprint(), run.state.fingerprint());
}

}  // namespace
}  // namespace perilymph::mechanics

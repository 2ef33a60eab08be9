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
  explicit SlowInsertion(const RelaxationLaw& relaxation = {})
      : model(InsertionModel::build(parts(relaxation))), state(*model)
  {
  }

  static ModelParts parts(const RelaxationLaw& relaxation)
  {
    ModelParts parts;
    parts.lumen = std::make_shared<anatomy::StraightTube>(0.45e-3);
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    parts.nodes = 40;
    parts.relaxation = relaxation;
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

RelaxationLaw relaxing()
{
  RelaxationLaw law;
  law.bending[0] = {0.3, seconds(0.1)};
  law.film = {0.4, seconds(0.05)};
  return law;
}

class InsertionStateOf : public testing::TestWithParam<bool> {};

TEST_P(InsertionStateOf, CopiesContinueEquallyAndIndependently)
{
  SlowInsertion run(GetParam() ? relaxing() : RelaxationLaw{});
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

INSTANTIATE_TEST_SUITE_P(RestAndRelaxation, InsertionStateOf, testing::Bool());

TEST(InsertionState, OfARelaxingArrayIsRestoredByAReset)
{
  SlowInsertion run(relaxing());
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

TEST(InsertionState, IsAssignedFromAStateOfTheSameModelWithoutAllocating)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  SlowInsertion run(relaxing());
  InsertionState other = run.state;
  for (int i = 0; i < 100; ++i) run.step(run.state);
  const test::AllocationGuard guard;
  other = run.state;
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(other.fingerprint(), run.state.fingerprint());
}

}  // namespace
}  // namespace perilymph::mechanics

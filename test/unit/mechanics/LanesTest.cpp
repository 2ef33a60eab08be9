// SPDX-License-Identifier: BSD-3-Clause

#include "lanes/Lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "friction/FrictionKernel.h"
#include "friction/FrictionStep.h"
#include "rod/Rod.h"
#include "solver/NewtonStep.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

/// A bent, stretched and twisted piece of array with an oval section at every third node.
struct Piece {
  explicit Piece(std::size_t nodes) : section(nodes), rod(nodes), force_W(nodes)
  {
    model.nodes = static_cast<int>(nodes);
    model.spacing = 0.2e-3;
    model.timeStep = 1e-3;
    model.isOval = model.twists = true;
    std::mt19937 random(7);
    const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p32; };
    const auto around = [&uniform](double size) { return size * (uniform() - 0.5); };
    const auto vector = [&](double size) {
      return Vector3d(around(size), around(size), around(size));
    };
    Vector3d at = Vector3d::Zero();
    for (std::size_t i = 0; i < nodes; ++i) {
      position_W.push_back(at);
      at += Vector3d(model.spacing, 0.0, 0.0) + vector(0.1 * model.spacing);
      model.bendingExcess.push_back(i % 3 == 0 ? 1e-10 : 0.0);
      section.stretching[i] = (1.0 + uniform()) / model.spacing;
      section.twisting[i] = 1e-10 * uniform() / model.spacing;
      section.bending[i] = 1e-9 * (1.0 + uniform()) / model.spacing;
      section.bendingExcess[i] = model.bendingExcess[i] / model.spacing;
      rod.lengthBefore[i] = model.spacing * (1.0 + around(0.01));
      rod.bendBefore_W.set(i, vector(0.1));
      rod.restBend_W.set(i, vector(0.1));
      rod.stiffer_W.set(i, vector(1.0));
      rod.twist[i] = around(0.1);
      rod.twistRate_W.set(i, vector(10.0));
    }
  }

  InsertionModel model;
  std::vector<Vector3d> position_W;
  SectionStiffness section;
  RodKinematics rod;
  std::vector<Vector3d> force_W;
};

class Lanes : public testing::TestWithParam<Instructions> {
protected:
  Lanes() : before_(kernelInstructions) { kernelInstructions = GetParam(); }
  ~Lanes() override { kernelInstructions = before_; }
  void SetUp() override
  {
    if (GetParam() > machineInstructions()) GTEST_SKIP() << "This machine does not have them.";
  }

private:
  Instructions before_;
};

TEST_P(Lanes, LoadAndStoreVectorsAtAnyPlace)
{
  std::vector<Vector3d> from, to(12, Vector3d::Zero());
  for (int i = 0; i < 12; ++i) from.emplace_back(i, i + 100, i + 200);
  for (std::size_t first = 0; first + 4 <= from.size(); ++first) {
    const Triple<Four> v = load<Four>(from, first);
    for (int lane = 0; lane < 4; ++lane) {
      const auto place = first + static_cast<std::size_t>(lane);
      ASSERT_EQ(Vector3d(v.x[lane], v.y[lane], v.z[lane]), from[place]);
    }
    store(v, to, first);
    ASSERT_EQ(std::vector(to.begin(), to.begin() + static_cast<std::ptrdiff_t>(first) + 4),
              std::vector(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(first) + 4));
  }
}

// The last four nodes of a range overlap with those before. What a node gets must not depend on
// where in a range it is.
TEST_P(Lanes, GiveTheForcesOfSingleNodes)
{
  Piece longest(40);
  setRodForces(longest.model, longest.position_W, longest.section, longest.rod, longest.force_W);
  for (std::size_t nodes = 5; nodes < 40; ++nodes) {
    Piece piece(nodes);
    setRodForces(piece.model, piece.position_W, piece.section, piece.rod, piece.force_W);
    for (std::size_t i = 0; i + 2 < nodes; ++i)
      ASSERT_EQ(piece.force_W[i], longest.force_W[i]) << i << " of " << nodes;
  }
}

TEST_P(Lanes, GiveForcesThatAddUpToZero)
{
  Piece piece(23);
  setRodForces(piece.model, piece.position_W, piece.section, piece.rod, piece.force_W);
  // Newton's third law
  Vector3d sum = Vector3d::Zero();
  double size = 0.0;
  for (const Vector3d& force : piece.force_W) sum += force, size = std::max(size, force.norm());
  EXPECT_GT(size, 1e-3);
  EXPECT_LT(sum.norm(), 1e-12 * size * 23.0);
}

// Nodes that stick, slide and come to rest, side by side.
TEST_P(Lanes, GiveTheFrictionOfSingleNodes)
{
  FrictionLaw measured;
  measured.bySpeed = {
      {millimetersPerSecond(0.1), millimetersPerSecond(1.5), millimetersPerSecond(2.0)},
      {0.24, 0.59, 0.45}};
  std::mt19937 random(4);
  const auto upTo = [&random](double most) {
    return most * static_cast<double>(random()) / 0x1p32;
  };
  constexpr double stiffness = 200.0, timeStep = 1e-3;
  int sliding = 0, sticking = 0;
  for (const FrictionLaw& law : {FrictionLaw{}, measured})
    for (int trial = 0; trial < 1000; ++trial) {
      double x[4], y[4], normal[4], slid[4], speed[4];
      double force[4], spring[4], slides[4], across[4], along[4];
      for (int lane = 0; lane < 4; ++lane) {
        x[lane] = upTo(10e-6), y[lane] = upTo(1e-6), normal[lane] = upTo(20e-3);
        slid[lane] = upTo(1.0) < 0.5 ? no : yes, speed[lane] = upTo(2.5e-3);
      }
      withLanes([&]() PERILYMPH_KERNEL {
        const FrictionStepOf<Four> step = frictionStepAt<Four>(
            {load<Four>(x, 0), load<Four>(y, 0), Four{}}, load<Four>(normal, 0), Four{} + stiffness,
            {load<Four>(slid, 0), load<Four>(speed, 0)}, law, timeStep);
        store(step.force_W.x, force, 0), store(step.spring_W.y, spring, 0);
        store(step.isSliding, slides, 0);
        store(step.across, across, 0), store(step.along, along, 0);
      });
      for (int lane = 0; lane < 4; ++lane) {
        const FrictionStep alone = frictionStep({x[lane], y[lane], 0.0}, normal[lane], stiffness,
                                                {slid[lane] == yes, speed[lane]}, law, timeStep);
        ASSERT_EQ(force[lane], alone.force_W.x());
        ASSERT_EQ(spring[lane], alone.spring_W.y());
        ASSERT_EQ(slides[lane] == yes, alone.isSliding);
        ASSERT_EQ(across[lane], alone.across);
        ASSERT_EQ(along[lane], alone.along);
        ++(alone.isSliding ? sliding : sticking);
      }
    }
  EXPECT_GT(sliding, 1000);
  EXPECT_GT(sticking, 1000);
}

TEST_P(Lanes, MoveEveryNodeAsAlone)
{
  const auto moved = [](std::size_t nodes) {
    const Piece piece(nodes);
    LinearSystem system(nodes);
    system.start_W = piece.position_W;
    std::mt19937 random(9);
    for (Vector3d& step : system.trial_W)
      for (double& x : step) x = 1e-5 * (static_cast<double>(random()) / 0x1p32 - 0.5);
    std::vector<Vector3d> position_W(nodes);
    moveBy(system, 0.7, position_W);
    return position_W;
  };
  const std::vector<Vector3d> longest = moved(40);
  for (std::size_t nodes = 5; nodes < 40; ++nodes) {
    const std::vector<Vector3d> here = moved(nodes);
    for (std::size_t i = 0; i < nodes; ++i) ASSERT_EQ(here[i], longest[i]) << i << " of " << nodes;
  }
}

constexpr std::array names{"Sse2", "Avx2", "Avx512"};
INSTANTIATE_TEST_SUITE_P(Instructions, Lanes,
                         testing::Values(Instructions::everywhere, Instructions::avx2,
                                         Instructions::avx512),
                         [](const auto& one) {
                           return names.at(static_cast<std::size_t>(one.param));
                         });

}  // namespace
}  // namespace perilymph::mechanics

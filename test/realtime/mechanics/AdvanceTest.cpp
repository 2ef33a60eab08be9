// SPDX-License-Identifier: BSD-3-Clause

// The real-time guarantees of the tick, tested on its most expensive step.

#include "perilymph/mechanics/advance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/AllocationGuard.h"

namespace perilymph::mechanics {
namespace {

/// A Contour in the published anatomy with scripted motion.
struct Insertion {
  explicit Insertion(const RelaxationLaw& relaxation = {})
      : model(InsertionModel::build(parts(relaxation))), state(*model)
  {
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    drive.handPosition_W = model->startBase_W;
  }
  static ModelParts parts(const RelaxationLaw& relaxation)
  {
    ModelParts parts;
    parts.lumen = anatomy::buildPublished({}, millimeters(1));
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    parts.relaxation = relaxation;
    return parts;
  }
  void pushTo(double travel, double perTick = 0.02e-3)
  {
    for (double at = perTick; at <= travel; at += perTick) {
      drive.handPosition_W = model->startBase_W + at * model->startAxis_W;
      advance(*model, state, drive);
    }
  }
  std::shared_ptr<const InsertionModel> model;
  InsertionState state;
  Drive drive;
};

static_assert(noexcept(advance(std::declval<const InsertionModel&>(),
                               std::declval<InsertionState&>(), std::declval<const Drive&>())));

TEST(Advance, AllocatesNothingWhileWiresYield)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  ModelParts parts = Insertion::parts({});
  electrode::Wires wires;
  wires.number = {{millimeters(0)}, {20.0}};
  wires.diameter = millimeters(0.025);
  wires.modulus = megapascals(168e3);
  wires.yieldStress.value = megapascals(50);
  parts.array.wires = wires;
  const auto model = InsertionModel::build(parts);
  InsertionState state(*model);
  Drive drive;
  drive.handAxis_W = model->startAxis_W;
  drive.handCurl_W = model->startCurl_W;
  const test::AllocationGuard guard;
  for (int i = 1; i <= 700; ++i) {
    drive.handPosition_W = model->startBase_W + (i * 0.02e-3) * model->startAxis_W;
    advance(*model, state, drive);
  }
  EXPECT_GT(state.readings.plasticWork, 0.0);
  EXPECT_EQ(guard.allocations(), 0u);
}

class AdvanceWith : public testing::TestWithParam<RelaxationLaw> {};

TEST_P(AdvanceWith, AllocatesNothingInDeepContact)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  Insertion insertion(GetParam());
  insertion.pushTo(16e-3);
  ASSERT_GT(insertion.state.readings.contacts, 40);
  const test::AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    insertion.drive.handPosition_W -= 0.01e-3 * insertion.model->entry.out_W;
    advance(*insertion.model, insertion.state, insertion.drive);
  }
  insertion.state.reset(*insertion.model);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(guard.frees(), 0u);
}

RelaxationLaw relaxing()
{
  return {{{{0.13, seconds(0.3)}, {0.28, seconds(6)}}}, {0.3, seconds(1)}};
}

INSTANTIATE_TEST_SUITE_P(AndWithoutRelaxation, AdvanceWith,
                         testing::Values(RelaxationLaw{}, relaxing()));

TEST(Advance, SaysWhenNumbersHaveOverflowed)
{
  for (const double poison : {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
    Insertion insertion;
    insertion.pushTo(8e-3);
    insertion.drive.handPosition_W.x() = poison;
    for (int i = 0; i < 5; ++i) advance(*insertion.model, insertion.state, insertion.drive);
    EXPECT_FALSE(insertion.state.readings.isFinite) << poison;
  }
}

TEST(Advance, SurvivesAHandThatJumps)
{
  Insertion insertion;
  insertion.pushTo(12e-3);
  for (const double jump : {3e-3, -3e-3, 10e-3, -10e-3}) {
    insertion.drive.handPosition_W += jump * insertion.model->entry.out_W;
    for (int i = 0; i < 50; ++i) {
      advance(*insertion.model, insertion.state, insertion.drive);
      ASSERT_TRUE(insertion.state.readings.isFinite) << jump;
      ASSERT_LE(insertion.state.readings.evaluations, SolverParameters{}.maxEvaluations);
      ASSERT_LE(insertion.state.readings.factorizations, SolverParameters{}.maxFactorizations);
    }
  }
}

TEST(Advance, FollowsASpringHand)
{
  // Free in the opening, the carrier of 17.9 g on a spring comes to rest where the hand is.
  Insertion insertion;
  insertion.drive.coupling = Coupling::spring;
  insertion.drive.couplingStiffness = 441.0;
  insertion.drive.couplingDamping = 3.0;
  insertion.drive.handPosition_W += 1e-3 * insertion.model->startAxis_W;
  for (int i = 0; i < 1000; ++i) advance(*insertion.model, insertion.state, insertion.drive);
  EXPECT_LT((insertion.state.base_W - insertion.drive.handPosition_W).norm(), 1e-6);
  EXPECT_LT(insertion.state.readings.handForce_W.norm(), 1e-4);
}

TEST(Advance, LagsASpringHandByForceOverStiffness)
{
  Insertion insertion;
  insertion.pushTo(12e-3);
  insertion.drive.coupling = Coupling::spring;
  insertion.drive.couplingStiffness = 441.0;
  insertion.drive.couplingDamping = 3.0;
  for (int i = 0; i < 2000; ++i) advance(*insertion.model, insertion.state, insertion.drive);
  const Eigen::Vector3d lag = insertion.state.base_W - insertion.drive.handPosition_W;
  EXPECT_GT(lag.norm(), 0.05e-3);
  EXPECT_LT((441.0 * lag - insertion.state.readings.handForce_W).norm(), 1e-5);
}

TEST(Advance, ContinuesFromACopyWithTheSameBits)
{
  // data kept for the next step (factors, clearances) are part of the state
  Insertion insertion;
  insertion.pushTo(10e-3);
  InsertionState copy = insertion.state;
  for (int i = 0; i < 50; ++i) {
    insertion.drive.handPosition_W += 0.02e-3 * insertion.model->startAxis_W;
    advance(*insertion.model, insertion.state, insertion.drive);
    advance(*insertion.model, copy, insertion.drive);
    ASSERT_EQ(copy.fingerprint(), insertion.state.fingerprint());
  }
}

TEST(Advance, HoldsTheBaseWhereTheHandIsAgainAfterASpring)
{
  Insertion insertion;
  insertion.pushTo(12e-3);
  insertion.drive.coupling = Coupling::spring;
  insertion.drive.couplingStiffness = 441.0;
  insertion.drive.couplingDamping = 3.0;
  for (int i = 0; i < 100; ++i) advance(*insertion.model, insertion.state, insertion.drive);
  insertion.drive.coupling = Coupling::rigid;
  for (int i = 0; i < 10; ++i) {
    advance(*insertion.model, insertion.state, insertion.drive);
    ASSERT_EQ(insertion.state.base_W, insertion.drive.handPosition_W);
    ASSERT_LE(insertion.state.readings.residual, 2e-6);
  }
}

}  // namespace
}  // namespace perilymph::mechanics

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

/// Whether the array is elastic, or relaxes, as its friction does, while wires and stylet yield.
enum class Material { elastic, inelastic };

/// A Contour in the published anatomy with scripted motion.
struct Insertion {
  explicit Insertion(Material material = Material::elastic)
      : model(InsertionModel::build(parts(material))), state(*model)
  {
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    drive.handPosition_W = model->startBase_W;
  }
  static ModelParts parts(Material material)
  {
    ModelParts parts;
    parts.lumen = anatomy::buildPublished({}, millimeters(1));
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    if (material == Material::elastic) return parts;
    parts.relaxation = {{{{0.13, seconds(0.3)}, {0.28, seconds(6)}}}, {0.3, seconds(1)}};
    electrode::Wires& wires = parts.array.wires.emplace();
    wires.number = {{millimeters(0)}, {20.0}};
    wires.diameter = millimeters(0.025);
    wires.modulus = megapascals(168e3);
    wires.coupling = 0.1;
    wires.yieldStress.value = megapascals(50);
    electrode::Stylet& stylet = parts.array.stylet;
    stylet.diameter = millimeters(0.15);
    stylet.bending = newtonSquareMeters(4.2e-6);
    stylet.yieldStress.value = megapascals(650);
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

class AdvanceWith : public testing::TestWithParam<Material> {};

TEST_P(AdvanceWith, AllocatesNothingInDeepContact)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  Insertion insertion(GetParam());
  insertion.pushTo(16e-3);
  ASSERT_GT(insertion.state.readings.contacts, 40);
  const test::AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    insertion.drive.handPosition_W -= 0.01e-3 * insertion.model->entry.out_W;
    insertion.drive.styletWithdrawal += 0.01e-3;
    advance(*insertion.model, insertion.state, insertion.drive);
  }
  if (GetParam() == Material::inelastic) {
    EXPECT_GT(insertion.state.readings.plasticWork, 0.0);
  }
  insertion.state.reset(*insertion.model);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(guard.frees(), 0u);
}

INSTANTIATE_TEST_SUITE_P(ElasticAndNot, AdvanceWith,
                         testing::Values(Material::elastic, Material::inelastic));

TEST(Advance, KeepsTheBoundOfItsWorkWhileWiresAndStyletYield)
{
  Insertion insertion(Material::inelastic);
  for (double at = 0.02e-3; at <= 16e-3; at += 0.02e-3) {
    insertion.drive.handPosition_W =
        insertion.model->startBase_W + at * insertion.model->startAxis_W;
    advance(*insertion.model, insertion.state, insertion.drive);
    ASSERT_LE(insertion.state.readings.evaluations, SolverParameters{}.maxEvaluations) << at;
    ASSERT_LE(insertion.state.readings.factorizations, SolverParameters{}.maxFactorizations) << at;
    ASSERT_LE(insertion.state.readings.residual, SolverParameters{}.forceTolerance) << at;
  }
}

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

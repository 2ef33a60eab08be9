// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/TickBound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

std::shared_ptr<const mechanics::InsertionModel> ring(int nodes, Duration timeStep)
{
  mechanics::ModelParts parts = test::insertionInRing()->parts;
  parts.nodes = nodes;
  parts.timeStep = timeStep;
  return mechanics::InsertionModel::build(std::move(parts));
}

TEST(TickBound, IsMeasuredInTicksThatUseTheirWork)
{
  const auto model = ring(60, milliseconds(1));
  const auto bound = measureTickBound(*model);
  ASSERT_TRUE(bound);
  const mechanics::SolverParameters& solver = model->parts.solver;
  EXPECT_GE(bound->evaluations, solver.maxEvaluations / 2);
  EXPECT_LE(bound->evaluations, solver.maxEvaluations);
  EXPECT_GE(bound->factorizations, solver.maxFactorizations / 2);
  EXPECT_LE(bound->factorizations, solver.maxFactorizations);
  EXPECT_GT(bound->evaluation, 0.0);
  EXPECT_GE(bound->time, solver.maxEvaluations * bound->evaluation +
                             solver.maxFactorizations * bound->factorization);
}

/// The work of a tick is linear in the nodes.
TEST(TickBound, GrowsWithTheNodes)
{
  const auto few = measureTickBound(*ring(40, milliseconds(1)));
  const auto many = measureTickBound(*ring(400, milliseconds(1)));
  ASSERT_TRUE(few && many);
  EXPECT_GT(many->time, 3.0 * few->time);
}

TEST(TickBound, ThatCanBeFeltIsRefusedWithNodesThatFit)
{
  const auto refused = checkTickBound(*ring(1000, milliseconds(0.1)));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::AllOf(testing::HasSubstr("With 1000 nodes"),
                                                      testing::HasSubstr("longer than 1.00 ms"),
                                                      testing::HasSubstr("Set nodes to at most")));
  EXPECT_TRUE(checkTickBound(*ring(20, milliseconds(10))));
}

}  // namespace
}  // namespace perilymph::haptics

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "validation/GaussNewton2.h"

namespace perilymph::analysis {
namespace {

constexpr TwoBounds wide{{-10.0, -10.0}, {10.0, 10.0}, {0.1, 0.1}, 1};

/// Residuals that are straight lines: r = M x - c.
Result<TwoNumbers> straight(const TwoNumbers& at)
{
  return TwoNumbers{2.0 * at.a + 1.0 * at.b - 4.0, 1.0 * at.a + 3.0 * at.b - 7.0};
}

TEST(FitOfTwoNumbers, SolvesTwoLinearEquations)
{
  // 2 a + b = 4 and a + 3 b = 7: a = 1, b = 2
  const auto fit = gaussNewton2(straight, {0.0, 0.0}, wide);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->at.a, 1.0, 1e-3);
  EXPECT_NEAR(fit->at.b, 2.0, 1e-3);
}

TEST(FitOfTwoNumbers, GivesTheStandardErrorsOfTheNormalMatrix)
{
  // M^T M = [[5, 5], [5, 10]], its inverse [[0.4, -0.2], [-0.2, 0.2]]
  const auto fit = gaussNewton2(straight, {0.0, 0.0}, wide);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->standardDeviation.a, std::sqrt(0.4), 1e-9);
  EXPECT_NEAR(fit->standardDeviation.b, std::sqrt(0.2), 1e-9);
}

TEST(FitOfTwoNumbers, MinimizesAlongAnActiveBoundAndReportsIt)
{
  // With b held at 1: minimize (2 a - 3)^2 + (a - 4)^2, so a = 2 and a has the error 1/sqrt(5).
  TwoBounds bounds = wide;
  bounds.high.b = 1.0;
  const auto fit = gaussNewton2(straight, {0.0, 0.0}, bounds);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->at.a, 2.0, 5e-3);
  EXPECT_EQ(fit->at.b, 1.0);
  EXPECT_NEAR(fit->standardDeviation.a, 1.0 / std::sqrt(5.0), 1e-9);
  EXPECT_EQ(fit->standardDeviation.b, 0.0);
}

TEST(FitOfTwoNumbers, ReturnsTheErrorOfATrial)
{
  const auto fit = gaussNewton2([](const TwoNumbers&) -> Result<TwoNumbers> { return Error{"no"}; },
                                {0.0, 0.0}, wide);
  ASSERT_FALSE(fit);
  EXPECT_EQ(fit.error().message, "no");
}

}  // namespace
}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/LeastSquaresSpline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace perilymph::validation {
namespace {

double cubic(double x) { return 0.3 - 2.0 * x + 0.7 * x * x - 0.05 * x * x * x; }

std::vector<double> even(double low, double high, int count)
{
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(low + (high - low) * i / (count - 1));
  return x;
}

TEST(LeastSquaresSpline, ReproducesEveryCubic)
{
  const std::vector<double> x = even(0.0, 16.5, 166);
  std::vector<double> y;
  for (const double place : x) y.push_back(cubic(place));
  const auto spline = fitSpline(x, y, 0.0, 16.5, 22);
  ASSERT_TRUE(spline);
  for (const double place : even(0.0, 16.5, 997))
    EXPECT_NEAR(spline->at(place), cubic(place), 1e-9) << place;
}

TEST(LeastSquaresSpline, OfOneIntervalIsTheRegressionByACubicPolynomial)
{
  // Symmetric data 1, 0, 1, 0, 1 at -2 .. 2: the normal equations of a + b x^2 give a = 11/35 and
  // b = 1/7; odd powers vanish.
  const std::vector<double> x = {-2, -1, 0, 1, 2};
  const std::vector<double> y = {1, 0, 1, 0, 1};
  const auto spline = fitSpline(x, y, -2.0, 2.0, 1);
  ASSERT_TRUE(spline);
  for (const double place : even(-2.0, 2.0, 9))
    EXPECT_NEAR(spline->at(place), 11.0 / 35.0 + place * place / 7.0, 1e-12) << place;
}

TEST(LeastSquaresSpline, LeavesResidualsThatNoSplineCouldLower)
{
  const std::vector<double> x = even(0.0, 10.0, 80);
  std::vector<double> y;
  for (std::size_t i = 0; i < x.size(); ++i)
    y.push_back(std::sin(3.0 * x[i]) + (i % 2 == 0 ? 0.1 : -0.1));
  const auto spline = fitSpline(x, y, 0.0, 10.0, 12);
  ASSERT_TRUE(spline);
  // The residuals of a least-squares fit are orthogonal to every function of its space, so to every
  // cubic.
  for (int power = 0; power <= 3; ++power) {
    double product = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      product += (y[i] - spline->at(x[i])) * std::pow(x[i] / 10.0, power);
    EXPECT_NEAR(product, 0.0, 1e-9) << "power " << power;
  }
}

TEST(LeastSquaresSpline, IgnoresPointsOutsideItsInterval)
{
  std::vector<double> x = even(0.0, 1.0, 20);
  std::vector<double> y(20, 0.25);
  for (const double far : {-0.5, 1.5}) {
    x.push_back(far);
    y.push_back(100.0);
  }
  const auto spline = fitSpline(x, y, 0.0, 1.0, 3);
  ASSERT_TRUE(spline);
  EXPECT_NEAR(spline->at(0.7), 0.25, 1e-12);
}

TEST(LeastSquaresSpline, IsRefusedWherePointsAreMissing)
{
  std::vector<double> x = even(0.0, 3.0, 40);  // nothing between 3 and 10
  const std::vector<double> y(x.size(), 1.0);
  EXPECT_FALSE(fitSpline(x, y, 0.0, 10.0, 10));
  EXPECT_FALSE(fitSpline({}, {}, 0.0, 10.0, 10));
  EXPECT_FALSE(fitSpline(x, y, 0.0, 3.0, 0));
}

}  // namespace
}  // namespace perilymph::validation

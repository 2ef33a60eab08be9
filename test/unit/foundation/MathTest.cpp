// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

// The oracle is the C library's long double arithmetic, 11 bits finer than double.

namespace perilymph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int many = 200000;

/// Dense and random arguments between two ends, the ends included.
std::vector<double> arguments(double low, double high)
{
  std::vector<double> values;
  std::mt19937_64 bits(7);
  for (int i = 0; i <= many; ++i) {
    values.push_back(std::min(high, low + (high - low) * i / many));
    values.push_back(low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53));
  }
  return values;
}

double worstOfExponential(double low, double high)
{
  long double worst = 0.0L;
  for (const double x : arguments(low, high)) {
    const long double exact = std::exp(static_cast<long double>(x));
    worst = std::max(worst, std::fabs((exponential(x) - exact) / exact));
  }
  return static_cast<double>(worst);
}

TEST(Exponential, IsWithinItsRelativeErrorEverywhere)
{
  EXPECT_LT(worstOfExponential(-700.0, 700.0), 2e-15);
  EXPECT_LT(worstOfExponential(-1.0, 1.0), 2e-15);
  EXPECT_LT(worstOfExponential(-1e-6, 1e-6), 2e-15);
}

TEST(Exponential, KnowsItsEnds)
{
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-0.0), 1.0);
  EXPECT_EQ(exponential(710.0), infinity);
  EXPECT_EQ(exponential(infinity), infinity);
  EXPECT_EQ(exponential(-746.0), 0.0);
  EXPECT_EQ(exponential(-infinity), 0.0);
  EXPECT_TRUE(std::isnan(exponential(nan)));
}

TEST(Exponential, ReachesTheLargestAndTheSmallestNumbers)
{
  constexpr double nearLargest = 709.78;
  EXPECT_NEAR(exponential(nearLargest) / std::exp(nearLargest), 1.0, 2e-15);
  EXPECT_EQ(exponential(-745.0), std::numeric_limits<double>::denorm_min());
}

double worstOfLogarithm(double low, double high)
{
  long double worst = 0.0L;
  for (const double x : arguments(low, high)) {
    const long double exact = std::log(static_cast<long double>(x));
    worst = std::max(worst, std::fabs(logarithm(x) - exact) / std::max(1.0L, std::fabs(exact)));
  }
  return static_cast<double>(worst);
}

TEST(Logarithm, IsWithinItsErrorEverywhere)
{
  EXPECT_LT(worstOfLogarithm(1e-3, 1e3), 2e-15);
  EXPECT_LT(worstOfLogarithm(0.5, 2.0), 2e-15);
  EXPECT_LT(worstOfLogarithm(1e299, 1e300), 2e-15);
  EXPECT_LT(worstOfLogarithm(1e-300, 1e-299), 2e-15);
}

TEST(Logarithm, KeepsItsDigitsBesideOne)
{
  for (const double step : {1e-15, 1e-12, 1e-8, -1e-8, -1e-12, -1e-15}) {
    const double x = 1.0 + step;
    const long double exact = std::log(static_cast<long double>(x));
    EXPECT_NEAR(static_cast<double>(logarithm(x) / exact), 1.0, 2e-15) << step;
  }
}

TEST(Logarithm, KnowsItsEnds)
{
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_EQ(logarithm(infinity), infinity);
  EXPECT_TRUE(std::isnan(logarithm(0.0)));
  EXPECT_TRUE(std::isnan(logarithm(-1.0)));
  EXPECT_TRUE(std::isnan(logarithm(nan)));
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_NEAR(logarithm(smallest), -1074.0 * std::log(2.0), 1e-12);
}

/// Maximum error relative to the documented bound.
double worstFractionOfSineCosine(double low, double high)
{
  long double worst = 0.0L;
  for (const double angle : arguments(low, high)) {
    const long double promised = 1e-15L + 1e-16L * std::fabs(angle);
    const SineCosine both = sineCosine(angle);
    const auto exact = static_cast<long double>(angle);
    worst = std::max({worst, std::fabs(both.sine - std::sin(exact)) / promised,
                      std::fabs(both.cosine - std::cos(exact)) / promised});
  }
  return static_cast<double>(worst);
}

TEST(SineCosine, IsWithinItsErrorEverywhere)
{
  EXPECT_LT(worstFractionOfSineCosine(-99999.9, 99999.9), 1.0);
  EXPECT_LT(worstFractionOfSineCosine(-20.0, 20.0), 1.0);
  EXPECT_LT(worstFractionOfSineCosine(-1e-3, 1e-3), 1.0);
}

TEST(SineCosine, IsWithinItsErrorBesideEveryQuarterTurn)
{
  const double quarter = std::acos(0.0);
  for (int i = -60000; i <= 60000; i += 7) {
    const double angle = i * quarter;
    const SineCosine both = sineCosine(angle);
    const double promised = 1e-15 + 1e-16 * std::fabs(angle);
    ASSERT_NEAR(both.sine, static_cast<double>(std::sin(static_cast<long double>(angle))),
                promised);
    ASSERT_NEAR(both.cosine, static_cast<double>(std::cos(static_cast<long double>(angle))),
                promised);
  }
}

TEST(SineCosine, IsExactAtZero)
{
  EXPECT_EQ(sineCosine(0.0).sine, 0.0);
  EXPECT_EQ(sineCosine(0.0).cosine, 1.0);
}

TEST(SineCosine, IsNaNBeyondItsRange)
{
  for (const double angle : {1e5, -1e5, 1e300, infinity, -infinity, nan}) {
    EXPECT_TRUE(std::isnan(sineCosine(angle).sine)) << angle;
    EXPECT_TRUE(std::isnan(sineCosine(angle).cosine)) << angle;
  }
}

double errorOfArcTangent(double y, double x)
{
  const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  return static_cast<double>(std::fabs(arcTangent(y, x) - exact));
}

TEST(ArcTangent, IsWithinItsErrorInEveryDirection)
{
  double worst = 0.0;
  for (int i = 0; i < 2 * many; ++i) {
    const double direction = 2.0 * std::acos(-1.0) * i / (2 * many);
    worst = std::max(worst, errorOfArcTangent(std::sin(direction), std::cos(direction)));
  }
  EXPECT_LT(worst, 2e-15);
}

TEST(ArcTangent, IsWithinItsErrorWhateverTheDistance)
{
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> exponent(-290.0, 290.0);
  double worst = 0.0;
  for (int i = 0; i < many; ++i) {
    const double y = std::pow(10.0, exponent(bits)) * (i % 2 == 0 ? 1.0 : -1.0);
    const double x = std::pow(10.0, exponent(bits)) * (i % 3 == 0 ? 1.0 : -1.0);
    worst = std::max(worst, errorOfArcTangent(y, x));
  }
  EXPECT_LT(worst, 2e-15);
}

TEST(ArcTangent, KeepsItsDigitsNearTheAxis)
{
  for (const double y : {1e-3, 1e-8, 1e-200})
    EXPECT_NEAR(arcTangent(y, 1.0) / std::atan(y), 1.0, 1e-15);
}

TEST(ArcTangent, IsAboveMinusPiAndAtMostPi)
{
  const double half = std::acos(-1.0);
  EXPECT_EQ(arcTangent(0.0, -1.0), half);
  EXPECT_EQ(arcTangent(-0.0, -1.0), half);
  EXPECT_EQ(arcTangent(1.0, 0.0), 0.5 * half);
  EXPECT_EQ(arcTangent(-1.0, 0.0), -0.5 * half);
  EXPECT_EQ(arcTangent(0.0, 1.0), 0.0);
}

TEST(ArcTangent, IsZeroAtTheOrigin)
{
  for (const double y : {0.0, -0.0})
    for (const double x : {0.0, -0.0}) EXPECT_EQ(arcTangent(y, x), 0.0);
}

TEST(ArcTangent, HasNoStepWhereItsFormulaChanges)
{
  const double quarter = std::acos(-1.0) / 4.0;
  for (const double direction : {0.5 * quarter, quarter, 1.5 * quarter, 2.0 * quarter}) {
    const double before = std::nextafter(std::tan(direction / 2.0), 0.0);
    const double after = std::nextafter(std::tan(direction / 2.0), 10.0);
    const double step = arcTangent(after, 1.0) - arcTangent(before, 1.0);
    EXPECT_NEAR(step, 0.0, 1e-15);
  }
}

TEST(Power, AgreesWithRepeatedProducts)
{
  double product = 1.0;
  for (int exponent = 0; exponent < 30; ++exponent) {
    EXPECT_NEAR(power(1.7, exponent) / product, 1.0, 2e-14) << exponent;
    product *= 1.7;
  }
}

}  // namespace
}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/FrictionBySpeed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "perilymph/mechanics/FrictionLaw.h"

namespace perilymph::mechanics {
namespace {

/// Rises, then falls, as measured on a tissue simulant (Dohr et al. 2021).
FrictionBySpeed hump()
{
  return {{millimetersPerSecond(0.1), millimetersPerSecond(1.5), millimetersPerSecond(2.0)},
          {0.24, 0.59, 0.45}};
}

TEST(FrictionBySpeed, IsWhatWasMeasuredWhereItWasMeasured)
{
  EXPECT_DOUBLE_EQ(hump().at(0.1e-3), 0.24);
  EXPECT_DOUBLE_EQ(hump().at(1.5e-3), 0.59);
  EXPECT_DOUBLE_EQ(hump().at(2.0e-3), 0.45);
}

TEST(FrictionBySpeed, StaysBeyondWhatWasMeasured)
{
  EXPECT_DOUBLE_EQ(hump().at(0.0), 0.24);
  EXPECT_DOUBLE_EQ(hump().at(0.2), 0.45);
}

TEST(FrictionBySpeed, RisesToThePeakAndFallsFromItWithoutWaves)
{
  for (double speed = 0.1e-3; speed < 1.498e-3; speed += 1e-6)
    ASSERT_LE(hump().at(speed), hump().at(speed + 1e-6) + 1e-12) << speed;
  for (double speed = 1.5e-3; speed < 2.0e-3; speed += 1e-6)
    ASSERT_GE(hump().at(speed), hump().at(speed + 1e-6) - 1e-12) << speed;
}

TEST(FrictionBySpeed, HasNoKinksWhereItKeepsRising)
{
  const FrictionBySpeed rising({Speed::fromSi(0.0), Speed::fromSi(1.0), Speed::fromSi(3.0)},
                               {0.1, 0.2, 0.6});
  constexpr double step = 1e-6;
  const double before = (rising.at(1.0) - rising.at(1.0 - step)) / step;
  const double after = (rising.at(1.0 + step) - rising.at(1.0)) / step;
  EXPECT_NEAR(before, after, 1e-5);
  // between the slopes of both sides, 0.1 and 0.2
  EXPECT_GT(before, 0.1);
  EXPECT_LT(before, 0.2);
}

TEST(FrictionBySpeed, HasTheSlopeOfItsCurve)
{
  constexpr double step = 1e-8;
  for (double speed = 0.05e-3; speed < 2.2e-3; speed += 0.0173e-3)
    EXPECT_NEAR(hump().slopeAt(speed),
                (hump().at(speed + step) - hump().at(speed - step)) / (2 * step), 1e-2)
        << speed;
}

TEST(FrictionBySpeed, RefusesSpeedsThatDoNotGrowAndCoefficientsOutOfRange)
{
  const Speed slow = millimetersPerSecond(1), fast = millimetersPerSecond(2);
  EXPECT_THROW(FrictionBySpeed({fast, slow}, {0.1, 0.2}), std::invalid_argument);
  EXPECT_THROW(FrictionBySpeed({slow, fast}, {0.1}), std::invalid_argument);
  EXPECT_THROW(FrictionBySpeed({slow, fast}, {0.1, -0.2}), std::invalid_argument);
  EXPECT_THROW(FrictionBySpeed({slow, fast}, {0.1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(FrictionBySpeed({}, {}), std::invalid_argument);
}

TEST(FrictionLaw, WithoutATableFallsFromStartingToDynamicOverTheStribeckSpeed)
{
  const FrictionLaw law{0.3, 0.1, 0.05, millimetersPerSecond(0.1), {}};
  EXPECT_DOUBLE_EQ(law.sliding(0.0), 0.3);
  EXPECT_NEAR(law.sliding(0.1e-3), 0.2, 1e-12);  // half way at the Stribeck speed
  EXPECT_NEAR(law.sliding(1.0), 0.1, 1e-6);
}

TEST(FrictionLaw, ScaledHasItsCoefficientsTimesTheFactorAtTheSameSpeeds)
{
  const FrictionLaw law{0.3, 0.1, 0.05, millimetersPerSecond(0.4), {}};
  const FrictionLaw half = law.scaled(0.5);
  EXPECT_DOUBLE_EQ(half.staticCoefficient, 0.15);
  EXPECT_DOUBLE_EQ(half.stoppingCoefficient, 0.025);
  EXPECT_NEAR(half.sliding(0.4e-3), 0.1, 1e-12);  // half of 0.2, half way at the Stribeck speed
  EXPECT_DOUBLE_EQ(law.scaled(100.0).staticCoefficient, 2.0);  // the maximum of a coefficient
}

}  // namespace
}  // namespace perilymph::mechanics

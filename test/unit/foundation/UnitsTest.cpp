// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace perilymph {
namespace {

static_assert(!std::is_convertible_v<double, Length>, "a bare number is no length");
static_assert(!std::is_convertible_v<Length, double>, "a length is no bare number");
static_assert(!std::is_constructible_v<Force, Length>, "a length is no force");

TEST(Units, AMillimeterIsAThousandthOfAMeter)
{
  EXPECT_DOUBLE_EQ(millimeters(24.0).si(), 0.024);
  EXPECT_DOUBLE_EQ(inMillimeters(meters(0.024)), 24.0);
}

TEST(Units, AFullTurnHas360Degrees)
{
  EXPECT_DOUBLE_EQ(degrees(360.0).si(), 2.0 * std::acos(-1.0));
  EXPECT_DOUBLE_EQ(inDegrees(radians(std::acos(-1.0))), 180.0);
}

TEST(Units, ACurvatureIsOneOverItsRadius)
{
  const Length radius = millimeters(2.5);
  EXPECT_DOUBLE_EQ(perMillimeter(1.0 / 2.5).si(), 1.0 / radius.si());
}

TEST(Units, GoInAndOutUnchanged)
{
  EXPECT_DOUBLE_EQ(inMillinewtons(millinewtons(88.0)), 88.0);
  EXPECT_DOUBLE_EQ(inMillimetersPerSecond(millimetersPerSecond(2.0)), 2.0);
  EXPECT_DOUBLE_EQ(inMilliseconds(milliseconds(50.0)), 50.0);
}

TEST(Units, TheRatioOfTwoLengthsIsANumber)
{
  EXPECT_DOUBLE_EQ(millimeters(22.0) / meters(0.011), 2.0);
}

}  // namespace
}  // namespace perilymph

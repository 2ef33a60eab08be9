// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Math.h"

#include <bit>
#include <cstdint>
#include <limits>

namespace perilymph {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// log(2) in two pieces: the first has 33 bits, so its product with an exponent is exact.
constexpr double logOfTwoHigh = 0x1.62e42fefp-1;
constexpr double logOfTwoLow = 0x1.473de6af278edp-34;

// pi/2 in three pieces of 33, 33 and 53 bits: products with a count below 2^20 are exact.
constexpr double quarterHigh = 0x1.921fb544p+0;
constexpr double quarterMiddle = 0x1.0b4611a6p-34;
constexpr double quarterLow = 0x1.3198a2e037073p-69;

/// The nearest integer, for |x| < 2^51: numbers near 1.5 * 2^52 have no fraction bits.
double nearestWhole(double x) noexcept
{
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

/// 2 to the power `exponent`, from -1022 to 1023.
double powerOfTwo(std::int64_t exponent) noexcept
{
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// sin(x) for |x| <= pi/4: the Taylor series to x^17, whose next term is below 1e-19.
double sineNearZero(double x) noexcept
{
  const double z = x * x;
  const double series =
      -1.0 / 6 +
      z * (1.0 / 120 +
           z * (-1.0 / 5040 + z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                       z * (1.0 / 6227020800 +
                                                            z * (-1.0 / 1307674368000 +
                                                                 z * (1.0 / 355687428096000)))))));
  return x + x * (z * series);
}

/// cos(x) for |x| <= pi/4: the Taylor series to x^16, whose next term is below 3e-18.
double cosineNearZero(double x) noexcept
{
  const double z = x * x;
  const double series =
      1.0 / 24 +
      z * (-1.0 / 720 +
           z * (1.0 / 40320 +
                z * (-1.0 / 3628800 + z * (1.0 / 479001600 + z * (-1.0 / 87178291200 +
                                                                  z * (1.0 / 20922789888000))))));
  return 1.0 + (-0.5 * z + z * (z * series));
}

}  // namespace

double exponential(double x) noexcept
{
  if (x != x) return nan;
  if (x > 709.782712893384) return infinity;
  if (x < -745.1332191019412) return 0.0;

  // e^x = 2^count e^rest with |rest| <= log(2) / 2
  constexpr double perLogOfTwo = 0x1.71547652b82fep+0;
  const double count = nearestWhole(x * perLogOfTwo);
  const double rest = (x - count * logOfTwoHigh) - count * logOfTwoLow;

  // Taylor series of e^rest - 1 - rest to the 14th power; the next term is below 1e-19.
  const double series =
      0.5 +
      rest *
          (1.0 / 6 +
           rest *
               (1.0 / 24 +
                rest *
                    (1.0 / 120 +
                     rest *
                         (1.0 / 720 +
                          rest *
                              (1.0 / 5040 +
                               rest *
                                   (1.0 / 40320 +
                                    rest *
                                        (1.0 / 362880 +
                                         rest *
                                             (1.0 / 3628800 +
                                              rest *
                                                  (1.0 / 39916800 +
                                                   rest * (1.0 / 479001600 +
                                                           rest * (1.0 / 6227020800 +
                                                                   rest * (1.0 /
                                                                           87178291200))))))))))));
  const double power = 1.0 + (rest + rest * rest * series);

  // In two factors: 2^count alone may be out of range for results near the limits.
  const auto exponent = static_cast<std::int64_t>(count);
  const std::int64_t half = exponent / 2;
  return power * powerOfTwo(half) * powerOfTwo(exponent - half);
}

double logarithm(double x) noexcept
{
  if (!(x > 0.0)) return nan;
  if (x == infinity) return infinity;

  // x = 2^exponent mantissa, mantissa between sqrt(1/2) and sqrt(2)
  std::int64_t exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  constexpr std::uint64_t rootOfHalf = 0x3fe6a09e667f3bcd;  // sqrt(1/2) as bits
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const auto shift = static_cast<std::int64_t>(bits - rootOfHalf) >> 52;
  exponent += shift;
  const double mantissa = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(shift) << 52));

  // log(mantissa) = 2 atanh(s), s = (mantissa - 1) / (mantissa + 1), |s| < 0.172. The series is
  // taken to s^23; the next term is below 1e-20.
  const double above = mantissa - 1.0;
  const double s = above / (mantissa + 1.0);
  const double z = s * s;
  const double series =
      2.0 / 3 +
      z * (2.0 / 5 +
           z * (2.0 / 7 +
                z * (2.0 / 9 +
                     z * (2.0 / 11 +
                          z * (2.0 / 13 +
                               z * (2.0 / 15 +
                                    z * (2.0 / 17 +
                                         z * (2.0 / 19 + z * (2.0 / 21 + z * (2.0 / 23))))))))));
  const double count = static_cast<double>(exponent);
  return count * logOfTwoHigh + (2.0 * s + (s * (z * series) + count * logOfTwoLow));
}

SineCosine sineCosine(double angle) noexcept
{
  if (!(std::fabs(angle) < 1e5)) return {nan, nan};

  // angle = quarters * pi/2 + rest with |rest| <= pi/4
  constexpr double perQuarter = 0x1.45f306dc9c883p-1;
  const double quarters = nearestWhole(angle * perQuarter);
  const double rest =
      ((angle - quarters * quarterHigh) - quarters * quarterMiddle) - quarters * quarterLow;

  const double sine = sineNearZero(rest);
  const double cosine = cosineNearZero(rest);
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace perilymph

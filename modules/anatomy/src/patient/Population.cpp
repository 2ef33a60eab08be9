// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Population.h"

#include <cmath>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

constexpr std::size_t count = 4;
using Four = std::array<double, count>;

// In the order A1, B1, A2, B2.
constexpr Four mean_mm{5.97, 3.95, 3.26, 2.85};
constexpr Four deviation_mm{0.36, 0.35, 0.28, 0.33};
constexpr std::array<Four, count> correlation{{{1.0, 0.53476, -0.12441, -0.07296},
                                               {0.53476, 1.0, 0.11668, -0.43748},
                                               {-0.12441, 0.11668, 1.0, 0.57846},
                                               {-0.07296, -0.43748, 0.57846, 1.0}}};

// Rows: 1, A1, B1, A2, B2 [mm]; columns: powers of the angle [rad]. Gives millimeters.
constexpr std::array<Four, count + 1> radius{
    {{-0.0972007477234853, 0.0652777719428317, 0.00579010295961996, -0.000410053336041606},
     {0.745407586062517, -0.297795950930632, 0.0353079060718429, -0.00125774660897636},
     {0.349940654425921, -0.0488173880945223, 0.00235713329581525, -3.38189250648794e-05},
     {0.0567728210841444, 0.115930983938798, -0.0170603835499829, 0.000605305012135639},
     {-0.0613995454924607, 0.170502985259421, -0.0267552502171719, 0.00111572946871731}}};

constexpr std::array<double, count + 1> turn_deg{
    963.166310413576, 6.37772934525638, -26.9585473096045, -36.3953582023656, 66.9416454453684};

// A is the sum of A1 and A2, B of B1 and B2.
constexpr std::array<Four, 2> sums{{{1.0, 0.0, 1.0, 0.0}, {0.0, 1.0, 0.0, 1.0}}};

constexpr double deviationsAllowed = 4.0;

Four inMillimetersOf(const HalfDiameters& half)
{
  return {half.a1 * 1e3, half.b1 * 1e3, half.a2 * 1e3, half.b2 * 1e3};
}

HalfDiameters fromMillimeters(const Four& value_mm)
{
  return {value_mm[0] / 1e3, value_mm[1] / 1e3, value_mm[2] / 1e3, value_mm[3] / 1e3};
}

/// Covariance of each half-diameter with A or B [mm^2].
Four covarianceWith(const Four& sum)
{
  Four result{};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < count; ++k)
      result[i] += correlation[i][k] * deviation_mm[i] * deviation_mm[k] * sum[k];
  return result;
}

double sumOf(const Four& sum, const Four& values)
{
  return sum[0] * values[0] + sum[1] * values[1] + sum[2] * values[2] + sum[3] * values[3];
}

/// Pseudorandom integers from a seed: SplitMix64 (Steele, Lea and Flood 2014).
class Shuffled {
public:
  explicit Shuffled(std::uint64_t seed) : state_(seed) { state_ = next(); }

  std::uint64_t next()
  {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t bits = state_;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
  }

  /// Uniform in (0, 1], a multiple of 2^-53.
  double uniform() { return static_cast<double>((next() >> 11) + 1) * 0x1p-53; }

private:
  std::uint64_t state_;
};

/// Four independent standard normal deviates (Box and Muller 1958).
Four normalDeviates(Shuffled& shuffled)
{
  Four deviates{};
  for (std::size_t i = 0; i < count; i += 2) {
    const double length = std::sqrt(-2.0 * logarithm(shuffled.uniform()));
    const SineCosine turn = sineCosine(2.0 * pi * shuffled.uniform());
    deviates[i] = length * turn.cosine;
    deviates[i + 1] = length * turn.sine;
  }
  return deviates;
}

/// Cholesky factor (lower triangle) of the correlation matrix.
std::array<Four, count> rootOfCorrelation()
{
  std::array<Four, count> root{};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      double rest = correlation[i][k];
      for (std::size_t j = 0; j < k; ++j) rest -= root[i][j] * root[k][j];
      root[i][k] = i == k ? std::sqrt(rest) : rest / root[k][k];
    }
  return root;
}

Spread spreadOf(const Four& sum)
{
  const double mean = sumOf(sum, mean_mm);
  const double standardDeviation = std::sqrt(sumOf(sum, covarianceWith(sum)));
  const double reach = deviationsAllowed * standardDeviation;
  return {millimeters(mean), millimeters(standardDeviation), millimeters(mean - reach),
          millimeters(mean + reach)};
}

}  // namespace

HalfDiameters meanHalfDiameters() { return fromMillimeters(mean_mm); }

std::array<std::array<double, 4>, 4> halfDiameterCovariance()
{
  std::array<std::array<double, 4>, 4> result{};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < count; ++k)
      result[i][k] = correlation[i][k] * deviation_mm[i] * deviation_mm[k] / 1e6;
  return result;
}

HalfDiameters likeliestHalfDiameters(Length a, Length b)
{
  // mean + S C^T (C S C^T)^-1 (given - C mean), with S the covariance and C the sums
  const Four withA = covarianceWith(sums[0]);
  const Four withB = covarianceWith(sums[1]);
  const double aa = sumOf(sums[0], withA);
  const double bb = sumOf(sums[1], withB);
  const double ab = sumOf(sums[0], withB);
  const double offA = inMillimeters(a) - sumOf(sums[0], mean_mm);
  const double offB = inMillimeters(b) - sumOf(sums[1], mean_mm);
  const double determinant = aa * bb - ab * ab;
  const double weightA = (bb * offA - ab * offB) / determinant;
  const double weightB = (aa * offB - ab * offA) / determinant;
  Four half_mm = mean_mm;
  for (std::size_t i = 0; i < count; ++i) half_mm[i] += weightA * withA[i] + weightB * withB[i];
  return fromMillimeters(half_mm);
}

HalfDiameters individualHalfDiameters(Length a, Length b, std::array<double, 2> deviates)
{
  // Given A and B, A1 and B1 deviate by x, A2 and B2 by -x: the conditional covariance of A1 and B1,
  // S - S C^T (C S C^T)^-1 C S, by its Cholesky factor.
  const Four withA = covarianceWith(sums[0]);
  const Four withB = covarianceWith(sums[1]);
  const double aa = sumOf(sums[0], withA);
  const double bb = sumOf(sums[1], withB);
  const double ab = sumOf(sums[0], withB);
  const double determinant = aa * bb - ab * ab;
  const auto conditional = [&](std::size_t i, std::size_t k) {
    const double explained = (bb * withA[i] * withA[k] + aa * withB[i] * withB[k] -
                              ab * (withA[i] * withB[k] + withB[i] * withA[k])) /
                             determinant;
    return correlation[i][k] * deviation_mm[i] * deviation_mm[k] - explained;
  };
  const double first = std::sqrt(conditional(0, 0));
  const double cross = conditional(0, 1) / first;
  const double second = std::sqrt(conditional(1, 1) - cross * cross);
  const double a1_mm = first * deviates[0];
  const double b1_mm = cross * deviates[0] + second * deviates[1];
  Four half_mm = inMillimetersOf(likeliestHalfDiameters(a, b));
  half_mm[0] += a1_mm;
  half_mm[1] += b1_mm;
  half_mm[2] -= a1_mm;
  half_mm[3] -= b1_mm;
  return fromMillimeters(half_mm);
}

double outerWallRadius(const HalfDiameters& half, Angle angle)
{
  const Four x = inMillimetersOf(half);
  double result_mm = 0.0;
  for (std::size_t power = count; power-- > 0;) {
    const double coefficient = radius[0][power] + x[0] * radius[1][power] +
                               x[1] * radius[2][power] + x[2] * radius[3][power] +
                               x[3] * radius[4][power];
    result_mm = result_mm * angle.si() + coefficient;
  }
  return millimeters(result_mm).si();
}

Angle turnAngle(const HalfDiameters& half)
{
  const Four x = inMillimetersOf(half);
  return degrees(turn_deg[0] + x[0] * turn_deg[1] + x[1] * turn_deg[2] + x[2] * turn_deg[3] +
                 x[3] * turn_deg[4]);
}

HalfDiameters sampleHalfDiameters(std::uint64_t seed)
{
  Shuffled shuffled(seed);
  const Four deviates = normalDeviates(shuffled);
  const std::array<Four, count> root = rootOfCorrelation();
  Four half_mm = mean_mm;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k <= i; ++k) half_mm[i] += deviation_mm[i] * root[i][k] * deviates[k];
  return fromMillimeters(half_mm);
}

Spread spreadOfA() { return spreadOf(sums[0]); }
Spread spreadOfB() { return spreadOf(sums[1]); }

Spread expectedB(Length a)
{
  // mean + S_BA / S_AA (a - mean of A), variance S_BB - S_BA^2 / S_AA, with S = C covariance C^T
  const double aa = sumOf(sums[0], covarianceWith(sums[0]));
  const double bb = sumOf(sums[1], covarianceWith(sums[1]));
  const double ab = sumOf(sums[0], covarianceWith(sums[1]));
  const double mean =
      sumOf(sums[1], mean_mm) + ab / aa * (inMillimeters(a) - sumOf(sums[0], mean_mm));
  const double standardDeviation = std::sqrt(bb - ab * ab / aa);
  const double reach = deviationsAllowed * standardDeviation;
  return {millimeters(mean), millimeters(standardDeviation), millimeters(mean - reach),
          millimeters(mean + reach)};
}

Spread limitsOfH()
{
  return {millimeters(3.26), millimeters(0.24), millimeters(2.3), millimeters(4.8)};
}

bool areOutOfProportion(Length a, Length b, Length h, Length errorOfB, Length errorOfH)
{
  // B of an A: its conditional standard deviations. H: its own beyond the limits of patients.
  constexpr double proportionSds = 3.5, heightSds = 3.0;
  const Spread given = expectedB(a);
  const double sd = std::sqrt(given.standardDeviation.si() * given.standardDeviation.si() +
                              errorOfB.si() * errorOfB.si());
  if (std::fabs((b - given.mean).si()) > proportionSds * sd) return true;
  const Spread limits = limitsOfH();
  return h < limits.low - heightSds * errorOfH || h > limits.high + heightSds * errorOfH;
}

}  // namespace perilymph::anatomy

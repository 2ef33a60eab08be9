// SPDX-License-Identifier: BSD-3-Clause
#include "sources/CohenSpiral.h"

#include <array>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

// Cohen 1996 as restated by Clark, Warren and Abbott 2011, J Med Devices 5:014501 (confidence
// medium: constants taken from public code that cites them).
constexpr double planA = 3.762e-3;  // [m]
constexpr double planB = 0.001317;  // [1/deg]
constexpr double planC = 7.967e-3;  // [m]
constexpr double planD = 0.1287;
constexpr double planStart_deg = 5.0;
constexpr double planBranch_deg = 100.0;
// The two branches meet with a kink, which a fifth-degree blend over this half-width replaces
// (ours; confidence medium).
constexpr double planBlend_deg = 15.0;

/// A polynomial of fifth degree that matches value, first and second derivative at both ends of [0,
/// 1].
double blend5(double x, const double from[3], const double to[3])
{
  const double a0 = from[0], a1 = from[1], a2 = 0.5 * from[2];
  const double c0 = to[0] - a0 - a1 - a2;
  const double c1 = to[1] - a1 - 2.0 * a2;
  const double c2 = to[2] - 2.0 * a2;
  const double a3 = 10.0 * c0 - 4.0 * c1 + 0.5 * c2;
  const double a4 = -15.0 * c0 + 7.0 * c1 - c2;
  const double a5 = 6.0 * c0 - 3.0 * c1 + 0.5 * c2;
  return a0 + x * (a1 + x * (a2 + x * (a3 + x * (a4 + x * a5))));
}

/// Plan radius and its first and second derivatives [m, m/deg, m/deg^2] on the logarithmic branch
/// at the base ...
std::array<double, 3> basalBranch(double spiral_deg)
{
  const double x = spiral_deg - planStart_deg;
  return {planC * (1.0 - planD * logarithm(x)), -planC * planD / x, planC * planD / (x * x)};
}

/// ... and on the exponential one toward the apex.
std::array<double, 3> apicalBranch(double spiral_deg)
{
  const double slope = -planB * (0.0004 * spiral_deg + 0.98);
  const double planRadius =
      planA * exponential(-planB * (0.0002 * spiral_deg * spiral_deg + 0.98 * spiral_deg));
  return {planRadius, planRadius * slope, planRadius * (slope * slope - planB * 0.0004)};
}

}  // namespace

double cohenRadius(double spiral_deg)
{
  const double low = planBranch_deg - planBlend_deg;
  const double high = planBranch_deg + planBlend_deg;
  if (spiral_deg <= low) return basalBranch(spiral_deg)[0];
  if (spiral_deg >= high) return apicalBranch(spiral_deg)[0];
  const double width = high - low;
  const auto a = basalBranch(low);
  const auto b = apicalBranch(high);
  const double from[3] = {a[0], a[1] * width, a[2] * width * width};
  const double to[3] = {b[0], b[1] * width, b[2] * width * width};
  return blend5((spiral_deg - low) / width, from, to);
}

}  // namespace perilymph::anatomy

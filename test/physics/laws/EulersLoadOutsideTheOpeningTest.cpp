// SPDX-License-Identifier: BSD-3-Clause

// Euler's buckling load of a straight array whose tip is blocked: clamped in the tweezers,
// laterally supported by the rim of the opening, with the rotation there limited by the part
// inside.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "../mechanics/TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// The smallest k = sqrt(P / EI) at which a bent column is in equilibrium.
///
///     outside  y = A sin kx + B cos kx - kA x - B,      0 <= x <= L, clamped at 0
///     inside   y = D (1 - cos ks) + (t / k) sin ks,     0 <= s <= a, its end at D = t tan(ka) / k
///
/// y is 0 at the rim; slope t and curvature are the same on both sides of it.
///
/// @param outside  L, from the tweezers to the rim [m].
/// @param inside   a, from the rim to the tip, which slides freely on a flat wall [m].
double minLoadNumber(double outside, double inside)
{
  const auto unbalanced = [=](double k) {
    const double q = k * outside;
    const double t = std::tan(k * inside);
    // rows: y at the rim; curvature outside + slope tan(ka) k
    const double a11 = std::sin(q) - q, a12 = std::cos(q) - 1.0;
    const double a21 = std::sin(q) + t * (std::cos(q) - 1.0);
    const double a22 = std::cos(q) - t * std::sin(q);
    return a11 * a22 - a12 * a21;
  };
  // below the load of a column clamped at both ends and that of the inner part alone
  const double maximum = std::min(2.0 * pi / outside, 0.5 * pi / inside);
  constexpr int steps = 2000;
  double low = 0.01 * maximum, high = low;
  for (int i = 1; i < steps; ++i) {
    high = maximum * (0.01 + 0.99 * i / steps);
    if (unbalanced(low) * unbalanced(high) <= 0.0) break;
    low = high;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (unbalanced(low) * unbalanced(middle) <= 0.0 ? high : low) = middle;
  }
  return low;
}

/// A rod in a hole of its own diameter, its tip on a flat wall `inside` behind the rim.
struct StoppedColumn {
  explicit StoppedColumn(double inside, std::optional<Length> freeLength = std::nullopt)
      : rod(std::make_shared<anatomy::FlatWall>(inside + spec(inside).radius),
            spec(inside, freeLength))
  {
    // a slight misalignment, as every real column has
    rod.drive().handAxis_W =
        Eigen::AngleAxisd(0.0005, Eigen::Vector3d::UnitX()) * rod.drive().handAxis_W;
  }
  static RodSpec spec(double inside, std::optional<Length> freeLength = std::nullopt)
  {
    RodSpec spec;
    spec.freeLength = freeLength;
    spec.startInside = inside - 5e-6;
    spec.wallStiffness = 1e4;
    spec.opening = mechanics::cochleostomy(meters(2.0 * (spec.radius + 0.5e-6)));
    return spec;
  }
  /// The theoretical load [N]. The tweezers hold the whole first link, so it bends from its middle
  /// on.
  static double eulersLoad(double inside)
  {
    const RodSpec rod = spec(inside);
    const double held = 0.5 * rod.length / (rod.nodes - 1);
    const double k = minLoadNumber(rod.length - inside - held, inside);
    return rod.bending * k * k;
  }
  TestRod rod;
};

constexpr double insides[] = {0.5e-3, 2e-3, 5e-3};

TEST(ColumnThroughTheOpening, HasTheLoadNumbersOfTheTextbook)
{
  // clamped and pinned: tan q = q; clamped and free: q = pi / 2
  EXPECT_NEAR(minLoadNumber(1.0, 1e-6), 4.493409, 1e-4);
  EXPECT_NEAR(minLoadNumber(1e-6, 1.0), 0.5 * pi, 1e-3);
}

TEST(ColumnThroughTheOpening, GivesWayAtEulersLoad)
{
  for (const double inside : insides) {
    StoppedColumn column(inside);
    column.rod.move({0.0, 0.0, -0.07e-3}, 0.2e-3, 1.0);
    const double expected = StoppedColumn::eulersLoad(inside);
    EXPECT_NEAR(column.rod.readings().axialForce, expected,
                test::tolerance(0.02, "it has bent to give way") * expected)
        << inside;
    double aside = 0.0;
    for (const Eigen::Vector3d& node : column.rod.state().position_W)
      aside = std::max(aside, std::fabs(node.y()));
    EXPECT_GT(aside, 0.3e-3) << inside;  // thirty times the misalignment: it has buckled
  }
}

TEST(ColumnThroughTheOpening, GivesWayAtTheLoadOfItsFreeLengthWhereForcepsHoldIt)
{
  constexpr double inside = 2e-3, free = 5e-3;
  StoppedColumn column(inside, meters(free));
  column.rod.move({0.0, 0.0, -0.15e-3}, 0.2e-3, 1.0);
  const double bending = StoppedColumn::spec(inside).bending;
  const auto loadOf = [&](double length) {
    const double k = minLoadNumber(length, inside);
    return bending * k * k;
  };
  // the hold sets in over 0.5 mm, and a beam on an elastic foundation yields along two of its
  // characteristic lengths, (4 EI / 1e6 N/m^2)^(1/4) = 1.4 mm
  EXPECT_LT(column.rod.readings().axialForce, loadOf(free));
  EXPECT_GT(column.rod.readings().axialForce, 2.0 * StoppedColumn::eulersLoad(inside));
  EXPECT_GT(column.rod.readings().axialForce, loadOf(free + 0.5e-3 + 2.0 * 1.4e-3));
}

}  // namespace
}  // namespace perilymph

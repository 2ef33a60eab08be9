// SPDX-License-Identifier: BSD-3-Clause

// An array sliding along a bend: the capstan equation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

constexpr double bend = 6e-3;               // [m] of the duct's axis
constexpr double lead = 2e-3;               // [m]
constexpr double end = 200.0 * pi / 180.0;  // [rad]

/// A circular duct that ends in a frictionless wall across it.
class ClosedDuct final : public anatomy::Lumen {
public:
  ClosedDuct(double radius, double endAngle) : duct_(radius, bend, lead), end_(endAngle) {}
  anatomy::Entry entry() const noexcept override { return duct_.entry(); }
  anatomy::LumenTrack startTrack() const noexcept override { return duct_.startTrack(); }
  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<anatomy::LumenTrack> tracks,
                   std::span<anatomy::WallPoint> walls) const noexcept override
  {
    duct_.nearestWall(points_W, reach, tracks, walls);
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      const double toEnd = (end_ - tracks[i].angle) * bend;
      if (tracks[i].angle <= 0.0 || toEnd > reach[i]) continue;
      walls[i] = {};
      walls[i].isNear = true;
      walls[i].distance = toEnd;
      walls[i].normal_W = {std::sin(tracks[i].angle), 0.0, std::cos(tracks[i].angle)};
    }
  }
  void addTo(Hash&) const noexcept override {}

private:
  anatomy::CircularDuct duct_;
  double end_;
};

/// A rod with negligible bending stiffness, pushed around the bend against its blocked tip; returns
/// the ratio of compression at two angles of wrap.
double compressionRatio(double friction, double fromAngle, double toAngle)
{
  RodSpec spec;
  // as long as the duct: no free part outside that could buckle
  const double toTheEnd = lead + bend * end - spec.radius;
  spec.length = toTheEnd + 0.5e-3;
  spec.bending = 2e-9;
  spec.startInside = 1e-3;
  spec.wallStiffness = 2e4;
  spec.nodes = 161;
  TestRod rod(std::make_shared<ClosedDuct>(spec.radius + 0.03e-3, end), spec);
  for (double& stretching : rod.changeable().stretching) stretching = 20.0;
  // inserted without friction until the tip is blocked, then pushed with friction until all nodes
  // slide
  rod.move({0.0, 0.0, -(toTheEnd - spec.startInside - 0.3e-3)}, 20e-3);
  rod.changeable().parts.friction = {friction, friction, friction, millimetersPerSecond(0.1)};
  for (int i = 0; i < 200 && rod.readings().axialForce < 0.06; ++i)
    rod.move({0.0, 0.0, -0.01e-3}, 2e-3);
  EXPECT_GE(rod.readings().axialForce, 0.06);

  const auto compressionAt = [&](double angle) {
    const auto& track = rod.state().track;
    for (std::size_t i = 1; i + 1 < track.size(); ++i)
      if (track[i].angle <= angle && track[i + 1].angle > angle) return -rod.tension(i);
    return 0.0;
  };
  return compressionAt(fromAngle) / compressionAt(toAngle);
}

TEST(LimpArrayInCircularDuct, PushForceGrowsByTheCapstanFactor)
{
  for (const double friction : {0.05, 0.15, 0.3}) {
    const double from = 40.0 * pi / 180.0;
    const double to = 160.0 * pi / 180.0;
    const double expected = std::exp(friction * (to - from));  // F = F0 exp(mu phi)
    EXPECT_NEAR(compressionRatio(friction, from, to), expected,
                test::tolerance(0.01, "residual bending stiffness") * expected)
        << "friction " << friction;
  }
}

/// Push force of a stiff array at every half millimeter on its way around the bend [N].
std::vector<double> pushForces(const mechanics::SolverParameters& solver)
{
  RodSpec spec;
  spec.startInside = 1e-3;
  spec.friction = 0.15;
  TestRod rod(std::make_shared<anatomy::CircularDuct>(spec.radius + 0.2e-3, bend, lead), spec);
  rod.changeable().parts.solver = solver;
  std::vector<double> forces;
  for (int k = 0; k < 20; ++k) {
    rod.move({0.0, 0.0, -0.5e-3}, 5e-3);
    forces.push_back(rod.readings().axialForce);
  }
  return forces;
}

/// The largest difference between two of them [N].
double apart(const std::vector<double>& one, const std::vector<double>& other)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    largest = std::max(largest, std::fabs(one[k] - other[k]));
  return largest;
}

TEST(StiffArrayInCircularDuct, IsPushedAsWithAFinerSolver)
{
  const mechanics::SolverParameters usual;
  mechanics::SolverParameters fine = usual, coarse = usual;
  fine.forceTolerance /= 100.0;
  fine.motionTolerance /= 10.0;
  fine.motionFraction /= 100.0;
  fine.maxLag /= 100.0;
  fine.maxPasses = 10;
  fine.maxEvaluations = fine.maxFactorizations = 1000;
  coarse.forceTolerance *= 1000.0;
  coarse.motionFraction *= 1000.0;
  const std::vector<double> forces = pushForces(fine);
  const double tolerance = test::tolerance(usual.maxLag, "friction by an earlier normal force");
  EXPECT_GT(forces.back(), 5e-3);
  EXPECT_LE(apart(pushForces(usual), forces), tolerance);
  EXPECT_GT(apart(pushForces(coarse), forces), tolerance) << "the tolerances are in use";
}

}  // namespace
}  // namespace perilymph

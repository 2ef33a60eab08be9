// SPDX-License-Identifier: BSD-3-Clause

// The rod without contact, compared with the theory of thin elastic rods.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "SideWall.h"
#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

// The rod's dampers relax within a few milliseconds; this is long after.
constexpr double settling = 0.5;  // [s]

/// Force on a cantilever of length L whose tip is deflected by `deflection`, with constant
/// direction (Euler's elastica, integrated by shooting with fourth-order Runge-Kutta).
double elasticaForce(double EI, double L, double deflection)
{
  // theta'' = -(F / EI) cos(theta), theta(0) = 0, theta'(L) = 0; y' = sin(theta)
  const auto shoot = [&](double F, double slope, double& tipSlope) {
    constexpr int steps = 2000;
    const double h = L / steps;
    double s[3] = {0.0, slope, 0.0};
    const auto rate = [&](const double in[3], double out[3]) {
      out[0] = in[1];
      out[1] = -F / EI * std::cos(in[0]);
      out[2] = std::sin(in[0]);
    };
    for (int i = 0; i < steps; ++i) {
      double a[3], b[3], c[3], d[3], t[3];
      rate(s, a);
      for (int k = 0; k < 3; ++k) t[k] = s[k] + 0.5 * h * a[k];
      rate(t, b);
      for (int k = 0; k < 3; ++k) t[k] = s[k] + 0.5 * h * b[k];
      rate(t, c);
      for (int k = 0; k < 3; ++k) t[k] = s[k] + h * c[k];
      rate(t, d);
      for (int k = 0; k < 3; ++k) s[k] += h / 6.0 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    tipSlope = s[1];
    return s[2];
  };
  const auto tipFor = [&](double F) {
    double low = 0.0, high = 2.0 * F * L / EI;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      double tipSlope = 0.0;
      shoot(F, middle, tipSlope);
      (tipSlope < 0.0 ? low : high) = middle;
    }
    double unused = 0.0;
    return shoot(F, low, unused);
  };
  double low = 0.0, high = 40.0 * EI / (L * L);
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (tipFor(middle) < deflection ? low : high) = middle;
  }
  return low;
}

/// Presses the tip of a cantilever sideways onto a wall; returns force on the tip and its
/// deflection.
std::pair<double, double> pressSideways(const RodSpec& spec, double motion)
{
  constexpr double gap = 1e-3;
  RodSpec inside = spec;
  inside.startInside = 0.5 * spec.length;  // where there is wall
  TestRod rod(std::make_shared<test::SideWall>(gap), inside);
  rod.move({0.0, -(gap - spec.radius + motion), 0.0}, 2e-3, settling);
  const double deflection = rod.state().position_W.back().y() - rod.state().base_W.y();
  return {rod.state().normalForce.back(), deflection};
}

TEST(Cantilever, SmallDeflectionFollowsEulerBernoulli)
{
  RodSpec spec;
  spec.bending = 1e-4;  // so stiff that the solver's tolerance of 2 uN is negligible
  const auto [force, deflection] = pressSideways(spec, 0.2e-3);
  // the tweezers hold the whole first link, so it bends from that link's middle on
  const double bent = spec.length - 0.5 * spec.length / (spec.nodes - 1);
  const double expected = 3.0 * spec.bending * deflection / std::pow(bent, 3);
  EXPECT_NEAR(force, expected, test::tolerance(0.002, "chain of links") * expected);
}

TEST(Cantilever, LargeDeflectionFollowsTheElastica)
{
  RodSpec spec;
  const auto [force, deflection] = pressSideways(spec, 9e-3);
  const double expected = elasticaForce(spec.bending, spec.length, deflection);
  EXPECT_GT(deflection, 0.35 * spec.length);  // large indeed
  EXPECT_NEAR(force, expected, test::tolerance(0.02, "chain of links") * expected);
}

TEST(Cantilever, FinerChainsComeCloserToEulerBernoulli)
{
  double lastError = 1.0;
  for (const int nodes : {26, 51, 101, 201}) {
    RodSpec spec;
    spec.bending = 1e-4;
    spec.nodes = nodes;
    const auto [force, deflection] = pressSideways(spec, 0.2e-3);
    const double expected = 3.0 * spec.bending * deflection / std::pow(spec.length, 3);
    const double error = std::fabs(force / expected - 1.0);
    EXPECT_LT(error, 0.7 * lastError) << nodes << " nodes";
    lastError = error;
  }
}

TEST(FreeRod, TakesItsRestCurvature)
{
  RodSpec spec;
  spec.restCurvature = 1.0 / 8e-3;
  TestRod rod(std::make_shared<anatomy::FlatWall>(1.0), spec);
  for (int i = 0; i < 4000; ++i) rod.tick();
  // all nodes except the clamped first two lie on a circle of that radius
  const auto& x = rod.state().position_W;
  const Eigen::Vector3d axis = rod.model().startAxis_W;
  const Eigen::Vector3d curl = rod.model().startCurl_W;
  const Eigen::Vector3d start = 0.5 * (x[0] + x[1]);
  const double turned = spec.restCurvature * (spec.length - rod.model().spacing);
  // a circle from the middle of the first link to the middle of the last, then half a link
  const Eigen::Vector3d expected =
      start + 8e-3 * (std::sin(turned) * axis + (1.0 - std::cos(turned)) * curl) +
      0.5 * rod.model().spacing * (std::cos(turned) * axis + std::sin(turned) * curl);
  EXPECT_LT((x.back() - expected).norm(), test::tolerance(0.1e-3, "chain of links"));
}

TEST(Column, BucklesAtEulersLoad)
{
  // Clamped at the tweezers, its tip free to slide on a frictionless wall: pi^2 EI / (4 L^2).
  RodSpec spec;
  spec.wallStiffness = 1e4;
  TestRod rod(std::make_shared<anatomy::FlatWall>(0.02e-3 + spec.radius), spec);
  // a slight misalignment, as every real column has
  rod.drive().handAxis_W =
      Eigen::AngleAxisd(0.003, Eigen::Vector3d::UnitX()) * rod.drive().handAxis_W;
  rod.move({0.0, 0.0, -0.25e-3}, 0.2e-3, settling);
  const double critical = pi * pi * spec.bending / (4.0 * spec.length * spec.length);
  const Eigen::Vector3d tip = rod.state().position_W.back();
  EXPECT_GT(std::fabs(tip.y()), 0.05 * spec.length);  // it has buckled
  EXPECT_NEAR(rod.readings().axialForce, critical,
              test::tolerance(0.05, "post-buckling") * critical);
}

TEST(Column, CarriesLessThanEulersLoadBeforeItBuckles)
{
  RodSpec spec;
  TestRod rod(std::make_shared<anatomy::FlatWall>(0.02e-3 + spec.radius), spec);
  const double critical = pi * pi * spec.bending / (4.0 * spec.length * spec.length);
  rod.drive().handAxis_W =
      Eigen::AngleAxisd(0.003, Eigen::Vector3d::UnitX()) * rod.drive().handAxis_W;
  for (int i = 0; i < 200; ++i) {
    rod.move({0.0, 0.0, -0.001e-3}, 0.2e-3);
    ASSERT_LT(rod.readings().axialForce, 1.1 * critical);
  }
}

}  // namespace
}  // namespace perilymph

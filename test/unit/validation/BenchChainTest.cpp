// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/BenchChain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "bench/CurveLikelihood.h"
#include "bench/RodInChannel.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"

namespace perilymph::validation {
namespace {

using testing::HasSubstr;

TEST(RodInChannel, WithoutFrictionTakesTheWorkOfBending)
{
  // dE/dz of E = integral of EI(z - s) k(s)^2 / 2 over the inserted length, here by Simpson's rule
  const SpiralChannel channel;
  const ChannelForce force(channel, 0.0, 15e-3);
  for (const double growth : {0.0, 3.0, 30.0}) {
    const double depth = 12e-3;
    const int steps = 2400;
    double integral = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const double k = channel.curvatureAt(depth * i / steps);
      integral += k * k * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
    }
    integral *= depth / steps / 3.0;
    const double end = channel.curvatureAt(depth);
    const double expected = 0.5 * end * end + 0.5 * growth / 15e-3 * integral;
    EXPECT_NEAR(force.at(depth).force(growth, 3.0), expected, 1e-3 * expected) << growth;
  }
}

TEST(RodInChannel, InACircleFollowsTheCapstanLaw)
{
  // EI k^2 ((1 + mu cot(a) / 2) e^(mu phi) - 1/2); the curvature sets in over 0.1 mm
  SpiralChannel circle;
  circle.radiusAt10 = 2.5e-3;
  circle.tightening = 0.0;
  circle.start = 4.0e-3;
  circle.onset = 0.1e-3;
  for (const double friction : {0.05, 0.16, 0.4}) {
    const ChannelForce force(circle, friction, 14e-3);
    for (const double depth : {8e-3, 11e-3, 14e-3}) {
      const double k = 1.0 / 2.5e-3;
      const double expected =
          k * k * ((1.0 + 0.5 * friction * 3.0) * std::exp(friction * k * (depth - 4.0e-3)) - 0.5);
      EXPECT_NEAR(force.at(depth).force(0.0, 3.0), expected, 3e-3 * expected) << friction;
    }
  }
}

// Three points of one curve, worked out with NumPy (exp, outer products, slogdet, solve):
//   z = [8, 10, 13]; F = [3, 7.5, 15]; s = sqrt((1.5 / F)^2 + 0.15^2)
//   C = 0.15^2 + outer(s, s) * exp(-abs(z_i - z_k) / 3)
//   y = log(F) - [ln 2.5, ln 8, ln 14] (F in mN)
//   -0.5 * (y C^-1 y + slogdet(C) + 3 log(2 pi))
TEST(CurveLikelihood, IsTheNormalDensityOfTheStatedErrors)
{
  const std::vector<double> depths = {8e-3, 10e-3, 13e-3};
  const std::vector<double> forces = {3.0e-3, 7.5e-3, 15.0e-3};
  const Eigen::MatrixXd covariance = curveCovariance(depths, forces);
  EXPECT_NEAR(covariance(0, 0), 0.295, 1e-12);
  EXPECT_NEAR(covariance(0, 1), 0.089502901120, 1e-9);
  EXPECT_NEAR(covariance(1, 2), 0.039080102354, 1e-9);
  const CurveLikelihood likelihood(depths, forces);
  const Eigen::Vector3d model(std::log(2.5e-3), std::log(8e-3), std::log(14e-3));
  const LevelLikelihood level = likelihood.of(model);
  EXPECT_NEAR(level.at(0.0), 0.611716475876, 1e-9);
  EXPECT_NEAR(level.at(0.2), 0.344537596066, 1e-9);  // the same with the model's ln F higher by 0.2
  EXPECT_NEAR(level.integrated(), 0.051600647828, 1e-9);
  const Continuation next = continuationOf({8e-3, 10e-3}, {3.0e-3, 7.5e-3}, 13e-3, 15e-3);
  EXPECT_NEAR(next.weights(0), -0.004362235510, 1e-9);
  EXPECT_NEAR(next.weights(1), 0.464359236326, 1e-9);
  EXPECT_NEAR(next.deviation, 0.192427859150, 1e-9);
}

/// Curves of a rod as a chain of rigid links of 0.1 mm in a circle, pushed at its end: each joint holds
/// the moment of its angle, the wall carries what the compression presses outward, and friction is
/// subtracted link by link. Not the closed form of the fit.
double chainForce(double depth_mm, double friction, double stiffness, double radius_mm,
                  double start_mm)
{
  const double link = 0.1e-3, turn = 0.1 / radius_mm;
  const int links = static_cast<int>(std::lround((depth_mm - start_mm) / 0.1));
  const double moment = stiffness * turn / link;
  double compression = moment * turn / link * (1.0 + 1.5 * friction);
  for (int i = 0; i < links; ++i) {
    // equal and opposite moments at both ends of a link: the wall feels twice the sine of half a turn
    const double normal = 2.0 * compression * std::sin(0.5 * turn);
    compression += friction * normal;
  }
  return compression - 0.5 * moment * turn / link;
}

BenchSpecimen chainSpecimen(const std::vector<std::pair<BenchMedium, double>>& media)
{
  BenchSpecimen specimen;
  specimen.name = "chain";
  for (const auto& [medium, friction] : media) {
    BenchCurve curve;
    curve.medium = medium;
    for (double depth_mm = 8.0; depth_mm < 14.1; depth_mm += 0.5) {
      curve.depths.push_back(1e-3 * depth_mm);
      curve.forces.push_back(chainForce(depth_mm, friction, 1.5e-7, 2.7, 4.2));
    }
    specimen.curves.push_back(curve);
  }
  return specimen;
}

TEST(BenchChain, FindsTheFrictionOfCurvesMadeOtherwise)
{
  const std::vector<std::pair<BenchMedium, double>> media = {
      {BenchMedium::soap, 0.05}, {BenchMedium::saline, 0.11}, {BenchMedium::tissue, 0.30}};
  const BenchResult result = inferFriction({chainSpecimen(media)});
  ASSERT_EQ(result.media.size(), 3u);
  for (std::size_t i = 0; i < media.size(); ++i) {
    EXPECT_LT(result.media[i].friction.low, media[i].second);
    EXPECT_GT(result.media[i].friction.high, media[i].second);
  }
  EXPECT_GT(result.media[2].friction.low, 0.0605);  // told from soap
  for (const PredictedForce& each : result.predicted) EXPECT_TRUE(each.isInside()) << each.depth;
  EXPECT_EQ(result.predicted.size(), 6u);
}

/// The cells of a table's row in the guide's page, by its first cell.
std::vector<std::string> rowOfPage(const std::string& first)
{
  std::ifstream page(resource("resources/guide/friction.md"));
  std::vector<std::string> cells;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| " + first + " |")) continue;
    std::istringstream rest(line.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) {
      std::erase(cell, '*');
      cells.push_back(cell.substr(1, cell.size() - 2));
    }
    break;
  }
  return cells;
}

TEST(BenchChain, GivesThePagesTableForNumber11)
{
  auto specimens = loadBench(resource("resources/bench/slim-straight"));
  ASSERT_TRUE(specimens) << specimens.error().message;
  ASSERT_EQ(specimens->size(), 6u);
  specimens->resize(1);
  const BenchResult result = inferFriction(*specimens);
  const std::vector<std::string> row = rowOfPage("11, good");
  ASSERT_EQ(row.size(), 7u);
  for (const MediumFriction& each : result.media) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f (%.3f to %.3f)", each.friction.median, each.friction.low,
                  each.friction.high);
    EXPECT_EQ(row[1 + static_cast<std::size_t>(each.medium)], text);
  }
  char score[16];
  std::snprintf(score, sizeof score, "%.2f", result.scores.front().capstan);
  EXPECT_EQ(rowOfPage("friction by the capstan law").at(1), score);
  std::snprintf(score, sizeof score, "%.2f", result.scores.front().constantRatio);
  EXPECT_EQ(rowOfPage("constant ratio").at(1), score);
}

TEST(BenchCurves, AreRefusedWithTheLineOfTheError)
{
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::string& from, const std::string& to) {
    test::copyChanged(resource("resources/bench/slim-straight/cochlea-11.toml"),
                      folder / "cochlea-11.toml", {{from, to}});
    const auto loaded = loadBench(folder.path());
    return loaded ? "accepted" : loaded.error().message;
  };
  EXPECT_EQ(refused("good", "good"), "accepted");
  EXPECT_THAT(refused("[saline]", "[brine]"), HasSubstr("[saline]"));
  EXPECT_THAT(refused("8.5", "8.52"), HasSubstr("multiple of 0.05 mm"));
  EXPECT_THAT(refused("8.5", "7.5"), HasSubstr("does not increase"));
  EXPECT_THAT(refused("6.6, ", ""), HasSubstr("13 values"));
  EXPECT_THAT(refused("[soap]", "[soup]"), HasSubstr("soup"));
  test::copyChanged(resource("resources/bench/slim-straight/cochlea-7.toml"),
                    folder / "cochlea-11.toml", {});
  const auto withoutSoap = loadBench(folder.path());
  ASSERT_FALSE(withoutSoap);
  EXPECT_THAT(withoutSoap.error().message, HasSubstr("0 specimens with a curve in soap"));
}

}  // namespace
}  // namespace perilymph::validation

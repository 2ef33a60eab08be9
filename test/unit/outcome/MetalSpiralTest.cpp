// SPDX-License-Identifier: BSD-3-Clause

// Metal in Clark's cochlea, in any pose: a place of the cochlea near it is among those that are proposed.

#include "MetalSpiral.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <stop_token>
#include <vector>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {
namespace {

using Eigen::Vector3d;

/// Clark's cochlea, whose spiral and sections are not those of the mean anatomy.
const anatomy::ScalaTympani& clark()
{
  static const auto scala = [] {
    anatomy::Cochlea cochlea;
    cochlea.source = anatomy::AnatomySource::clark;
    return *anatomy::buildAnatomy(cochlea, "Clark");
  }();
  return *scala;
}

struct Implanted {
  std::vector<Vector3d> metal_P;
  Vector3d center_P, axis_P, window_P;
  anatomy::Side side = anatomy::Side::right;
};

/// An array up to an angle, with its lead and metal of no array, in a pose of a seed.
Implanted implanted(std::uint64_t seed, double depth_deg)
{
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> uniform(-15.0, 15.0);
  const Eigen::Matrix3d turned =
      Eigen::Quaterniond(normal(engine), normal(engine), normal(engine), normal(engine))
          .normalized()
          .toRotationMatrix();
  const Vector3d shift(10.0, -40.0, 5.0);
  Implanted made;
  made.side = seed % 2 == 0 ? anatomy::Side::right : anatomy::Side::left;
  Eigen::Matrix3d axes = turned;
  if (made.side == anatomy::Side::left) axes.col(1) *= -1.0;
  const auto toP = [&](const Vector3d& at_W) { return Vector3d(shift + 1e3 * (axes * at_W)); };
  const auto add = [&](const Vector3d& at_W) {
    made.metal_P.push_back(toP(at_W) +
                           0.12 * Vector3d(normal(engine), normal(engine), normal(engine)));
  };
  for (double angle = 0.0; angle < depth_deg * pi / 180.0; angle += 0.035)
    add(clark().center_W(angle) +
        2e-4 * Vector3d(std::cos(angle), std::sin(angle), 0.0));  // toward the outer wall
  const anatomy::Entry entry = clark().entry();
  for (double back = 0.0; back < 7e-3; back += 3e-4) add(entry.origin_W + back * entry.out_W);
  for (int i = 0; i < 25; ++i)
    add(shift + Vector3d(uniform(engine), uniform(engine), uniform(engine)));
  made.window_P = toP(clark().wall_W(0.0, 0.0));
  made.center_P = toP(Vector3d(0.0, 0.0, clark().wall_W(0.0, 0.0).z()));
  made.axis_P = axes.col(2);
  return made;
}

TEST(MetalSpiral, OfAPublishedPathIsFoundInBothEarsAndInAnyPose)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Implanted truth = implanted(seed, 250.0 + 50.0 * static_cast<double>(seed));
    const auto starts = cochleaeAroundMetal(truth.metal_P, std::nullopt, {});
    const bool isAmong =
        std::any_of(starts.begin(), starts.end(), [&](const ct::CochleaStart& start) {
          const Vector3d axis = (start.apex_P - start.center_P).normalized();
          const Vector3d off = start.center_P - truth.center_P;
          const auto across = [&](const Vector3d& way) {
            return Vector3d(way - truth.axis_P.dot(way) * truth.axis_P).normalized();
          };
          return start.side == truth.side && axis.dot(truth.axis_P) > std::cos(0.35) &&
                 off.norm() < 1.5 &&
                 across(start.roundWindow_P - start.center_P)
                         .dot(across(truth.window_P - truth.center_P)) > std::cos(0.5);
        });
    EXPECT_TRUE(isAmong);
    const auto known = cochleaeAroundMetal(truth.metal_P, truth.side, {});
    EXPECT_TRUE(std::all_of(known.begin(), known.end(), [&](const ct::CochleaStart& start) {
      return start.side == truth.side;
    }));
  }
}

TEST(MetalSpiral, IsNotInStraightMetalNorInNone)
{
  std::vector<Vector3d> rod;
  for (double along = 0.0; along < 30.0; along += 0.2) rod.emplace_back(along, 0.0, 0.1 * along);
  EXPECT_TRUE(cochleaeAroundMetal(rod, std::nullopt, {}).empty());
  EXPECT_TRUE(cochleaeAroundMetal({}, std::nullopt, {}).empty());
}

TEST(MetalSpiral, SearchIsCanceled)
{
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(
      cochleaeAroundMetal(implanted(2, 400.0).metal_P, std::nullopt, stop.get_token()).empty());
}

}  // namespace
}  // namespace perilymph::outcome

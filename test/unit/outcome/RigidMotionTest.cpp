// SPDX-License-Identifier: BSD-3-Clause

// Two CTs of one head in two poses: the motion between them is known.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <stop_token>
#include <vector>

#include "RigidMotion.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::outcome {
namespace {

TEST(Registration, FindsTheMotionOfAHeadBesideMetal)
{
  const test::CtPhantom phantom = test::makeCtPhantom(31, test::highResolutionScan());
  const ct::CtVolume& before = phantom.volume;
  const Eigen::Vector3d center = before.center_P();
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.25, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(2.5, -1.5, 1.0);
  std::mt19937_64 engine(5);
  std::normal_distribution<double> noise(0.0, 100.0);
  std::vector<std::int16_t> voxels;
  const auto& size = before.size();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Eigen::Vector3d here = before.toLps({double(i), double(j), double(k)});
        const Eigen::Vector3d there = rotation.transpose() * (here - center - shift) + center;
        // another scale of gray values, and a rod of metal that only the second CT has
        double value = 0.8 * before.sample(there).value_or(-1000.0) + 150.0 + noise(engine);
        if (std::hypot(there.x() - phantom.inside_P.x(), there.y() - phantom.inside_P.y()) < 0.5)
          value = 12'000.0;
        voxels.push_back(static_cast<std::int16_t>(value));
      }
  const auto after = ct::CtVolume::make(size, before.lpsFromIndex(), std::move(voxels));
  ASSERT_TRUE(after);
  const auto found = registration(before, phantom.inside_P, *after, {});
  ASSERT_TRUE(found) << found.error().message;
  for (const Eigen::Vector3d& off : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 0, 0),
                                     Eigen::Vector3d(0, -5, 0), Eigen::Vector3d(0, 0, 4)}) {
    const Eigen::Vector3d point = phantom.inside_P + off;
    EXPECT_LT((found->apply(point) - (rotation * (point - center) + center + shift)).norm(), 0.1);
  }
  EXPECT_LT(found->residual_mm, 0.3);
  EXPECT_GT(found->correlation, 0.9);
}

TEST(Registration, TellsItsProgressAndIsCanceledInAnyOfItsParts)
{
  const test::CtPhantom phantom = test::makeCtPhantom(31, test::highResolutionScan());
  std::vector<double> told;
  const auto found = registration(phantom.volume, phantom.inside_P, phantom.volume, {},
                                  [&told](double done) { told.push_back(done); });
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_GT(told.size(), 100u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_GT(told.back(), 0.7);
  EXPECT_LT(told.back(), 1.0);
  for (const double until : {0.1, 0.55, 0.75}) {
    std::stop_source source;
    std::size_t after = 0;
    const auto canceled = registration(phantom.volume, phantom.inside_P, phantom.volume,
                                       source.get_token(), [&](double done) {
                                         after += source.stop_requested() ? 1 : 0;
                                         if (done >= until) source.request_stop();
                                       });
    EXPECT_FALSE(canceled) << until;
    EXPECT_LE(after, 1u) << until;
  }
}

TEST(Registration, OfTwoHeadsHasALargeResidualOrLittleCorrelation)
{
  const test::CtPhantom one = test::makeCtPhantom(32, test::highResolutionScan()),
                        other = test::makeCtPhantom(33, test::highResolutionScan());
  const auto found = registration(one.volume, one.inside_P, other.volume, {});
  if (!found) return;  // a refusal is right, too
  EXPECT_TRUE(found->correlation < 0.6 || found->residual_mm > 0.6)
      << found->correlation << " " << found->residual_mm;
}

}  // namespace
}  // namespace perilymph::outcome

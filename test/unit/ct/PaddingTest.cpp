// SPDX-License-Identifier: BSD-3-Clause

// Voxels that were not measured: marked where a file fills corners with a value, and left alone
// where a scanner measured them.

#include "Padding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {
namespace {

constexpr int side = 40;

/// Noisy bone with a hollow, 40 voxels of 0.5 mm along each axis.
CtVolume bone(double noise, std::int16_t lowest = -1024)
{
  std::mt19937_64 random(7);
  std::normal_distribution<double> deviate(0.0, noise);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        // Air along one side, as an ear canal, with an edge blurred over some voxels.
        const double air = std::clamp((12.0 - i) / 6.0, 0.0, 1.0);
        const double value = 1600.0 - 2620.0 * air + deviate(random);
        voxels.push_back(static_cast<std::int16_t>(std::max<double>(lowest, value)));
      }
  Eigen::Matrix4d lps = 0.5 * Eigen::Matrix4d::Identity();
  lps(3, 3) = 1.0;
  return *CtVolume::make({side, side, side}, lps, std::move(voxels));
}

class Padding : public testing::TestWithParam<std::int16_t> {};

TEST_P(Padding, OfAnyValueIsMarkedInACornerAndOnlyThere)
{
  const Eigen::Vector3d point(15.0, 15.0, 10.0), normal(1.0, 1.0, 0.2);
  const CtVolume cut = test::withEmptyCorner(bone(60.0), point, normal, GetParam());
  const auto marked = withPaddingMarked(cut, std::nullopt);
  ASSERT_TRUE(marked);
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double behind =
            (cut.toLps(Eigen::Vector3d(i, j, k)) - point).dot(normal.normalized());
        if (behind > 0.0) {
          EXPECT_EQ(marked->voxel(i, j, k), unmeasured);
        } else if (behind < -1.0) {  // beyond the voxels that touch the corner
          EXPECT_EQ(marked->voxel(i, j, k), cut.voxel(i, j, k));
        }
      }
}
INSTANTIATE_TEST_SUITE_P(Values, Padding,
                         testing::Values<std::int16_t>(0, 40, -1, -1000, -1024, -2000, -3024,
                                                       -32767));

TEST(PaddingSearch, LeavesMeasuredVoxelsAlone)
{
  for (const double noise : {5.0, 60.0, 150.0})
    EXPECT_FALSE(withPaddingMarked(bone(noise), std::nullopt)) << noise;
}

TEST(PaddingSearch, LeavesClippedAirAlone)
{
  // Air of -1020 with noise is clipped at -1000: constant, but no corner.
  for (const double noise : {2.0, 30.0})
    EXPECT_FALSE(withPaddingMarked(bone(noise, -1000), std::nullopt)) << noise;
}

TEST(PaddingSearch, KeepsItsVoxelsOutOfTheQuantiles)
{
  const CtVolume whole = bone(60.0);
  const CtVolume cut =
      test::withEmptyCorner(whole, {10.0, 10.0, 10.0}, {0.0, 0.0, 1.0}, unmeasured);
  EXPECT_NEAR(quantile(cut, 0.02), quantile(whole, 0.02), 20.0);
}

TEST(CtVolume, HasNoValueBesideUnmeasuredVoxels)
{
  const CtVolume cut =
      test::withEmptyCorner(bone(60.0), {10.1, 0.0, 0.0}, {1.0, 0.0, 0.0}, unmeasured);
  EXPECT_TRUE(cut.sample({9.7, 5.0, 5.0}));
  EXPECT_TRUE(cut.sample({10.0, 5.0, 5.0}));  // the last one that was measured
  EXPECT_FALSE(cut.sample({10.2, 5.0, 5.0}));
  EXPECT_FALSE(cut.sample({15.0, 5.0, 5.0}));
}

}  // namespace
}  // namespace perilymph::ct

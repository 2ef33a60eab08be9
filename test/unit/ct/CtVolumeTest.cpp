// SPDX-License-Identifier: BSD-3-Clause

// Voxels and their positions, tested with linear functions, which trilinear interpolation
// reproduces exactly.

#include "perilymph/ct/CtVolume.h"

#include <gtest/gtest.h>

#include <limits>

namespace perilymph::ct {
namespace {

/// An oblique, left-handed grid of 12 x 9 x 7 voxels.
Eigen::Matrix4d oblique()
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.col(0) << 0.24, 0.18, 0.0, 0.0;
  lps.col(1) << 0.3, -0.4, 0.0, 0.0;
  lps.col(2) << 0.0, 0.0, 0.6, 0.0;
  lps.col(3) << 10.0, -20.0, 30.0, 1.0;
  return lps;
}

CtVolume ramp()
{
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 7; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 12; ++i)
        voxels.push_back(static_cast<std::int16_t>(100 * i - 50 * j + 20 * k));
  return *CtVolume::make({12, 9, 7}, oblique(), std::move(voxels));
}

TEST(CtVolume, InterpolatesALinearFunctionExactly)
{
  const CtVolume volume = ramp();
  const Eigen::Vector3d index(4.25, 3.5, 2.75);
  const auto value = volume.sample(volume.toLps(index));
  ASSERT_TRUE(value);
  EXPECT_NEAR(*value, 100.0 * 4.25 - 50.0 * 3.5 + 20.0 * 2.75, 1e-9);
}

TEST(CtVolume, FindsTheIndexOfAPoint)
{
  const CtVolume volume = ramp();
  const Eigen::Vector3d index(1.5, 7.25, 3.0);
  EXPECT_LT((volume.toIndex(volume.toLps(index)) - index).norm(), 1e-12);
}

TEST(CtVolume, HasTheSpacingOfItsColumns)
{
  EXPECT_LT((ramp().spacing_mm() - Eigen::Vector3d(0.3, 0.5, 0.6)).norm(), 1e-12);
}

TEST(CtVolume, HasNoValueOutside)
{
  const CtVolume volume = ramp();
  EXPECT_FALSE(volume.sample(volume.toLps({-0.1, 0.0, 0.0})));
  EXPECT_FALSE(volume.sample(volume.toLps({0.0, 8.1, 0.0})));
}

TEST(CtVolume, HasAValueNextToItsLastVoxel)
{
  const CtVolume volume = ramp();
  const auto value = volume.sample(volume.toLps({10.999, 7.999, 5.999}));
  ASSERT_TRUE(value);
  EXPECT_NEAR(*value, 100.0 * 10.999 - 50.0 * 7.999 + 20.0 * 5.999, 1e-6);
}

TEST(CtVolume, KeepsPlacesAndValuesWhenCropped)
{
  const CtVolume volume = ramp();
  const Eigen::Vector3d center_P = volume.toLps({6.0, 4.0, 3.0});
  const auto crop = volume.crop(center_P, 0.7);
  ASSERT_TRUE(crop);
  EXPECT_LT(crop->size()[0], volume.size()[0]);
  EXPECT_NEAR(*crop->sample(center_P), *volume.sample(center_P), 1e-9);
}

TEST(CtVolume, RefusesToCropAroundAPointOutside)
{
  const CtVolume volume = ramp();
  EXPECT_FALSE(volume.crop(volume.toLps({-5.0, 0.0, 0.0}), 1.0));
}

TEST(CtVolume, RefusesVoxelsThatDoNotMatchTheSize)
{
  const auto volume = CtVolume::make({4, 4, 4}, oblique(), std::vector<std::int16_t>(63));
  ASSERT_FALSE(volume);
  EXPECT_NE(volume.error().message.find("63"), std::string::npos);
}

TEST(CtVolume, RefusesAFlatGrid)
{
  EXPECT_FALSE(CtVolume::make({4, 4, 1}, oblique(), std::vector<std::int16_t>(16)));
}

TEST(CtVolume, RefusesAMatrixWithoutVolume)
{
  Eigen::Matrix4d flat = oblique();
  flat.col(2) = flat.col(1);
  EXPECT_FALSE(CtVolume::make({2, 2, 2}, flat, std::vector<std::int16_t>(8)));
}

TEST(CtVolume, RefusesAMatrixThatIsNotFinite)
{
  Eigen::Matrix4d broken = oblique();
  broken(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(CtVolume::make({2, 2, 2}, broken, std::vector<std::int16_t>(8)));
}

}  // namespace
}  // namespace perilymph::ct

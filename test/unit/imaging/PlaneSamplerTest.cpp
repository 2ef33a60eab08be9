// SPDX-License-Identifier: BSD-3-Clause

// Pictures of planes, against trilinear interpolation at each pixel.

#include "perilymph/imaging/PlaneSampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace perilymph::imaging {
namespace {

using Eigen::Vector3d;

/// An oblique, left-handed grid with unequal spacing whose values are linear in the patient's
/// coordinates, so that interpolation is exact.
std::shared_ptr<const ct::CtVolume> linearVolume(const Vector3d& slope, double offset)
{
  const std::array<int, 3> size{40, 30, 20};
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  const Vector3d x = Vector3d(2, 1, -2) / 3.0, y = Vector3d(1, 2, 2) / 3.0,
                 z = -Vector3d(2, -2, 1) / 3.0;
  lps.block<3, 1>(0, 0) = 0.3 * x;
  lps.block<3, 1>(0, 1) = 0.4 * y;
  lps.block<3, 1>(0, 2) = 0.6 * z;
  lps.block<3, 1>(0, 3) = Vector3d(12, -34, 56);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Vector3d point = (lps * Eigen::Vector4d(i, j, k, 1)).head<3>();
        voxels.push_back(static_cast<std::int16_t>(
            std::lround(offset + slope.dot(point - Vector3d(12, -34, 56)))));
      }
  auto made = ct::CtVolume::make(size, lps, std::move(voxels));
  EXPECT_TRUE(made);
  return std::make_shared<const ct::CtVolume>(*std::move(made));
}

PlanePicture obliquePicture(const ct::CtVolume& volume)
{
  PlanePicture picture;
  picture.plane = {volume.center_P(), Vector3d(0.6, 0.0, 0.8), Vector3d(0.0, 1.0, 0.0)};
  picture.width = 61;
  picture.height = 41;
  picture.pixel_mm = 0.25;
  picture.window = {1000.0, 2000.0};
  return picture;
}

TEST(PlaneSampler, ShowsWhatLiesAtEachPixel)
{
  const auto volume = linearVolume({60.0, -45.0, 30.0}, 1000.0);
  PlaneSampler sampler(volume);
  const PlanePicture picture = obliquePicture(*volume);
  const auto gray = sampler.sample(picture);
  ASSERT_EQ(gray.size(), 61u * 41u);
  int inside = 0, outside = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const Vector3d point = picture.plane.atPicture({0.25 * (column - 30), 0.25 * (row - 20)});
      const auto value = volume->sample(point);
      const int shown = gray[static_cast<std::size_t>(row * picture.width + column)];
      if (!value) {
        outside += 1;
        continue;
      }
      inside += 1;
      const double expected = std::clamp(255.0 / 2000.0 * *value, 0.0, 255.0);
      EXPECT_NEAR(shown, expected, 1.0) << row << ' ' << column;
    }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 100);
}

TEST(PlaneSampler, LeavesPixelsOutsideTheVolumeBlack)
{
  const auto volume = linearVolume({0.0, 0.0, 0.0}, 2000.0);
  PlaneSampler sampler(volume);
  PlanePicture picture = obliquePicture(*volume);
  picture.plane.center_P += Vector3d(0, 100, 0);
  for (const std::uint8_t value : sampler.sample(picture)) EXPECT_EQ(value, 0);
}

TEST(PlaneSampler, ShowsTheMeanAndTheMaximumOfASlab)
{
  // Values rise by 100 per mm along the view: over 2 mm the mean is that of the middle, the maximum
  // 100 above it.
  const auto volume = linearVolume({0.0, 0.0, 0.0}, 1000.0);
  const Vector3d away = obliquePicture(*volume).plane.away_P();
  const auto rising = linearVolume(100.0 * away, 1000.0);
  PlaneSampler sampler(rising);
  PlanePicture picture = obliquePicture(*rising);
  picture.window = {rising->sample(rising->center_P()).value(), 510.0};
  const auto middle = static_cast<std::size_t>(20 * 61 + 30);
  picture.thickness_mm = 2.0;
  EXPECT_NEAR(sampler.sample(picture)[middle], 127.5, 1.5);
  picture.projection = Projection::maximum;
  EXPECT_NEAR(sampler.sample(picture)[middle], 177.5, 1.5);
}

TEST(PlaneSampler, GivesNothingForAnEmptyPicture)
{
  PlaneSampler sampler(linearVolume({0.0, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(sampler.sample({}).empty());
}

TEST(WholeWindow, LeavesOutOnePercentAtEitherEnd)
{
  std::vector<std::int16_t> voxels(10 * 10 * 100);
  for (std::size_t k = 0; k < voxels.size(); ++k) voxels[k] = static_cast<std::int16_t>(k);
  const auto volume =
      ct::CtVolume::make({10, 10, 100}, Eigen::Matrix4d::Identity(), std::move(voxels));
  ASSERT_TRUE(volume);
  const GrayWindow window = wholeWindow(*volume);
  EXPECT_NEAR(window.center, 5000.0, 5.0);
  EXPECT_NEAR(window.width, 9800.0, 10.0);
}

}  // namespace
}  // namespace perilymph::imaging

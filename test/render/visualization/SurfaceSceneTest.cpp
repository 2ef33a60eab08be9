// SPDX-License-Identifier: BSD-3-Clause

// A surface with marked points as a picture.

#include "perilymph/visualization/SurfaceScene.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "perilymph/test/TestPicture.h"

namespace perilymph::test {
namespace {

using Eigen::Vector3d;

/// A square plate of 8 mm in the plane z = 0, seen from above and from below.
anatomy::Surface plate()
{
  constexpr double half = 4e-3;
  return {{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}},
          {{0, 1, 2}, {0, 2, 3}}};
}

class ASurfaceScene : public testing::Test {
protected:
  ASurfaceScene()
  {
    window_->SetOffScreenRendering(1);
    window_->SetSize(200, 200);
    scene_.attachTo(*window_);
    scene_.lookAlong(-Vector3d::UnitZ(), -Vector3d::UnitY());
  }

  vtkNew<vtkRenderWindow> window_;
  visualization::SurfaceScene scene_{plate()};
};

TEST_F(ASurfaceScene, IsWhollyInThePicture)
{
  const DrawnPicture picture = draw(*window_);
  const Pixel ground = picture.at(2, 2);
  EXPECT_GT(difference(picture.at(100, 100), ground), 40);
  for (int k = 0; k < 200; ++k) {
    EXPECT_LT(difference(picture.at(k, 0), ground), 10);
    EXPECT_LT(difference(picture.at(0, k), ground), 10);
  }
}

TEST_F(ASurfaceScene, ShowsMarkedPointsWhereTheyAre)
{
  const DrawnPicture before = draw(*window_);
  scene_.setPoints({Vector3d(2.0, 2.0, 1.0)});  // right and above in the picture
  const DrawnPicture after = draw(*window_);
  double x = 0.0, y = 0.0;
  int count = 0;
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      if (difference(before.at(column, row), after.at(column, row)) > 30) {
        x += column;
        y += row;
        ++count;
      }
  ASSERT_GT(count, 10);
  EXPECT_GT(x / count, 110.0);
  EXPECT_GT(y / count, 110.0);
  EXPECT_NEAR(x / count, y / count, 2.0);
}

TEST_F(ASurfaceScene, ShowsAPathAndHidesItAgain)
{
  const DrawnPicture before = draw(*window_);
  scene_.setPath({Vector3d(-3, 0, 1), Vector3d(0, 0, 1), Vector3d(3, 0, 1)}, 0.3);
  EXPECT_GT(difference(draw(*window_).at(100, 100), before.at(100, 100)), 20);
  scene_.setPath({}, 0.3);
  EXPECT_LT(difference(draw(*window_).at(100, 100), before.at(100, 100)), 3);
}

TEST_F(ASurfaceScene, TurnsAndZooms)
{
  const auto area = [this] {
    const DrawnPicture picture = draw(*window_);
    const Pixel ground = picture.at(2, 2);
    return countPixels(
        picture, [&](const Pixel& pixel, int, int) { return difference(pixel, ground) > 20; });
  };
  const int flat = area();
  scene_.rotate(0.0, 60.0);  // cos 60 deg: half the height
  EXPECT_NEAR(double(area()) / flat, 0.5, 0.05);
  scene_.rotate(0.0, -60.0);
  scene_.zoom(0.5);
  EXPECT_NEAR(double(area()) / flat, 0.25, 0.02);
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// Stereo: in every mode the disparity is that of the geometry.

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <cmath>
#include <limits>

#include "SceneOnScreen.h"

namespace perilymph::visualization {
namespace {

using test::DrawnPicture;
using test::SceneOnScreen;

constexpr double wholePixel = 1.0;  // resolution of the measured shift
constexpr int reach_px = 40;        // range of the search, in both directions
constexpr int patch_px = 24;        // half the size of the patch around the tip

/// The displayed picture: the pictures of both eyes are combined in the front buffer.
DrawnPicture shown(SceneOnScreen& screen)
{
  screen.window->Render();
  DrawnPicture picture{screen.window->GetSize()[0], screen.window->GetSize()[1], {}};
  vtkNew<vtkUnsignedCharArray> pixels;
  screen.window->GetPixelData(0, 0, picture.width - 1, picture.height - 1, 1, pixels);
  picture.rgb.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return picture;
}

/// The picture of one eye in gray, in pixels of the whole picture.
struct EyePicture {
  int width = 0, height = 0;
  std::vector<double> gray;
  double at(int x, int y) const
  {
    return gray[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  }
};

template <class Gray>
EyePicture eye(const DrawnPicture& picture, Gray gray)
{
  EyePicture result{picture.width, picture.height, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) result.gray.push_back(gray(x, y));
  return result;
}

/// Shift of a patch to the right in the left eye's picture relative to the right eye's.
int shift(const EyePicture& left, const EyePicture& right, int x, int y)
{
  int best = 0;
  double minimum = std::numeric_limits<double>::max();
  for (int by = -reach_px; by <= reach_px; ++by) {
    double sum = 0.0;
    for (int dy = -patch_px; dy <= patch_px; ++dy)
      for (int dx = -patch_px; dx <= patch_px; ++dx)
        sum += std::abs(left.at(x + dx, y + dy) - right.at(x + dx - by, y + dy));
    if (sum < minimum) minimum = sum, best = by;
  }
  return best;
}

/// An array seen obliquely, with its tip far from the focal plane.
struct ArrayForTwoEyes : ::testing::Test {
  ArrayForTwoEyes()
  {
    screen.scene.show(now);
    screen.showOnlyArray();
    screen.scene.lookFrom(CameraPreset::overview);
    screen.scene.setMagnification(14);
    const Eigen::Vector3d tip = test::node_mm(now, test::arrayNodes - 1);
    // the tip in the center of the picture without stereo
    const Eigen::Vector2d off = screen.pixel(tip) - Eigen::Vector2d(320.0, 200.0);
    const double pixel_mm = 170.0 / 14.0 / 400.0;
    screen.scene.moveModel(-pixel_mm * off.x(), -pixel_mm * off.y());

    vtkCamera& camera = *screen.scene.renderer().GetActiveCamera();
    const Eigen::Vector3d focus(camera.GetFocalPoint());
    const Eigen::Vector3d back = -Eigen::Vector3d(camera.GetDirectionOfProjection());
    // a parallel projection, sheared by half the angle for each eye
    const double height_mm = (tip - focus).dot(back);
    expected_px = 2.0 * std::tan(0.5 * degrees(eyeAngle_deg).si()) * height_mm / pixel_mm;
  }

  haptics::Snapshot now = test::insertedTo(degrees(200));
  SceneOnScreen screen;
  double expected_px = 0.0;
};

TEST_F(ArrayForTwoEyes, IsFarEnoughFromTheFocalPlaneToMeasure)
{
  EXPECT_GT(std::abs(expected_px), 5.0);
}

TEST_F(ArrayForTwoEyes, AnaglyphShowsItsTipWhereEachEyeSeesIt)
{
  screen.scene.setStereo(Stereo::anaglyph);
  const DrawnPicture both = shown(screen);
  const EyePicture left = eye(both, [&](int x, int y) { return both.at(x, y)[0]; });
  const EyePicture right =
      eye(both, [&](int x, int y) { return 0.5 * (both.at(x, y)[1] + both.at(x, y)[2]); });
  EXPECT_NEAR(shift(left, right, 320, 200), expected_px, wholePixel);
}

TEST_F(ArrayForTwoEyes, SideBySideShowsItsTipWhereEachEyeSeesIt)
{
  screen.scene.setStereo(Stereo::sideBySide);
  const DrawnPicture both = shown(screen);
  const int half = both.width / 2;
  const EyePicture left = eye(both, [&](int x, int y) { return both.at(x / 2, y)[1]; });
  const EyePicture right = eye(both, [&](int x, int y) { return both.at(half + x / 2, y)[1]; });
  EXPECT_NEAR(shift(left, right, 320, 200), expected_px, 2.0 * wholePixel);
}

TEST_F(ArrayForTwoEyes, InterlacedShowsItsTipWhereEachEyeSeesIt)
{
  screen.scene.setStereo(Stereo::interlaced);
  const DrawnPicture both = shown(screen);
  const auto row = [&](int y, int odd) { return std::min(both.height - 1, y / 2 * 2 + odd); };
  const EyePicture odd = eye(both, [&](int x, int y) { return both.at(x, row(y, 1))[1]; });
  const EyePicture even = eye(both, [&](int x, int y) { return both.at(x, row(y, 0))[1]; });
  // the assignment of lines to eyes is a convention of the screen; their shift is geometry
  EXPECT_NEAR(std::abs(shift(odd, even, 320, 200)), std::abs(expected_px), wholePixel);
}

TEST_F(ArrayForTwoEyes, OneEyeIsBackWhenStereoIsOff)
{
  const DrawnPicture before = shown(screen);
  screen.scene.setStereo(Stereo::anaglyph);
  EXPECT_NE(shown(screen).rgb, before.rgb);
  screen.scene.setStereo(Stereo::off);
  EXPECT_EQ(shown(screen).rgb, before.rgb);
}

TEST(StereoBackground, IsOfOneColorSoThatNoShadeHasADisparity)
{
  SceneOnScreen screen;
  screen.scene.setStereo(Stereo::anaglyph);
  const DrawnPicture picture = shown(screen);
  for (const auto& [x, y] : {std::pair{1, 398}, std::pair{638, 398}, std::pair{638, 200}})
    EXPECT_LE(test::difference(picture.at(x, y), picture.at(1, 200)), 2) << x << ", " << y;
}

TEST(QualityTiers, FastDrawsFewerTrianglesAndNoSilhouettes)
{
  const QualityTraits fast = traitsOf(Quality::fast), balanced = traitsOf(Quality::software);
  EXPECT_LT(fast.wallTriangles, balanced.wallTriangles);
  EXPECT_LE(balanced.wallTriangles, 20000);
  SceneOnScreen full;
  vtkNew<vtkRenderWindow> window;
  InsertionScene scene(*test::publishedScala(), test::plainArray(), anatomy::Side::right,
                       Quality::fast);
  window->SetOffScreenRendering(true);
  window->SetSize(640, 400);
  scene.attachTo(*window);
  const auto bright = [](const test::Pixel& p, int, int) { return p[0] > 190; };
  EXPECT_LT(test::countPixels(test::draw(*window), bright),
            test::countPixels(full.picture(), bright));
}

}  // namespace
}  // namespace perilymph::visualization

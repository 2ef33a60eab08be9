// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <utility>

#include "SceneOnScreen.h"
#include "perilymph/anatomy/Surface.h"

namespace perilymph::visualization {
namespace {

using test::SceneOnScreen;

Eigen::Vector3d lookingDirection(SceneOnScreen& screen)
{
  return Eigen::Vector3d(screen.scene.renderer().GetActiveCamera()->GetDirectionOfProjection());
}

Eigen::Vector3d opening_mm() { return 1e3 * test::publishedScala()->entry().origin_W; }

TEST(Camera, SurgeonLooksAlongTheModiolusWithTheOpeningAtTheLeft)
{
  SceneOnScreen screen;
  EXPECT_NEAR(lookingDirection(screen).z(), -1.0, 1e-9);
  EXPECT_LT(screen.pixel(opening_mm()).x(), screen.pixel({0.0, 0.0, 0.0}).x() - 50.0);
}

TEST(Camera, TheRoundWindowIsTurned110DegreesFromStraightDown)
{
  SceneOnScreen screen;
  // angle zero of the anatomy is the x axis
  const Eigen::Vector2d axis = screen.pixel({5.0, 0.0, 0.0}) - screen.pixel({0.0, 0.0, 0.0});
  const double fromDown_deg = inDegrees(radians(std::acos(-axis.normalized().y())));
  EXPECT_NEAR(fromDown_deg, 110.0, 0.01);
  EXPECT_LT(axis.x(), 0.0);
}

TEST(Camera, ALeftEarHasItsOpeningAtTheRight)
{
  SceneOnScreen screen(anatomy::Side::left);
  Eigen::Vector3d opening = opening_mm();
  opening.y() = -opening.y();
  EXPECT_GT(screen.pixel(opening).x(), screen.pixel({0.0, 0.0, 0.0}).x() + 50.0);
}

TEST(Camera, MicroscopeLooksIntoTheOpening)
{
  SceneOnScreen screen;
  screen.scene.lookFrom(CameraPreset::microscope);
  const Eigen::Vector3d into = -test::publishedScala()->entry().out_W;
  EXPECT_GT(lookingDirection(screen).dot(into), std::cos(degrees(50).si()));
}

TEST(Camera, FollowTipKeepsTheTipInTheMiddle)
{
  SceneOnScreen screen;
  const haptics::Snapshot now = test::insertedTo(degrees(150));
  screen.scene.show(now);
  screen.scene.lookFrom(CameraPreset::followTip);
  const haptics::Snapshot later = test::insertedTo(degrees(170));
  screen.scene.show(later);
  for (int frame = 0; frame < 120; ++frame) screen.scene.stepCamera(1.0 / 60.0);
  const Eigen::Vector2d tip = screen.pixel(test::node_mm(later, test::arrayNodes - 1));
  EXPECT_NEAR(tip.x(), 320.0, 3.0);
  EXPECT_NEAR(tip.y(), 200.0, 3.0);
}

TEST(Camera, GlidesToAPresetIn250Milliseconds)
{
  SceneOnScreen glided, jumped;
  glided.scene.glideTo(CameraPreset::overview);
  jumped.scene.lookFrom(CameraPreset::overview);
  EXPECT_TRUE(glided.scene.stepCamera(0.1));
  EXPECT_LT(lookingDirection(glided).dot(lookingDirection(jumped)), 0.999);
  EXPECT_TRUE(glided.scene.stepCamera(0.15001));
  EXPECT_FALSE(glided.scene.stepCamera(0.02));
  EXPECT_NEAR(lookingDirection(glided).dot(lookingDirection(jumped)), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(glided.scene.magnification(), jumped.scene.magnification());
}

TEST(Camera, ASceneThatReplacesOneInMotionHasTheMagnificationOfItsEnd)
{
  SceneOnScreen moving, next, jumped;
  moving.scene.lookFrom(CameraPreset::followTip);
  moving.scene.glideTo(CameraPreset::overview);
  moving.scene.stepCamera(0.1);
  next.scene.keepViewOf(moving.scene);
  jumped.scene.lookFrom(CameraPreset::overview);
  EXPECT_DOUBLE_EQ(next.scene.magnification(), jumped.scene.magnification());
  EXPECT_NEAR(lookingDirection(next).dot(lookingDirection(jumped)), 1.0, 1e-12);
  EXPECT_FALSE(next.scene.stepCamera(0.1));
  // what the user chose is kept
  moving.scene.setMagnification(12.5);
  next.scene.keepViewOf(moving.scene);
  EXPECT_DOUBLE_EQ(next.scene.magnification(), 12.5);
}

/// The ear lies within an area of the picture, and fills a share of its width or height.
testing::AssertionResult isFramed(SceneOnScreen& screen, const FreeArea& area)
{
  constexpr double fewestShare = 0.85, edge_px = 1.0;
  const int* size = screen.window->GetSize();
  static const anatomy::Surface wall = anatomy::wallSurface(*test::publishedScala(), 2000);
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  screen.window->Render();
  vtkRenderer& renderer = screen.scene.renderer();
  for (const auto& [x, y, z] : wall.points) {
    renderer.SetWorldPoint(1e3 * x, 1e3 * y, 1e3 * z, 1.0);
    renderer.WorldToDisplay();
    const Eigen::Array2d place(renderer.GetDisplayPoint()[0], renderer.GetDisplayPoint()[1]);
    low = low.min(place);
    high = high.max(place);
  }
  const Eigen::Array2d least(area.left * size[0], area.bottom * size[1]);
  const Eigen::Array2d most(area.right * size[0], area.top * size[1]);
  const double share = ((high - low) / (most - least)).maxCoeff();
  const bool isLargest = screen.scene.magnification() > 31.99;  // no larger one is allowed
  if ((low > least - edge_px).all() && (high < most + edge_px).all() &&
      (share > fewestShare || isLargest))
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "from " << low.transpose() << " to " << high.transpose() << " in " << least.transpose()
         << " to " << most.transpose() << ": " << share;
}

TEST(Camera, FramesTheEarAfterEveryChange)
{
  SceneOnScreen screen;
  constexpr FreeArea areas[] = {{}, {0.05, 0.25, 0.95, 1.0}, {0.0, 0.1, 0.7, 0.8}};
  for (const FreeArea& area : areas) {
    screen.scene.setFreeArea(area);
    for (const auto& [width, height] : {std::pair{640, 400}, {400, 640}, {988, 456}, {300, 200}}) {
      screen.window->SetSize(width, height);
      for (const auto preset :
           {CameraPreset::surgeon, CameraPreset::overview, CameraPreset::section}) {
        screen.scene.lookFrom(CameraPreset::followTip);
        screen.scene.zoom(3.0);
        screen.scene.glideTo(preset);  // a key
        screen.scene.stepCamera(0.1);
        screen.window->SetSize(height, width);  // meanwhile
        screen.window->Render();
        screen.window->SetSize(width, height);
        while (screen.scene.stepCamera(0.1)) screen.window->Render();
        EXPECT_TRUE(isFramed(screen, area))
            << width << " x " << height << ", glided to " << int(preset);
        SceneOnScreen next;  // another patient or array
        next.window->SetSize(width, height);
        next.scene.keepViewOf(screen.scene);
        EXPECT_TRUE(isFramed(next, area)) << width << " x " << height << ", new " << int(preset);
        screen.window->SetSize(width + 100, height);
        EXPECT_TRUE(isFramed(screen, area))
            << width << " x " << height << ", wider " << int(preset);
        screen.window->SetSize(width, height);
      }
    }
  }
}

TEST(Camera, AViewChosenByTheUserIsNotFramedAgain)
{
  SceneOnScreen screen;
  screen.scene.setFreeArea({});
  screen.scene.lookFrom(CameraPreset::surgeon);
  screen.scene.setMagnification(31.0);
  screen.window->SetSize(500, 400);
  screen.window->Render();
  EXPECT_DOUBLE_EQ(screen.scene.magnification(), 31.0);
  screen.scene.lookFrom(CameraPreset::surgeon);
  EXPECT_LT(screen.scene.magnification(), 30.0);
}

TEST(Camera, MagnificationTenShowsSeventeenMillimeters)
{
  SceneOnScreen screen;
  screen.scene.setMagnification(10);
  const double pixels = (screen.pixel({1.0, 0.0, 0.0}) - screen.pixel({0.0, 0.0, 0.0})).norm();
  EXPECT_NEAR(400.0 / pixels, 17.0, 1e-6);
}

TEST(Camera, MagnificationStaysBetween4And32)
{
  SceneOnScreen screen;
  screen.scene.setMagnification(1000);
  EXPECT_DOUBLE_EQ(screen.scene.magnification(), 32.0);
  screen.scene.zoom(1e-6);
  EXPECT_DOUBLE_EQ(screen.scene.magnification(), 4.0);
}

TEST(Camera, MovingTheModelMovesItBySoManyMillimeters)
{
  SceneOnScreen screen;
  const Eigen::Vector2d before = screen.pixel({0.0, 0.0, 0.0});
  screen.scene.moveModel(2.0, -1.0);
  const Eigen::Vector2d moved_mm = 17.0 / 400.0 * (screen.pixel({0.0, 0.0, 0.0}) - before);
  EXPECT_NEAR(moved_mm.x(), 2.0, 1e-6);
  EXPECT_NEAR(moved_mm.y(), -1.0, 1e-6);
}

TEST(Camera, TurningTheModelTurnsWhatIsNearToTheRightAndUp)
{
  SceneOnScreen screen;
  const Eigen::Vector3d near(0.0, 0.0, 8.0);  // toward the viewer
  const Eigen::Vector2d before = screen.pixel(near);
  screen.scene.rotateModel(20, 0, 0);
  EXPECT_GT(screen.pixel(near).x(), before.x() + 10.0);
  screen.scene.lookFrom(CameraPreset::surgeon);
  screen.scene.rotateModel(0, 20, 0);
  EXPECT_GT(screen.pixel(near).y(), before.y() + 10.0);
}

TEST(Camera, ScaleBarIsRoundAndFitsAtEveryMagnification)
{
  SceneOnScreen screen;
  for (double times = 4.0; times <= 32.0; times += 0.7) {
    screen.scene.setMagnification(times);
    screen.picture();
    const double length_mm = screen.scene.scaleBarLength_mm();
    const double pixels = length_mm / (170.0 / times / 400.0);
    EXPECT_GT(pixels, 40.0) << times;
    EXPECT_LE(pixels, 110.0001) << times;
    const double power = std::pow(10.0, std::floor(std::log10(length_mm) + 1e-9));
    const double digit = length_mm / power;
    EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 ||
                std::abs(digit - 5) < 1e-9)
        << length_mm;
  }
}

/// The longest bright line of a picture, in columns from `left` on and below `top` [pixels].
int longestLine(const test::DrawnPicture& picture, int left, int top)
{
  int longest = 0;
  for (int y = 20; y < top; ++y) {
    int run = 0;
    for (int x = left; x < picture.width; ++x) {
      run = picture.at(x, y)[0] > 200 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST(Camera, ScaleBarIsDrawnAsLongAsItSays)
{
  SceneOnScreen screen;
  screen.showOnlyArray();
  EXPECT_NEAR(longestLine(screen.picture(), 320, 60),
              screen.scene.scaleBarLength_mm() * 400.0 / 17.0, 1.5);
}

TEST(Camera, ScaleBarIsNotCoveredByTheLegendsOfForceInANarrowPicture)
{
  SceneOnScreen screen;
  screen.showOnlyArray();
  screen.scene.setVisible(Part::wallForce, true);
  screen.scene.setVisible(Part::contactArrows, true);
  constexpr int height = 430;
  for (const int width : {200, 240, 300, 340, 640}) {
    screen.window->SetSize(width, height);
    screen.picture();
    const double length = screen.scene.scaleBarLength_mm() * height / 17.0;
    EXPECT_NEAR(longestLine(screen.picture(), width - 26 - int(length), 170), length, 1.5) << width;
  }
}

}  // namespace
}  // namespace perilymph::visualization

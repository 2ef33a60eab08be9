// SPDX-License-Identifier: BSD-3-Clause

// Bone that is cut open, as a picture.

#include "perilymph/visualization/BoneLayer.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cmath>
#include <numbers>

#include "perilymph/test/TestPicture.h"
#include "perilymph/visualization/SurfaceScene.h"

namespace perilymph::test {
namespace {

using Eigen::Vector3d;
using visualization::BoneModel;

constexpr double radius_mm = 5.0, cavity_mm = 2.0;
constexpr int pixels = 300;

/// A sphere about the origin [m].
anatomy::Surface sphere(double radius, bool isCavity)
{
  constexpr int rings = 40, around = 80;
  anatomy::Surface surface;
  for (int ring = 0; ring <= rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const double polar = std::numbers::pi * ring / rings,
                   angle = 2 * std::numbers::pi * k / around;
      surface.points.push_back({radius * std::sin(polar) * std::cos(angle),
                                radius * std::sin(polar) * std::sin(angle),
                                radius * std::cos(polar)});
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const int a = ring * around + k, b = ring * around + (k + 1) % around;
      for (std::array<int, 3> corners :
           {std::array{a, a + around, b}, {b, a + around, b + around}}) {
        if (isCavity) std::swap(corners[1], corners[2]);
        surface.triangles.push_back(corners);
      }
    }
  return surface;
}

/// A ball of bone with a cavity in its middle, cut at z = 0, the upper half removed.
std::shared_ptr<const BoneModel> ball()
{
  auto bone = std::make_shared<BoneModel>();
  bone->fine = sphere(1e-3 * radius_mm, false);
  const anatomy::Surface inner = sphere(1e-3 * cavity_mm, true);
  const int offset = static_cast<int>(bone->fine.points.size());
  bone->fine.points.insert(bone->fine.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& [a, b, c] : inner.triangles)
    bone->fine.triangles.push_back({a + offset, b + offset, c + offset});
  bone->coarse = bone->fine;
  bone->intensity = [](const Vector3d& point) -> std::optional<double> {
    const double distance = 1e3 * point.norm();
    return distance > cavity_mm && distance < radius_mm ? 1000.0 : 0.0;
  };
  bone->level = 500.0;
  bone->contrast = 500.0;
  bone->radius = 1e-3 * radius_mm;
  bone->cut = {Vector3d::Zero(), Vector3d::UnitZ()};
  return bone;
}

class ABoneLayer : public testing::Test {
protected:
  ABoneLayer()
  {
    window_->SetOffScreenRendering(1);
    window_->SetSize(pixels, pixels);
    scene_.attachTo(*window_);
    scene_.bone().setBone(ball());
    scene_.lookAlong(-Vector3d::UnitZ(), -Vector3d::UnitY());
    scene_.zoom(0.5);  // the whole ball
  }

  /// Pixels that are not ground.
  int drawn()
  {
    const DrawnPicture picture = draw(*window_);
    const Pixel ground = picture.at(2, 2);
    return countPixels(
        picture, [&](const Pixel& pixel, int, int) { return difference(pixel, ground) > 20; });
  }

  vtkNew<vtkRenderWindow> window_;
  visualization::SurfaceScene scene_{anatomy::Surface()};
};

TEST(ACutPlane, MovesAlongItsNormalAndStaysInTheBall)
{
  const auto bone = ball();
  const visualization::CutPlane oblique{Vector3d(1e-3, 0, 0), Vector3d(0.6, 0, 0.8)};
  const auto moved = visualization::moved(oblique, 1e-3, *bone);
  EXPECT_NEAR((moved.origin - oblique.origin - 1e-3 * oblique.removed).norm(), 0.0, 1e-12);
  EXPECT_EQ(moved.removed, oblique.removed);
  // at most a plane that touches the ball
  for (const double far : {1.0, -1.0}) {
    const auto end = visualization::moved(oblique, far, *bone);
    EXPECT_NEAR(end.removed.dot(end.origin - bone->center), far * bone->radius, 1e-12);
  }
}

TEST_F(ABoneLayer, ShowsTheCutAndLooksIntoTheCavity)
{
  const DrawnPicture picture = draw(*window_);
  const Pixel middle = picture.at(pixels / 2, pixels / 2);
  // between both spheres is the face of the cut: one color
  double perMm = 0.0;
  for (int x = pixels / 2; x < pixels; ++x)
    if (difference(picture.at(x, pixels / 2), picture.at(2, 2)) < 20) {
      perMm = (x - pixels / 2) / radius_mm;
      break;
    }
  ASSERT_GT(perMm, 10.0);
  const auto at = [&](double x_mm, double y_mm) {
    return picture.at(pixels / 2 + static_cast<int>(x_mm * perMm),
                      pixels / 2 + static_cast<int>(y_mm * perMm));
  };
  const Pixel face = at(3.5, 0.0);
  for (const double angle : {0.5, 1.7, 3.0, 4.4})
    EXPECT_LT(difference(at(3.5 * std::cos(angle), 3.5 * std::sin(angle)), face), 6);
  EXPECT_GT(difference(middle, face), 20);              // darker, deeper
  EXPECT_GT(difference(middle, picture.at(2, 2)), 10);  // and not a hole
  EXPECT_LT(difference(at(2.4, 0.0), face), 6);
  EXPECT_GT(difference(at(0.0, 1.5), face), 6);
}

TEST_F(ABoneLayer, IsCutWhereThePlaneIs)
{
  const int half = drawn();
  // the disk of the cut, 3 mm from the center: r^2 - h^2; from above the ball hides it below
  scene_.bone().moveCut(-3.0);
  EXPECT_NEAR(double(drawn()) / half, 1.0 - 9.0 / 25.0, 0.03);
  scene_.bone().moveCut(6.0);  // the sphere's greatest circle is shown again
  EXPECT_NEAR(double(drawn()) / half, 1.0, 0.03);
  ASSERT_TRUE(scene_.bone().cut());
  EXPECT_NEAR(1e3 * scene_.bone().cut()->origin.z(), 3.0, 1e-9);
}

TEST_F(ABoneLayer, HoldsTheCutAtItsRimAndFollowsAMotionAlongItsNormal)
{
  scene_.rotate(0.0, 60.0);
  draw(*window_);
  const auto handle = scene_.bone().handle();
  ASSERT_TRUE(handle);
  scene_.bone().moveCut(1.0);
  draw(*window_);
  const auto after = scene_.bone().handle();
  ASSERT_TRUE(after);
  // the rim is smaller, but moves along the normal; seen under 60 degrees
  const double along = (after->at_px - handle->at_px).dot(handle->per_mm.normalized());
  EXPECT_NEAR(along, handle->per_mm.norm(), 0.35 * handle->per_mm.norm());
  // facing the viewer it follows up and down
  scene_.bone().faceCut();
  draw(*window_);
  const auto facing = scene_.bone().handle();
  ASSERT_TRUE(facing);
  EXPECT_NEAR(facing->per_mm.x(), 0.0, 1e-9);
  EXPECT_LT(facing->per_mm.y(), -1.0);
}

TEST_F(ABoneLayer, HasItsLandmarksWhereTheyAreInThePicture)
{
  visualization::SceneLandmarks landmarks;
  landmarks.roundWindow = Vector3d(2e-3, 1e-3, 0);
  landmarks.axis = {Vector3d(0, 0, -3e-3), Vector3d(-1e-3, 0, 3e-3)};
  landmarks.contacts = {Vector3d(0, 2e-3, 0), Vector3d(0, -2e-3, 0)};
  scene_.bone().setLandmarks(landmarks);
  draw(*window_);
  const auto anchors = scene_.bone().anchors();
  using Kind = visualization::SceneAnchor::Kind;
  ASSERT_EQ(anchors.size(), 4U);
  EXPECT_EQ(anchors[0].kind, Kind::roundWindow);
  EXPECT_EQ(anchors[1].kind, Kind::basalTurnAxis);
  EXPECT_EQ(anchors[2].number, 1);
  EXPECT_EQ(anchors[3].number, 2);
  // seen from above with y upward: the first contact is above the second, both in the middle
  const double perMm = (anchors[3].at_px.y() - anchors[2].at_px.y()) / 4.0;
  ASSERT_GT(perMm, 5.0);
  EXPECT_NEAR(anchors[2].at_px.x(), 0.5 * pixels, 1.0);
  EXPECT_NEAR(anchors[0].at_px.x(), 0.5 * pixels + 2.0 * perMm, 1.0);
  EXPECT_NEAR(anchors[0].at_px.y(), 0.5 * pixels - perMm, 1.0);
  EXPECT_NEAR(anchors[1].at_px.x(), 0.5 * pixels - perMm, 1.0);
  scene_.bone().setVisible(false);
  EXPECT_TRUE(scene_.bone().anchors().empty());
  EXPECT_FALSE(scene_.bone().handle());
  EXPECT_EQ(drawn(), 0);
}

TEST_F(ABoneLayer, IsAbsentWhereItIsTakenAway)
{
  ASSERT_GT(drawn(), 1000);
  scene_.bone().setBone(nullptr);
  EXPECT_EQ(drawn(), 0);
  EXPECT_FALSE(scene_.bone().cut());
}

}  // namespace
}  // namespace perilymph::test

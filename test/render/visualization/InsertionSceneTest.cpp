// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/InsertionScene.h"

#include <gtest/gtest.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <cmath>
#include <limits>
#include <string>

#include "ForceColors.h"
#include "SceneOnScreen.h"

namespace perilymph::visualization {
namespace {

using test::SceneOnScreen;

/// Collects the messages of VTK until it is destroyed.
class VtkMessages {
public:
  VtkMessages() { vtkOutputWindow::SetInstance(window_); }
  ~VtkMessages() { vtkOutputWindow::SetInstance(nullptr); }
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;
  const std::string& text() const { return window_->said; }

private:
  struct Window : vtkOutputWindow {
    static Window* New() { VTK_STANDARD_NEW_BODY(Window); }
    void DisplayText(const char* text) override { said += text; }
    std::string said;
  };
  vtkNew<Window> window_;
};

bool isRedOrYellow(const test::Pixel& p) { return p[0] > 90 && p[0] > p[2] + 50; }

TEST(InsertionScene, ArrayLiesAroundTheNodesOfTheSnapshot)
{
  SceneOnScreen screen;
  screen.showOnlyArray();
  const haptics::Snapshot now = test::insertedTo(degrees(180));
  screen.scene.show(now);
  const auto [low, high] = screen.bounds();
  constexpr double rib_mm = 0.4 + 0.16;  // thickest part: a rib on the base's radius
  for (int node = 0; node < test::arrayNodes; ++node) {
    const Eigen::Vector3d place = test::node_mm(now, node);
    EXPECT_TRUE((place.array() > low.array()).all() && (place.array() < high.array()).all())
        << node;
  }
  // no farther than its radius, except for the lead behind the tweezers
  const Eigen::Vector3d tip = test::node_mm(now, test::arrayNodes - 1);
  EXPECT_LT((tip - low).minCoeff(), 24.0);
  double lowest = 1e9;
  for (int node = 0; node < test::arrayNodes; ++node)
    lowest = std::min(lowest, test::node_mm(now, node).z());
  EXPECT_GT(low.z(), lowest - rib_mm - 0.3);
}

TEST(InsertionScene, ArrayMovesByWhatTheNodesMove)
{
  SceneOnScreen screen;
  screen.showOnlyArray();
  haptics::Snapshot now = test::insertedTo(degrees(90));
  screen.scene.show(now);
  const double before = screen.bounds().second.z();
  for (int node = 0; node < test::arrayNodes; ++node)
    now.node_W[static_cast<std::size_t>(node)][2] += 0.003f;
  screen.scene.show(now);
  EXPECT_NEAR(screen.bounds().second.z() - before, 3.0, 1e-3);
}

TEST(InsertionScene, LeftEarIsTheMirrorImageOfTheRightOne)
{
  SceneOnScreen right(anatomy::Side::right), left(anatomy::Side::left);
  haptics::Snapshot now = test::insertedTo(degrees(200));
  test::press(now, 80, millinewtons(20));
  right.scene.show(now);
  left.scene.show(now);
  for (SceneOnScreen* screen : {&right, &left}) {
    screen->scene.setVisible(Part::wallForce, false);  // its scale is not mirrored
    screen->scene.setVisible(Part::styletAndTweezers, false);
  }
  const test::DrawnPicture a = right.picture(), b = left.picture();
  // Unlit bright lines and the arrow, above the scale bars.
  const auto isBright = [](const test::Pixel& p) { return p[0] > 150; };
  int both = 0, mirrored = 0;
  for (int y = 80; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (!isBright(a.at(x, y))) continue;
      ++both;
      for (int dx = -1; dx <= 1; ++dx) {
        const int mx = std::clamp(a.width - 1 - x + dx, 0, a.width - 1);
        if (isBright(b.at(mx, y))) {
          ++mirrored;
          break;
        }
      }
    }
  EXPECT_GT(both, 1000);
  EXPECT_GT(mirrored, 0.85 * both);  // light comes from the left in both
}

TEST(InsertionScene, ShowsWhereThePartitionIsTorn)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(60));
  const auto isTorn = [](const test::Pixel& p, int, int) {
    return p[0] > 190 && p[1] < 110 && p[2] < 110;
  };
  const auto tornPixels = [&] {
    screen.scene.show(now);
    return test::countPixels(screen.picture(), isTorn);
  };
  const int none = tornPixels();  // the scale of forces has this color too
  now.ruptures = 1;
  now.ruptured[0] = {degrees(120).si(), degrees(150).si()};
  const int one = tornPixels();
  EXPECT_GT(one, none + 50);
  now.ruptures = 2;
  now.ruptured[1] = {degrees(200).si(), degrees(230).si()};
  EXPECT_GT(tornPixels(), one);
  now.ruptures = 0;
  EXPECT_EQ(tornPixels(), none);
}

TEST(InsertionScene, LeftEarLiesAtMinusY)
{
  SceneOnScreen right(anatomy::Side::right), left(anatomy::Side::left);
  for (SceneOnScreen* screen : {&right, &left}) {
    screen->showOnlyArray();
    screen->scene.show(test::insertedTo(degrees(200)));
  }
  EXPECT_NEAR(right.bounds().first.y(), -left.bounds().second.y(), 1e-4);
  EXPECT_NEAR(right.bounds().second.y(), -left.bounds().first.y(), 1e-4);
  EXPECT_NEAR(right.bounds().first.x(), left.bounds().first.x(), 1e-4);
}

TEST(InsertionScene, ColorsTheWallWhereItIsPressedAndNowhereElse)
{
  SceneOnScreen screen;
  screen.scene.setVisible(Part::contactArrows, false);
  haptics::Snapshot now = test::insertedTo(degrees(200));
  screen.scene.show(now);
  const test::DrawnPicture before = screen.picture();
  test::press(now, 80, millinewtons(25));
  screen.scene.show(now);
  const test::DrawnPicture after = screen.picture();

  const Eigen::Vector2d center = screen.pixel(test::node_mm(now, 80));
  const double reach_px = 1.3 * 400.0 / 17.0;  // 1.3 mm: radius of array, spread and dot
  const auto isChanged = [&](int x, int y) {
    return test::difference(before.at(x, y), after.at(x, y)) > 30;
  };
  const int near = test::countPixels(after, [&](const test::Pixel& p, int x, int y) {
    return isChanged(x, y) && isRedOrYellow(p) &&
           (Eigen::Vector2d(x, y) - center).norm() <= reach_px;
  });
  const int far = test::countPixels(after, [&](const test::Pixel&, int x, int y) {
    return isChanged(x, y) && (Eigen::Vector2d(x, y) - center).norm() > reach_px;
  });
  EXPECT_GT(near, 30);
  EXPECT_EQ(far, 0);
}

TEST(InsertionScene, WallIsPlainAgainWhenNothingTouches)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(200));
  screen.scene.show(now);
  const test::DrawnPicture before = screen.picture();
  haptics::Snapshot pressed = now;
  test::press(pressed, 70, millinewtons(25));
  screen.scene.show(pressed);
  screen.picture();
  screen.scene.show(now);
  EXPECT_EQ(screen.picture().rgb, before.rgb);
}

TEST(InsertionScene, ForceColorsDoNotDependOnTheNumberOfNodes)
{
  // The same line load on 100 nodes and on every second node.
  SceneOnScreen screen;
  screen.scene.setVisible(Part::contactArrows, false);
  haptics::Snapshot fine = test::insertedTo(degrees(200));
  haptics::Snapshot coarse = fine;
  for (int node = 60; node < 80; ++node) test::press(fine, node, millinewtons(5));
  for (int node = 60; node < 80; node += 2) test::press(coarse, node, millinewtons(10));
  screen.scene.show(fine);
  const test::DrawnPicture a = screen.picture();
  screen.scene.show(coarse);
  const test::DrawnPicture b = screen.picture();
  const int differing = test::countPixels(
      a, [&](const test::Pixel& p, int x, int y) { return test::difference(p, b.at(x, y)) > 40; });
  EXPECT_LT(differing, 40);
}

TEST(InsertionScene, AnArrowPointsIntoTheLumenWhereTheWallPresses)
{
  SceneOnScreen screen;
  screen.scene.setVisible(Part::wallForce, false);
  haptics::Snapshot now = test::insertedTo(degrees(200));
  screen.scene.show(now);
  const test::DrawnPicture before = screen.picture();
  test::press(now, 80, millinewtons(40));
  screen.scene.show(now);
  const test::DrawnPicture after = screen.picture();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const int changed = test::countPixels(after, [&](const test::Pixel& p, int x, int y) {
    // orange; a force along the array has a separate, blue arrow
    const bool is = test::difference(before.at(x, y), p) > 40 && p[0] > p[2] + 40;
    if (is) sum += Eigen::Vector2d(x, y);
    return is;
  });
  ASSERT_GT(changed, 10);
  const Eigen::Vector2d node = screen.pixel(test::node_mm(now, 80));
  const Eigen::Vector2d modiolus = screen.pixel({0.0, 0.0, 0.0});
  const Eigen::Vector2d arrow = sum / changed - node;
  EXPECT_GT(arrow.normalized().dot((modiolus - node).normalized()), 0.9);
}

TEST(InsertionScene, NoArrowCoversAContact)
{
  SceneOnScreen screen, bare;
  electrode::ArrayDesign array = test::plainArray();
  array.contactsFromTip.clear();
  InsertionScene without(*test::publishedScala(), array, anatomy::Side::right, Quality::software);
  bare.window->RemoveRenderer(&bare.scene.renderer());
  without.attachTo(*bare.window);
  haptics::Snapshot now = test::insertedTo(degrees(250));
  for (int node = 20; node < test::arrayNodes; node += 4) test::press(now, node, millinewtons(30));
  for (InsertionScene* scene : {&screen.scene, &without}) {
    scene->setVisible(Part::wallForce, false);
    scene->setVisible(Part::contactArrows, false);
    scene->show(now);
  }
  for (const CameraPreset preset :
       {CameraPreset::surgeon, CameraPreset::overview, CameraPreset::followTip}) {
    screen.scene.lookFrom(preset);
    without.lookFrom(preset);
    screen.scene.setMagnification(20);
    without.setMagnification(20);
    const test::DrawnPicture plain = bare.picture(), contacts = screen.picture();
    screen.scene.setVisible(Part::contactArrows, true);
    const test::DrawnPicture arrows = screen.picture();
    screen.scene.setVisible(Part::contactArrows, false);
    int contactPixels = 0, arrowPixels = 0, covered = 0;
    test::countPixels(contacts, [&](const test::Pixel& p, int x, int y) {
      constexpr int legend_px = 110;  // the arrows' legend comes and goes with them
      if (y < legend_px) return false;
      const bool isContact = test::difference(plain.at(x, y), p) > 25;
      const bool isArrow = test::difference(arrows.at(x, y), p) > 40;
      contactPixels += isContact;
      arrowPixels += isArrow;
      covered += isContact && isArrow;
      return false;
    });
    EXPECT_GT(contactPixels, 50) << int(preset);
    EXPECT_GT(arrowPixels, 50) << int(preset);
    EXPECT_LE(covered, contactPixels / 50) << int(preset);  // edges that are smoothed
  }
}

TEST(InsertionScene, StyletComesOutBehindAsItIsPulled)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(270));
  screen.showOnlyArray();
  screen.scene.setVisible(Part::styletAndTweezers, true);
  screen.scene.show(now);
  const auto before = screen.bounds();
  now.output.styletWithdrawal = 0.040;  // beyond the tweezers, which reach 30 mm
  screen.scene.show(now);
  const auto after = screen.bounds();
  const double grown =
      (before.first - after.first).cwiseMax(after.second - before.second).maxCoeff();
  EXPECT_GT(grown, 5.0);
}

TEST(InsertionScene, PartsCanBeSwitchedOff)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(200));
  test::press(now, 80, millinewtons(40));
  screen.scene.show(now);
  for (const Part part : {Part::wallForce, Part::contactArrows, Part::membrane, Part::scala}) {
    const test::DrawnPicture with = screen.picture();
    screen.scene.setVisible(part, false);
    EXPECT_NE(screen.picture().rgb, with.rgb) << static_cast<int>(part);
    screen.scene.setVisible(part, true);
    EXPECT_EQ(screen.picture().rgb, with.rgb) << static_cast<int>(part);
  }
}

TEST(InsertionScene, HidesAnArrayThatIsNotFinite)
{
  SceneOnScreen screen;
  const test::DrawnPicture empty = screen.picture();
  haptics::Snapshot now = test::insertedTo(degrees(200));
  screen.scene.show(now);
  EXPECT_NE(screen.picture().rgb, empty.rgb);
  now.node_W[50][1] = std::numeric_limits<float>::quiet_NaN();
  screen.scene.show(now);
  EXPECT_EQ(screen.picture().rgb, empty.rgb);
}

TEST(InsertionScene, DrawsAScalaWithoutAnArray)
{
  InsertionScene scene(*test::publishedScala(), electrode::ArrayDesign{}, anatomy::Side::right);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(320, 200);
  scene.attachTo(*window);
  scene.show(test::insertedTo(degrees(200)));
  const test::DrawnPicture picture = test::draw(*window);
  EXPECT_GT(test::countPixels(picture, [](const test::Pixel& p, int, int) { return p[0] > 150; }),
            100);
}

TEST(InsertionScene, FullQualityShowsWhatBalancedShows)
{
  haptics::Snapshot now = test::insertedTo(degrees(220));
  for (int node = 84; node < 97; ++node) test::press(now, node, millinewtons(8));
  const auto drawn = [&now](Quality quality) {
    InsertionScene scene(*test::publishedScala(), test::plainArray(), anatomy::Side::right,
                         quality);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(true);
    window->SetSize(640, 400);
    scene.attachTo(*window);
    scene.show(now);
    return test::draw(*window);
  };
  const test::DrawnPicture balanced = drawn(Quality::software), full = drawn(Quality::gpu);
  const int differing = test::countPixels(full, [&](const test::Pixel& p, int x, int y) {
    return test::difference(p, balanced.at(x, y)) > 48;
  });
  EXPECT_LT(differing, 640 * 400 / 100);  // edges of a finer mesh
}

TEST(InsertionScene, HasALegendOfTheArrowsWithoutWallForce)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(220));
  screen.scene.setVisible(Part::wallForce, false);
  screen.scene.show(now);
  const test::DrawnPicture with = screen.picture();
  screen.scene.setVisible(Part::contactArrows, false);
  screen.scene.show(now);
  const test::DrawnPicture without = screen.picture();
  const int legend = test::countPixels(with, [&](const test::Pixel& p, int x, int y) {
    return x < 260 && y < 120 && test::difference(p, without.at(x, y)) > 30;
  });
  EXPECT_GT(legend, 200);
}

/// Relative luminance of a color over a ground, as WCAG 2.1 defines it.
double luminanceOver(const Rgba& color, const Rgba& ground)
{
  const double weights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = (ground[i] + color[3] / 255.0 * (color[i] - ground[i])) / 255.0;
    sum += weights[i] * (value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return sum;
}

TEST(ForceColors, MoveAwayFromTheGroundInLuminanceThroughout)
{
  for (const auto scheme : {figures::ColorScheme::dark, figures::ColorScheme::light}) {
    const Rgba& ground = sceneColorsOf(scheme).ground;
    const double sign = scheme == figures::ColorScheme::dark ? 1.0 : -1.0;
    double before = luminanceOver(forceColor(0.0, scheme), ground);
    for (double force = 1.0; force <= maxWallForce_mN_mm; force += 1.0) {
      const double now = luminanceOver(forceColor(force, scheme), ground);
      EXPECT_GE(sign * (now - before), 0.0) << force << " mN/mm";
      before = now;
    }
    EXPECT_GT(sign * (before - luminanceOver(forceColor(10.0, scheme), ground)), 0.2);
  }
}

TEST(InsertionScene, LooksAsAccepted)
{
  SceneOnScreen screen;
  haptics::Snapshot now = test::insertedTo(degrees(220));
  for (int node = 84; node < 97; ++node) test::press(now, node, millinewtons(0.8 * (node - 83)));
  screen.scene.show(now);
  EXPECT_EQ(test::comparedWithAccepted(screen.picture(), "surgeon-view"), "");
  screen.scene.lookFrom(CameraPreset::overview);
  EXPECT_EQ(test::comparedWithAccepted(screen.picture(), "overview"), "");
}

// Every hundred frames VTK measures the render time of each actor, and it reports an error if the
// actor is empty in the next frames.
TEST(InsertionScene, VtkReportsNoErrorsWhenContactsAppearAndDisappear)
{
  SceneOnScreen screen;
  screen.scene.setVisible(Part::scala, false);
  const haptics::Snapshot released = test::insertedTo(degrees(200));
  haptics::Snapshot pressed = released;
  test::press(pressed, 80, millinewtons(20));
  const VtkMessages label;
  for (int picture = 0; picture < 330; ++picture) {
    screen.scene.show(picture % 3 == 0 ? pressed : released);
    screen.window->Render();
  }
  EXPECT_EQ(label.text(), "");
}

}  // namespace
}  // namespace perilymph::visualization

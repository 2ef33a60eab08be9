// SPDX-License-Identifier: BSD-3-Clause

// Frames of a resting camera, in which only what moves is drawn, beside frames that are drawn as a whole.

#include <gtest/gtest.h>

#include <functional>
#include <span>

#include "SceneOnScreen.h"

namespace perilymph::visualization {
namespace {

using test::SceneOnScreen;

/// An array on its way in, with forces on the wall near its tip.
haptics::Snapshot pressedAt(double tip_deg)
{
  haptics::Snapshot now = test::insertedTo(degrees(tip_deg));
  for (int node = 80; node < 97; ++node) test::press(now, node, millinewtons(2.0 * (node - 79)));
  return now;
}

/// The same frame drawn as a whole.
test::DrawnPicture whole(SceneOnScreen& screen)
{
  screen.scene.setRestingPartsKept(false);
  test::DrawnPicture picture = screen.picture();
  screen.scene.setRestingPartsKept(true);
  return picture;
}

/// Two frames after which the resting parts are kept.
void rest(SceneOnScreen& screen)
{
  screen.picture();
  screen.picture();
}

struct RestingPartsOf : ::testing::TestWithParam<figures::ColorScheme> {};

TEST_P(RestingPartsOf, AnInsertionAreKeptWithoutChangingAPixel)
{
  SceneStyle style;
  style.scheme = GetParam();
  SceneOnScreen screen(anatomy::Side::right, style);
  for (int tip_deg = 150; tip_deg <= 240; tip_deg += 10) {
    screen.scene.show(pressedAt(tip_deg));
    for (int step = 1; step <= 2; ++step) {
      rest(screen);
      screen.scene.show(pressedAt(tip_deg + 3 * step));
      const test::DrawnPicture kept = screen.picture();
      EXPECT_LT(screen.scene.drawnFraction(), 0.6);
      EXPECT_TRUE(kept.rgb == whole(screen).rgb) << tip_deg;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, RestingPartsOf,
                         ::testing::Values(figures::ColorScheme::dark,
                                           figures::ColorScheme::light));

/// A tetrahedron of bone beside the cochlea.
std::shared_ptr<const BoneModel> bone()
{
  auto model = std::make_shared<BoneModel>();
  model->fine.points = {{0.0, 0.0, 0.0}, {0.006, 0.0, 0.0}, {0.0, 0.006, 0.0}, {0.0, 0.0, 0.006}};
  model->fine.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  model->coarse = model->fine;
  model->intensity = [](const Eigen::Vector3d&) { return std::optional<double>(1000.0); };
  model->level = 500.0;
  model->contrast = 500.0;
  model->radius = 0.008;
  model->cut = {Eigen::Vector3d(0.0, 0.0, 0.001), Eigen::Vector3d::UnitZ()};
  return model;
}

/// Anything that changes how resting parts look.
struct Change {
  const char* name;
  std::function<void(SceneOnScreen&)> make;
};

const Change changes[] = {
    {"a turned camera", [](SceneOnScreen& s) { s.scene.rotateModel(20.0, 5.0, 0.0); }},
    {"a moved model", [](SceneOnScreen& s) { s.scene.moveModel(1.0, 0.5); }},
    {"another magnification", [](SceneOnScreen& s) { s.scene.zoom(1.3); }},
    {"another preset", [](SceneOnScreen& s) { s.scene.lookFrom(CameraPreset::overview); }},
    {"a larger window", [](SceneOnScreen& s) { s.window->SetSize(700, 450); }},
    {"another pixel ratio", [](SceneOnScreen& s) { s.scene.setScale(2.0); }},
    {"a hidden membrane", [](SceneOnScreen& s) { s.scene.setVisible(Part::membrane, false); }},
    {"a hidden scala", [](SceneOnScreen& s) { s.scene.setVisible(Part::scala, false); }},
    {"a wall without force", [](SceneOnScreen& s) { s.scene.setVisible(Part::wallForce, false); }},
    {"a hidden stylet",
     [](SceneOnScreen& s) { s.scene.setVisible(Part::styletAndTweezers, false); }},
    {"landmarks", [](SceneOnScreen& s) { s.scene.setVisible(Part::landmarks, true); }},
    {"bone",
     [](SceneOnScreen& s) {
       s.scene.bone().setBone(bone());
       s.scene.setVisible(Part::landmarks, true);
     }},
    {"a moved cut of bone",
     [](SceneOnScreen& s) {
       s.scene.bone().setBone(bone());
       s.scene.setVisible(Part::landmarks, true);
       rest(s);
       s.scene.bone().moveCut(1.5);
     }},
    {"a torn partition",
     [](SceneOnScreen& s) {
       haptics::Snapshot now = pressedAt(200.0);
       now.ruptures = 1;
       now.ruptured[0] = {degrees(120).si(), degrees(150).si()};
       s.scene.show(now);
     }},
    {"another insertion behind this one",
     [](SceneOnScreen& s) {
       std::vector<Eigen::Vector3d> nodes;
       const haptics::Snapshot other = test::insertedTo(degrees(120));
       for (const auto& node : std::span(other.node_W).first(test::arrayNodes))
         nodes.emplace_back(node[0], node[1], node[2]);
       s.scene.showGhost(test::plainArray(), nodes);
     }},
    {"another background",
     [](SceneOnScreen& s) {
       s.scene.setStereo(Stereo::off);
       s.scene.renderer().SetBackground(0.5, 0.1, 0.1);
       s.scene.setVisible(Part::scala, false);
     }},
    {"stereo", [](SceneOnScreen& s) { s.scene.setStereo(Stereo::anaglyph); }},
    {"no array", [](SceneOnScreen& s) { s.scene.show({}); }},
};

TEST(RestingParts, AreDrawnAgainAfterAnyChangeOfTheirLook)
{
  for (const Change& change : changes) {
    SCOPED_TRACE(change.name);
    SceneOnScreen screen;
    screen.scene.show(pressedAt(200.0));
    rest(screen);
    const test::DrawnPicture before = screen.picture();
    change.make(screen);
    // the frame of the change, the one that keeps the parts again, and one that has kept parts
    for (int frame = 0; frame < 3; ++frame) {
      const test::DrawnPicture kept = screen.picture();
      EXPECT_FALSE(kept.rgb == before.rgb) << frame;
      EXPECT_TRUE(kept.rgb == whole(screen).rgb) << frame;
      rest(screen);
    }
  }
}

TEST(RestingParts, AreNotKeptInStereo)
{
  SceneOnScreen screen;
  screen.scene.setStereo(Stereo::sideBySide);
  screen.scene.show(pressedAt(200.0));
  rest(screen);
  screen.picture();
  EXPECT_DOUBLE_EQ(screen.scene.drawnFraction(), 1.0);
}

}  // namespace
}  // namespace perilymph::visualization

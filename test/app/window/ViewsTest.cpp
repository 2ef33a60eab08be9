// SPDX-License-Identifier: BSD-3-Clause

// Arrangement of the insertion page, stereo, and rendering quality.

#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QMenu>
#include <QTest>

#include "WindowRig.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/Pane.h"
#include "gui/pages/insert/ViewMenu.h"
#include "gui/program/DisplayProbe.h"
#include "gui/run/UserSettings.h"
#include "gui/scene/StereoWindow.h"
#include "gui/shell/WindowPlace.h"

namespace perilymph::test {
namespace {

using gui::AdaptiveQuality;
using gui::Pane;
using gui::PaneLayout;
using visualization::Quality;
using visualization::Stereo;

/// Removes a test's settings, so that they do not affect the next one.
struct Views : ::testing::Test {
  Views() { gui::UserSettings().clear(); }
  ~Views() override { gui::UserSettings().clear(); }
};

QWidget& pane(WindowRig& rig, const char* name)
{
  auto* found = rig.window().findChild<Pane*>(QLatin1String(name));
  if (found == nullptr) throw std::runtime_error(std::string("The window has no ") + name + ".");
  return *found;
}

QAction& entry(WindowRig& rig, const char* name)
{
  auto* found = rig.window().findChild<QAction*>(QLatin1String(name));
  if (found == nullptr) throw std::runtime_error(std::string("The menu has no ") + name + ".");
  return *found;
}

TEST_F(Views, TwoAreSeenAtFirstThenFourThenOneWithL)
{
  WindowRig rig;
  EXPECT_TRUE(pane(rig, "travelPane").isVisible());
  EXPECT_FALSE(pane(rig, "sectionPane").isVisible());
  rig.pressKey(Qt::Key_L);
  for (const char* name :
       {"travelPane", "componentsPane", "unrolledPane", "sectionPane", "distancesPane"})
    EXPECT_TRUE(pane(rig, name).isVisible()) << name;
  rig.pressKey(Qt::Key_L);
  EXPECT_TRUE(rig.window().view().isVisible());
  EXPECT_FALSE(pane(rig, "travelPane").isVisible());
  rig.pressKey(Qt::Key_L);
  EXPECT_EQ(rig.window().views().arrangement(), PaneLayout::two);
}

TEST_F(Views, NoneLiesOnAnother)
{
  WindowRig rig;
  for (const Qt::Key key : {Qt::Key_2, Qt::Key_4}) {
    rig.pressKey(key, Qt::ControlModifier);
    QList<QWidget*> seen{&rig.window().view()};
    for (Pane* one : rig.window().findChildren<Pane*>())
      if (one->isVisible()) seen << one;
    for (const QWidget* one : seen)
      for (const QWidget* other : seen)
        EXPECT_TRUE(one == other || !one->geometry().intersects(other->geometry()))
            << one->objectName().toStdString() << " lies on " << other->objectName().toStdString();
  }
}

TEST_F(Views, FourFitIntoTheSmallestWindowWithReadOutsThatDoNotOverlap)
{
  WindowRig rig;
  rig.window().resize(gui::preferredMinimumSize);
  rig.pressKey(Qt::Key_4, Qt::ControlModifier);
  const gui::OperationView& view = rig.window().view();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return view.height() < 380; }));
  EXPECT_FALSE(rig.window().findChild<QWidget*>("phaseLine")->isVisible());
  QList<const QWidget*> parts;
  for (const char* name : {"travelReadOut", "angleReadOut", "forceReadOut", "forceWords",
                           "magnificationLabel", "viewButton"})
    parts << rig.window().findChild<QWidget*>(QLatin1String(name));
  int covered = 0;
  for (const QWidget* one : parts) {
    EXPECT_TRUE(view.rect().contains(one->geometry())) << one->objectName().toStdString();
    covered += one->width() * one->height();
    for (const QWidget* other : parts)
      EXPECT_TRUE(one == other || !one->geometry().intersects(other->geometry()))
          << one->objectName().toStdString() << " and " << other->objectName().toStdString();
  }
  EXPECT_LT(covered, view.width() * view.height() / 4);
}

/// The first of a view's texts that lies over the scala's center line, and where; empty if none does.
std::string covering(gui::OperationView& view, const anatomy::ScalaTympani& scala)
{
  vtkRenderer& renderer = view.scene()->renderer();
  for (double angle = 0.0; angle <= scala.lastAngle().si(); angle += degrees(10).si()) {
    const Eigen::Vector3d at_mm = 1e3 * scala.center_W(angle);  // the scene's unit
    renderer.SetWorldPoint(at_mm.x(), at_mm.y(), at_mm.z(), 1.0);
    renderer.WorldToDisplay();
    const double* const shown_px = renderer.GetDisplayPoint();
    const QPoint place{int(shown_px[0]), view.height() - int(shown_px[1])};
    const std::string where = " at " + std::to_string(inDegrees(radians(angle))) + " degrees";
    if (!view.rect().contains(place)) return "the view ends" + where;
    for (const QWidget* part : view.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (part->isVisible() && part->objectName() != "sceneLabels" &&
          part->geometry().contains(place))
        return part->objectName().toStdString() + " lies" + where;
  }
  return {};
}

/// Wherever the tip comes to: the places of the center line lie beside all texts of the view.
TEST_F(Views, KeepTheScalaBesideTheReadOutsInWindowsOfAllHeights)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_4, Qt::ControlModifier);
  gui::OperationView& view = rig.window().view();
  const anatomy::ScalaTympani& scala = rig.window().control().anatomy();
  for (const QSize size : {gui::preferredMinimumSize, QSize(1280, 800), QSize(1366, 718),
                           QSize(1600, 870), QSize(1920, 1050)}) {
    rig.window().resize(size);
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().size() == size; }));
    EXPECT_TRUE(WindowRig::waitUntil([&] { return covering(view, scala).empty(); }))
        << covering(view, scala) << " in a view of " << view.width() << " x " << view.height();
  }
}

TEST_F(Views, ADoubleClickEnlargesOneAndAnotherBringsTheOthersBack)
{
  WindowRig rig;
  QWidget& unrolled = pane(rig, "unrolledPane");
  const QRect before = unrolled.geometry();
  QTest::mouseDClick(&unrolled, Qt::LeftButton, Qt::NoModifier, unrolled.rect().center());
  EXPECT_EQ(unrolled.geometry(), rig.window().views().rect());
  EXPECT_FALSE(rig.window().view().isVisible());
  QTest::mouseDClick(&unrolled, Qt::LeftButton, Qt::NoModifier, unrolled.rect().center());
  EXPECT_EQ(unrolled.geometry(), before);
  EXPECT_TRUE(rig.window().view().isVisible());
}

TEST_F(Views, ADoubleClickOnThePictureEnlargesIt)
{
  WindowRig rig;
  gui::OperationView& view = rig.window().view();
  QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, view.rect().center());
  EXPECT_EQ(view.geometry(), rig.window().views().rect());
}

TEST_F(Views, TheirNumberIsKeptForTheNextWindow)
{
  {
    WindowRig rig;
    rig.pressKey(Qt::Key_4, Qt::ControlModifier);
  }
  WindowRig next;
  EXPECT_EQ(next.window().views().arrangement(), PaneLayout::four);
}

TEST_F(Views, AnUnknownSettingIsIgnored)
{
  gui::UserSettings().setValue("insert/layout", "seventeen");
  WindowRig rig;
  EXPECT_EQ(rig.window().views().arrangement(), PaneLayout::two);
}

TEST_F(Views, GGoesThroughTheKindsOfStereoAndSaysWhich)
{
  WindowRig rig;
  const QImage mono = rig.picture();
  const QString name = rig.label("viewLabel");
  for (const Stereo stereo : {Stereo::anaglyph, Stereo::sideBySide, Stereo::interlaced}) {
    rig.pressKey(Qt::Key_G);
    EXPECT_EQ(rig.window().view().stereo(), stereo);
    EXPECT_NE(rig.label("viewLabel"), name);
    if (stereo != Stereo::sideBySide) {
      EXPECT_NE(rig.picture(), mono);
    }
  }
  rig.pressKey(Qt::Key_G);
  EXPECT_EQ(rig.picture(), mono);
  EXPECT_EQ(rig.label("viewLabel"), name);
}

TEST_F(Views, QuadBufferedStereoIsGreyWithItsReasonWhereTheDisplayHasNoBuffersForIt)
{
  WindowRig rig;
  const QString reason = gui::quadBufferedError(false);
  rig.window().views().offerQuadBuffered(reason);
  const QAction& quad = entry(rig, "stereoQuadBuffered");
  EXPECT_FALSE(quad.isEnabled());
  EXPECT_GT(reason.size(), 10);
  EXPECT_TRUE(quad.text().contains(reason));
  EXPECT_EQ(quad.toolTip(), reason);
  rig.window().views().setStereo(Stereo::quadBuffered);
  EXPECT_EQ(rig.window().view().stereo(), Stereo::off);
  EXPECT_EQ(rig.window().views().stereoWindow(), nullptr);
}

TEST_F(Views, QuadBufferedStereoOpensAWindowOfItsOwnWhereTheDisplayHasBuffersForIt)
{
  WindowRig rig;
  rig.window().views().offerQuadBuffered(gui::quadBufferedError(true));
  ASSERT_TRUE(entry(rig, "stereoQuadBuffered").isEnabled());
  const QImage mono = rig.picture();
  entry(rig, "stereoQuadBuffered").trigger();
  EXPECT_EQ(rig.window().view().stereo(), Stereo::quadBuffered);
  const gui::StereoWindow* twin = rig.window().views().stereoWindow();
  ASSERT_NE(twin, nullptr);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return twin->isOpen(); }));
  EXPECT_EQ(rig.picture(), mono);  // the overlays of the operation view stay
  entry(rig, "viewOverview").trigger();
  rig.pressKey(Qt::Key_G);
  EXPECT_EQ(rig.window().view().stereo(), Stereo::off);
  EXPECT_EQ(rig.window().views().stereoWindow(), nullptr);
}

TEST_F(Views, SideBySideFillsAWindowOfItsOwn)
{
  WindowRig rig;
  const QImage mono = rig.picture();
  entry(rig, "stereoSideBySide").trigger();
  const gui::StereoWindow* twin = rig.window().views().stereoWindow();
  ASSERT_NE(twin, nullptr);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return twin->isOpen(); }));
  EXPECT_EQ(rig.picture(), mono);  // read-outs stay readable in the main window
  entry(rig, "stereoOff").trigger();
  EXPECT_EQ(rig.window().views().stereoWindow(), nullptr);
}

TEST_F(Views, StereoIsOffOnceItsWindowIsClosed)
{
  WindowRig rig;
  rig.window().views().offerQuadBuffered({});
  rig.window().views().setStereo(Stereo::quadBuffered);
  ASSERT_NE(rig.window().views().stereoWindow(), nullptr);
  rig.window().views().stereoWindow()->close();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.window().view().stereo() == Stereo::off; }));
  EXPECT_EQ(rig.window().views().stereoWindow(), nullptr);
}

TEST_F(Views, TheForceIsSilentUntilAskedForAndGreyWithItsReasonWhereNothingCanSound)
{
  WindowRig rig;
  auto& menu = *rig.window().findChild<gui::ViewMenu*>();
  QAction& sound = entry(rig, "soundOfForce");
  EXPECT_FALSE(sound.isChecked());
  menu.offerSound("no speaker");
  EXPECT_FALSE(sound.isEnabled());
  EXPECT_TRUE(sound.text().contains("no speaker"));
  menu.offerSound({});
  EXPECT_TRUE(sound.isEnabled());
  EXPECT_FALSE(sound.isChecked());
  EXPECT_TRUE(sound.toolTip().contains("220 Hz"));
}

TEST_F(Views, OpeningTheMenuFindsOutWhetherTheForceCanBeHeardHere)
{
  WindowRig rig;
  const QAction& sound = entry(rig, "soundOfForce");
  const QString looking = sound.text();
  Q_EMIT rig.window().findChild<gui::ViewMenu*>()->menu()->aboutToShow();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return sound.text() != looking; }));
}

TEST_F(Views, TheMenuChoosesWhatTheKeysChoose)
{
  WindowRig rig;
  entry(rig, "layoutFour").trigger();
  EXPECT_EQ(rig.window().views().arrangement(), PaneLayout::four);
  entry(rig, "stereoAnaglyph").trigger();
  EXPECT_EQ(rig.window().view().stereo(), Stereo::anaglyph);
  entry(rig, "viewOverview").trigger();
  EXPECT_EQ(rig.window().view().scene()->preset(), visualization::CameraPreset::overview);
}

TEST_F(Views, AnotherTierDrawsTheSameFromTheSamePlace)
{
  WindowRig rig;
  rig.click("show2");  // without the membrane
  entry(rig, "viewOverview").trigger();
  entry(rig, "qualityFast").trigger();
  EXPECT_EQ(rig.window().views().quality(), Quality::fast);
  EXPECT_EQ(rig.window().view().scene()->preset(), visualization::CameraPreset::overview);
  EXPECT_FALSE(rig.window().view().scene()->isVisible(visualization::Part::membrane));
}

TEST(QualityOfAMachine, IsKnownByTheRenderersName)
{
  EXPECT_EQ(AdaptiveQuality("llvmpipe (LLVM 15.0.6, 256 bits)").quality(), Quality::software);
  EXPECT_EQ(AdaptiveQuality("Mesa Intel(R) UHD Graphics 620 (KBL GT2)").quality(), Quality::gpu);
}

TEST(QualityOfAMachine, StepsDownOnceWhenItsFirstSecondIsSlow)
{
  AdaptiveQuality pilot("llvmpipe");
  EXPECT_FALSE(pilot.weigh(4, 2.0, 200.0));   // too few frames
  EXPECT_FALSE(pilot.weigh(40, 0.5, 200.0));  // too early
  EXPECT_TRUE(pilot.weigh(40, 2.0, 200.0));
  EXPECT_EQ(pilot.quality(), Quality::fast);
  EXPECT_FALSE(pilot.weigh(80, 4.0, 200.0));
}

TEST(QualityOfAMachine, StaysWhenItsFirstSecondIsQuick)
{
  AdaptiveQuality pilot("llvmpipe");
  EXPECT_FALSE(pilot.weigh(40, 2.0, 30.0));
  EXPECT_FALSE(pilot.weigh(80, 4.0, 200.0));  // a later busy moment does not count
  EXPECT_EQ(pilot.quality(), Quality::software);
}

TEST(QualityOfAMachine, IsRestoredWhileNothingMoves)
{
  AdaptiveQuality pilot("llvmpipe");
  EXPECT_FALSE(pilot.rest(true));
  EXPECT_FALSE(pilot.rest(false));
  ASSERT_TRUE(pilot.weigh(40, 2.0, 200.0));
  EXPECT_TRUE(pilot.rest(true));
  EXPECT_EQ(pilot.quality(), Quality::software);
  EXPECT_TRUE(pilot.rest(false));
  EXPECT_EQ(pilot.quality(), Quality::fast);
}

TEST(QualityOfAMachine, GivesWayToAChoice)
{
  AdaptiveQuality pilot("llvmpipe");
  pilot.choose(Quality::gpu);
  EXPECT_FALSE(pilot.weigh(40, 2.0, 500.0));
  EXPECT_EQ(pilot.quality(), Quality::gpu);
}

TEST(QualityOfAMachine, AcceptsTheNamesOfTheCommandLine)
{
  for (const char* word : {"auto", "fast", "balanced", "full"}) {
    const auto choice = gui::qualityNamed(word);
    ASSERT_TRUE(choice) << word;
    EXPECT_EQ(gui::nameOf(*choice), word);
  }
  EXPECT_FALSE(gui::qualityNamed("best"));
}

}  // namespace
}  // namespace perilymph::test

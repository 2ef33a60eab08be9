// SPDX-License-Identifier: BSD-3-Clause

// Keys, wheel and mouse: the model rotates, moves and is magnified; the array only moves while
// held.

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QTest>

#include "WindowRig.h"
#include "gui/pages/insert/FrameLoop.h"
#include "gui/run/UserSettings.h"
#include "gui/shell/KeyList.h"

namespace perilymph::test {
namespace {

using haptics::Workflow;
using visualization::CameraPreset;

constexpr double atRest_mm = 0.01;

double pictureHeight_mm(WindowRig& rig)
{
  return 2.0 * rig.window().view().scene()->renderer().GetActiveCamera()->GetParallelScale();
}

bool hasGlidedTo(WindowRig& rig, CameraPreset preset)
{
  return WindowRig::waitUntil([&] { return rig.window().view().scene()->preset() == preset; });
}

class TurningKey : public ::testing::TestWithParam<Qt::Key> {};

TEST_P(TurningKey, TurnsTheModel)
{
  WindowRig rig;
  const QImage before = rig.picture();
  rig.pressKey(GetParam());
  EXPECT_NE(rig.picture(), before);
}
INSTANTIATE_TEST_SUITE_P(OfTheWindow, TurningKey,
                         ::testing::Values(Qt::Key_A, Qt::Key_D, Qt::Key_W, Qt::Key_X));

TEST(WindowKeys, ShiftAndArrowsMoveTheModelAndBack)
{
  WindowRig rig;
  const QImage before = rig.picture();
  rig.pressKey(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NE(rig.picture(), before);
  rig.pressKey(Qt::Key_Left, Qt::ShiftModifier);
  rig.pressKey(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NE(rig.picture(), before);
}

TEST(WindowKeys, PlusComesCloserAndMinusGoesBack)
{
  WindowRig rig;
  const double before_mm = pictureHeight_mm(rig);
  rig.pressKey(Qt::Key_Plus);
  EXPECT_LT(pictureHeight_mm(rig), before_mm);
  rig.pressKey(Qt::Key_Minus);
  EXPECT_NEAR(pictureHeight_mm(rig), before_mm, 1e-6 * before_mm);
}

TEST(WindowKeys, DigitsAndFChooseWhereToLookFrom)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_2);
  EXPECT_TRUE(hasGlidedTo(rig, CameraPreset::microscope));
  rig.pressKey(Qt::Key_3);
  EXPECT_TRUE(hasGlidedTo(rig, CameraPreset::overview));
  rig.pressKey(Qt::Key_4);
  EXPECT_TRUE(hasGlidedTo(rig, CameraPreset::section));
  rig.pressKey(Qt::Key_F);
  EXPECT_TRUE(hasGlidedTo(rig, CameraPreset::followTip));
  rig.pressKey(Qt::Key_1);
  EXPECT_TRUE(hasGlidedTo(rig, CameraPreset::surgeon));
}

TEST(WindowKeys, SpaceStartsAndPausesTheScriptedHand)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
  rig.pressKey(Qt::Key_Space);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
}

TEST(WindowKeys, TheQuestionMarkListsTheKeysAndEscapeClosesTheList)
{
  WindowRig rig;
  auto* list = rig.window().findChild<gui::KeyList*>();
  ASSERT_NE(list, nullptr);
  EXPECT_FALSE(list->isVisible());
  rig.pressKey(Qt::Key_Question);
  EXPECT_TRUE(list->isVisible());
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(list->isVisible());
}

TEST(WindowMouse, ADragTurnsTheModel)
{
  WindowRig rig;
  gui::OperationView& view = rig.window().view();
  const QImage before = rig.picture();
  const QPoint middle = view.rect().center();
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, middle);
  QMouseEvent move(QEvent::MouseMove, middle + QPoint(60, 0), view.mapToGlobal(middle),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 0));
  EXPECT_NE(rig.picture(), before);
}

TEST(WindowMouse, TheWheelMagnifiesWhileNoArrayIsHeld)
{
  WindowRig rig;
  const double before_mm = pictureHeight_mm(rig);
  rig.turnWheel(2);
  EXPECT_LT(pictureHeight_mm(rig), before_mm);
}

TEST(PointerDevice, MovesTheArrayWithTheWheelWhileSpaceIsDown)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  rig.holdKey(Qt::Key_Space);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::inserting; }));
  rig.turnWheel(-4);  // down is in, as with the arrow keys; 1 mm
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.9; }));
  rig.turnWheel(2);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 0.6; }));
}

TEST(PointerDevice, DoesNotMoveTheArrayUnlessItIsHeld)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::armed; }));
  rig.turnWheel(-4);
  rig.holdKey(Qt::Key_Down);
  ASSERT_TRUE(rig.runForTicks(1000));
  EXPECT_NEAR(rig.travel_mm(), 0.0, atRest_mm);
}

class PointerAtFrameRate : public ::testing::TestWithParam<int> {};

TEST_P(PointerAtFrameRate, TheDownKeyAdvancesAtTheScenariosSpeed)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  rig.window().insertPage().frames().setInterval(GetParam());
  rig.holdKey(Qt::Key_Space);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::inserting; }));
  rig.holdKey(Qt::Key_Down);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 1.0; }));
  const haptics::TickOutput before = rig.now().output;
  ASSERT_TRUE(rig.runForTicks(2000));
  const haptics::TickOutput after = rig.now().output;
  const double speed = (after.travel - before.travel) / (after.time - before.time);
  constexpr double published = 2e-3;  // [m/s]
  EXPECT_NEAR(speed, published, 0.05 * published);
}
INSTANTIATE_TEST_SUITE_P(OfFramesEachMilliseconds, PointerAtFrameRate,
                         ::testing::Values(16, 100, 1000));

TEST(PointerDevice, LetsGoWhenSpaceIsReleased)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  rig.holdKey(Qt::Key_Space);
  rig.holdKey(Qt::Key_Down);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.3; }));
  rig.releaseKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  const double held_mm = rig.travel_mm();
  ASSERT_TRUE(rig.runForTicks(1000));
  EXPECT_NEAR(rig.travel_mm(), held_mm, atRest_mm);
}

TEST(PointerDevice, CanBeHeldFromOnePressToTheNext)
{
  gui::UserSettings().setValue("hold", "toggle");
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  rig.pressKey(Qt::Key_Space);  // pressed and released
  EXPECT_TRUE(rig.window().control().isHeld());
  rig.holdKey(Qt::Key_Down);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.3; }));
  rig.releaseKey(Qt::Key_Down);
  rig.pressKey(Qt::Key_Space);
  EXPECT_FALSE(rig.window().control().isHeld());
  gui::UserSettings().remove("hold");
}

TEST(PointerDevice, LetsGoWhenTheWindowIsLeft)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  rig.holdKey(Qt::Key_Space);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::inserting; }));
  QEvent left(QEvent::WindowDeactivate);
  QCoreApplication::sendEvent(&rig.window(), &left);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
}

TEST(PointerDevice, TheHoldControlHoldsWhileItIsPressed)
{
  WindowRig rig;
  rig.click("pointerChoice");
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("holdButton").isEnabled(); }));
  QTest::mousePress(&rig.button("holdButton"), Qt::LeftButton);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::inserting; }));
  QTest::mouseRelease(&rig.button("holdButton"), Qt::LeftButton);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
}

}  // namespace
}  // namespace perilymph::test

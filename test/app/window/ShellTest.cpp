// SPDX-License-Identifier: BSD-3-Clause

// The frame around the pages: questions, notices, menu, keys where text is typed, and what a window
// that is made again keeps.

#include <gtest/gtest.h>

#include <QAction>
#include <QHelpEvent>
#include <QLabel>
#include <QTest>
#include <QToolTip>

#include "WindowRig.h"
#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/run/UserSettings.h"
#include "gui/shell/AboutOverlay.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/WindowMemory.h"
#include "gui/shell/WindowPlace.h"
#include "gui/widgets/Notice.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::test {
namespace {

TEST(Shell, AWindowMadeAgainKeepsReferenceInputUndoAndFocus)
{
  gui::WindowMemory memory;
  std::string scenario;
  {
    WindowRig rig;
    rig.click("pointerChoice");
    rig.type("panelSpeed", "1.5");
    rig.window().insertion().setReference(gui::ReferenceInsertion{
        "earlier", {}, {{millimeters(0), newtons(0)}, {millimeters(9), newtons(0.1)}}, {}});
    rig.window().findChild<QWidget*>("panelStop")->setFocus();
    memory = gui::memoryOf(rig.window());
    scenario = rig.window().control().scenario().text();
  }
  auto again = session::parseScenario(scenario, "contour-published-modified");
  ASSERT_TRUE(again) << again.error().message;
  gui::MainWindow window(*again, std::nullopt);
  gui::resume(window, memory);
  window.show();
  ASSERT_TRUE(window.open());
  EXPECT_EQ(window.control().input(), gui::InputSource::pointer);
  EXPECT_TRUE(window.setup().stack().canUndo());
  EXPECT_EQ(window.setup().stack().undoText(), "speed 1.5 mm/s");
  ASSERT_TRUE(window.views().charts()->ghost());
  EXPECT_EQ(window.views().charts()->ghost()->name, "earlier");
  EXPECT_EQ(window.focusWidget(), window.findChild<QWidget*>("panelStop"));
}

TEST(TextScale, IsWhatTheSmallestWindowNeedsToFit)
{
  EXPECT_EQ(gui::fittingTextScale(1.0, {0, 0, 1366, 738}), 1.0);
  EXPECT_EQ(gui::fittingTextScale(1.5, {0, 0, 1920, 1050}), 1.5);
  // 1366 x 768 pixels at a scale of 1.5 and 2
  for (const QRect& screen : {QRect(0, 0, 911, 492), QRect(0, 0, 683, 369)}) {
    const double scale = gui::fittingTextScale(1.0, screen);
    const QSizeF needed = scale * QSizeF(gui::preferredMinimumSize);
    EXPECT_LT(scale, 1.0);
    EXPECT_LT(needed.width(), screen.width());
    EXPECT_LT(needed.height(), screen.height() - 37);  // the title bar of GNOME
    EXPECT_EQ(gui::fittingTextScale(1.3, screen), 1.3 * scale);
  }
}

TEST(Shell, TheSheetOfKeysFitsIntoTheSmallestWindow)
{
  WindowRig rig;
  rig.window().resize(gui::preferredMinimumSize);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.window().size() == gui::preferredMinimumSize; }));
  rig.pressKey(Qt::Key_F1);
  const auto* sheet = rig.window().findChild<gui::KeyList*>();
  EXPECT_TRUE(rig.window().rect().contains(sheet->geometry()))
      << sheet->width() << " x " << sheet->height();
  for (const QLabel* label : sheet->findChildren<QLabel*>())
    EXPECT_LE(label->sizeHint().width(), label->width()) << label->text().toStdString();
}

TEST(Shell, TypedCharactersDoNotActWhereTheyAreTyped)
{
  WindowRig rig;
  auto* list = rig.window().findChild<gui::Selector*>("arraySelector");
  list->setFocus();
  QTest::keyClicks(list, "HiFocus Mid");
  EXPECT_FALSE(rig.window().findChild<gui::DevicePage*>()->isVisible());
  EXPECT_FALSE(rig.window().control().isRunning());
  rig.window().setFocus();
  rig.pressKey(Qt::Key_H);
  EXPECT_TRUE(rig.window().findChild<gui::DevicePage*>()->isVisible());
}

TEST(Shell, LettersAloneCanBeSwitchedOffAndSpaceStillActs)
{
  WindowRig rig;
  gui::UserSettings().setValue("keys", "off");
  rig.pressKey(Qt::Key_H);
  EXPECT_FALSE(rig.window().findChild<gui::DevicePage*>()->isVisible());
  rig.pressKey(Qt::Key_Space);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.1; }));
  gui::UserSettings().remove("keys");
}

TEST(Shell, ClosingDuringAnInsertionAsksFirst)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
  rig.window().close();
  EXPECT_TRUE(rig.window().isVisible());
  ASSERT_TRUE(rig.window().notice().isVisible());
  EXPECT_TRUE(rig.window().notice().sentence().contains("in progress"));
  rig.click("noticeDismissButton");
  EXPECT_TRUE(rig.window().isVisible());
  EXPECT_TRUE(rig.window().control().isRunning());
  rig.window().close();
  rig.click("noticeButton");
  EXPECT_FALSE(rig.window().isVisible());
}

TEST(Shell, TakesTheQuestionBackWhenItsInsertionHasEndedOtherwise)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
  rig.window().close();
  ASSERT_TRUE(rig.window().notice().isVisible());
  rig.click("resetButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !rig.window().notice().isVisible(); }));
}

TEST(Shell, ReplayDuringAnInsertionAsksFirst)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
  rig.window().replay("earlier.insertion");
  EXPECT_TRUE(rig.window().notice().isVisible());
  EXPECT_TRUE(rig.window().control().isRunning());
  rig.click("noticeDismissButton");
  EXPECT_TRUE(rig.window().control().isRunning());
  EXPECT_GT(rig.travel_mm(), 0.2);
}

TEST(Shell, TheMenuShowsVersionAndLicense)
{
  WindowRig rig;
  rig.window().findChild<QAction*>("aboutAction")->trigger();
  const auto* about = rig.window().findChild<gui::AboutOverlay*>();
  ASSERT_TRUE(about->isVisible());
  QString text;
  for (const QLabel* label : about->findChildren<QLabel*>()) text += label->text() + ' ';
  EXPECT_TRUE(text.contains(QString::fromStdString(buildId()))) << text.toStdString();
  EXPECT_TRUE(text.contains("BSD 3-clause"));
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(about->isVisible());
  for (const char* name : {"openAction", "exportAction", "settingsAction", "quitAction"})
    EXPECT_NE(rig.window().findChild<QAction*>(QLatin1String(name)), nullptr) << name;
}

TEST(Shell, ANoticeCoversNothing)
{
  WindowRig rig;
  rig.window().notice().offer("A recording was recovered.", "Show recordings", [] {});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().notice().height() > 20; }));
  EXPECT_FALSE(
      rig.window().notice().geometry().intersects(rig.window().insertPage().geometry().translated(
          rig.window().insertPage().mapTo(&rig.window(), QPoint(0, 0)) -
          rig.window().insertPage().pos())));
  rig.pressKey(Qt::Key_Space);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !rig.window().notice().isVisible(); }));
}

TEST(Shell, TheReadOutsExplainThemselves)
{
  WindowRig rig;
  gui::OperationView& view = rig.window().view();
  for (const char* name : {"travelReadOut", "angleReadOut", "forceReadOut", "phaseLine"}) {
    const auto* part = rig.window().findChild<QWidget*>(QLatin1String(name));
    const QPoint place = part->geometry().topLeft() + QPoint(36, 16);
    QHelpEvent help(QEvent::ToolTip, place, view.mapToGlobal(place));
    QCoreApplication::sendEvent(&view, &help);
    EXPECT_GT(QToolTip::text().size(), 20) << name;
    QToolTip::hideText();
  }
}

TEST(Shell, TextIsAsLargeAsTheSettingsSay)
{
  const auto heightOf = [](double scale) {
    gui::setTextScale(scale);
    WindowRig rig;
    int height = 0;
    for (const QLabel* label : rig.window().findChildren<QLabel*>())
      height = std::max(height, label->fontInfo().pixelSize());
    const int button = rig.button("startButton").height();
    gui::setTextScale(1.0);
    return std::pair(height, button);
  };
  const auto usual = heightOf(1.0), large = heightOf(1.5);
  EXPECT_NEAR(large.first, 1.5 * usual.first, 1.0);
  EXPECT_NEAR(large.second, 1.5 * usual.second, 1.0);
}

}  // namespace
}  // namespace perilymph::test

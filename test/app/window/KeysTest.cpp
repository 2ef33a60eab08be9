// SPDX-License-Identifier: BSD-3-Clause

// Keys of the window: the key list, full screen, screenshot, Escape, and use without a mouse.

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTest>
#include <QTextBrowser>

#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/start/PatientForm.h"
#include "gui/setup/SetupHistory.h"
#include "gui/shell/GuideOverlay.h"
#include "gui/shell/KeyActions.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/SettingsOverlay.h"
#include "gui/shell/TopBar.h"
#include "gui/shell/WindowMemory.h"
#include "gui/widgets/Notice.h"

namespace perilymph::test {
namespace {

using haptics::Workflow;

TEST(KeyActions, TheKeyListMatchesTheKeys)
{
  gui::KeyActions actions;
  int asked = -1;
  actions.add({gui::KeySection::window,
               {Qt::Key_F9, gui::with(Qt::ControlModifier, Qt::Key_K)},
               "knit",
               [&](int which) {
                 asked = which;
                 return true;
               }});
  const gui::KeyList sheet(actions, nullptr);
  QStringList said;
  for (const QLabel* label : sheet.findChildren<QLabel*>()) said << label->text();
  EXPECT_TRUE(said.contains("knit"));
  EXPECT_TRUE(said.contains("F9  Ctrl+K"));
  EXPECT_TRUE(actions.take(QKeyEvent(QEvent::KeyPress, Qt::Key_K, Qt::ControlModifier)));
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(actions.take(QKeyEvent(QEvent::KeyPress, Qt::Key_K, Qt::NoModifier)));
}

TEST(KeyActions, AKeyHeldDownRepeatsOnlyWhereThatIsMeant)
{
  gui::KeyActions actions;
  int once = 0, often = 0;
  actions.add({gui::KeySection::window, {Qt::Key_A}, "once", [&](int) { return ++once > 0; }});
  actions.add(
      {gui::KeySection::window, {Qt::Key_B}, "often", [&](int) { return ++often > 0; }, true});
  for (const bool isRepeat : {false, true, true})
    for (const Qt::Key key : {Qt::Key_A, Qt::Key_B})
      actions.take(QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier, QString(), isRepeat));
  EXPECT_EQ(once, 1);
  EXPECT_EQ(often, 3);
}

TEST(KeyActions, AQuestionMarkIsOneWithShiftAndWithout)
{
  gui::KeyActions actions;
  int asked = 0;
  actions.add({gui::KeySection::window, {Qt::Key_Question}, "what", [&](int) { return ++asked; }});
  actions.take(QKeyEvent(QEvent::KeyPress, Qt::Key_Question, Qt::ShiftModifier));
  actions.take(QKeyEvent(QEvent::KeyPress, Qt::Key_Question, Qt::NoModifier));
  EXPECT_EQ(asked, 2);
}

TEST(WindowHabits, F1ShowsTheSheetOnEveryPageAndEscapeLeavesIt)
{
  WindowRig rig;
  auto* sheet = rig.window().findChild<gui::KeyList*>();
  for (const char* page : {"start", "insert", "validate", "sessions"}) {
    rig.window().showPage(page);
    rig.pressKey(Qt::Key_F1);
    EXPECT_TRUE(sheet->isVisible());
    EXPECT_TRUE(rig.window().rect().contains(sheet->geometry()));
    rig.pressKey(Qt::Key_Escape);
    EXPECT_FALSE(sheet->isVisible());
    EXPECT_EQ(rig.window().page(), page);
  }
}

TEST(WindowHabits, EscapeClosesAListOfKeysBeforeTheFormOfAPatient)
{
  WindowRig rig;
  rig.window().showPage("start");
  rig.click("patientCard");
  rig.pressKey(Qt::Key_F1);
  auto* keys = rig.window().findChild<QWidget*>("keys");
  ASSERT_TRUE(keys->isVisible());
  const auto* form = rig.window().findChild<gui::PatientForm*>();
  QTest::keyClick(rig.window().focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(keys->isVisible());
  EXPECT_TRUE(form->isVisible());
  QTest::keyClick(rig.window().focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(form->isVisible());
}

TEST(WindowHabits, TheFormOfAPatientLeadsToThePageThatMeasuresACt)
{
  WindowRig rig;
  rig.window().showPage("start");
  rig.click("patientCard");
  rig.click("patientCtButton");
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return rig.window().findChild<gui::CtPage*>()->isVisible(); }));
}

TEST(WindowHabits, F11FillsTheScreenAndGoesBack)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_F11);
  EXPECT_TRUE(rig.window().isFullScreen());
  rig.pressKey(Qt::Key_F11);
  EXPECT_FALSE(rig.window().isFullScreen());
  rig.pressKey(Qt::Key_F11);
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(rig.window().isFullScreen());
}

TEST(WindowHabits, CtrlShiftSKeepsAPictureAndSaysWhere)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  const QString said = rig.window().notice().sentence();
  EXPECT_TRUE(rig.window().notice().isVisible());
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
  const QStringList files = folder.entryList({"perilymph-*.png"});
  ASSERT_EQ(files.size(), 1);
  EXPECT_TRUE(said.contains(folder.filePath(files[0]))) << said.toStdString();
  const QImage picture(folder.filePath(files[0]));
  EXPECT_EQ(picture.size(), rig.window().size() * rig.window().devicePixelRatioF());
}

TEST(WindowHabits, EscapePausesAnArrayThatMoves)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
  rig.pressKey(Qt::Key_Escape);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
}

TEST(WindowHabits, KeysAloneGoFromTheFirstScreenThroughAnInsertionAndBack)
{
  WindowRig rig;
  rig.window().showPage("start");
  const auto press = [](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    QTest::keyClick(focus, key, modifiers);
  };
  rig.window().activateWindow();
  ASSERT_TRUE(WindowRig::waitUntil([] { return QApplication::focusWidget() != nullptr; }));
  press(Qt::Key_3);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.3; }));
  press(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  const double paused_mm = rig.travel_mm();
  press(Qt::Key_Backspace);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 0.5 * paused_mm; }));
  press(Qt::Key_6, Qt::AltModifier);
  EXPECT_EQ(rig.window().page(), "validate");
  press(Qt::Key_Home, Qt::AltModifier);
  EXPECT_EQ(rig.window().page(), "start");
}

TEST(WindowHabits, TabReachesEveryButtonOfTheBars)
{
  WindowRig rig;
  for (const auto* bar : {rig.window().findChild<QWidget*>("startPageButton")->parentWidget(),
                          rig.window().findChild<QWidget*>("startButton")->parentWidget()})
    for (const QPushButton* button : bar->findChildren<QPushButton*>()) {
      EXPECT_NE(button->focusPolicy() & Qt::TabFocus, 0) << button->objectName().toStdString();
    }
}

TEST(WindowHabits, SpaceBelongsToTheInsertionInANewWindow)
{
  WindowRig rig;
  rig.window().activateWindow();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return QApplication::focusWidget() != nullptr; }));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(rig.window().page(), "insert");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.2; }));
}

TEST(WindowHabits, TheFocusIsVisible)
{
  WindowRig rig;
  auto* button = rig.window().findChild<QPushButton*>("resetButton");
  const QImage before = button->grab().toImage();
  rig.window().activateWindow();
  button->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return button->hasFocus(); }));
  EXPECT_NE(button->grab().toImage(), before);
}

TEST(WindowHabits, AReopenedWindowStillShowsThatItsPresetWasModified)
{
  auto preset = session::loadScenario("contour-published");
  ASSERT_TRUE(preset);
  gui::SetupHistory before(nullptr);
  before.begin({*preset, {}}, gui::SetupOrigin::Kind::preset);
  before.change(
      {gui::SetupField::speed, {{"speed_mm_s", "1.0"}}, "speed", gui::ValueSource::typed});
  ASSERT_TRUE(before.isModified());
  gui::MainWindow window(before.now().scenario, std::nullopt);
  gui::resume(window, {{before.memory(), {}, gui::InputSource::scripted, {}}, {}});
  EXPECT_TRUE(window.setup().isModified());
  EXPECT_TRUE(window.setup().stack().canUndo());
  EXPECT_EQ(window.control().scenario().text(), before.now().scenario.text());
}

TEST(WindowHabits, TheSettingsSheetOpensAndAChoiceIsKept)
{
  WindowRig rig;
  int reopenings = 0;
  QObject::connect(&rig.window(), &gui::MainWindow::reopenRequested, &rig.window(),
                   [&] { ++reopenings; });
  rig.pressKey(Qt::Key_Comma, Qt::ControlModifier);
  auto* sheet = rig.window().findChild<gui::SettingsOverlay*>();
  ASSERT_TRUE(sheet->isVisible());
  rig.click("look-light");
  EXPECT_EQ(reopenings, 1);
  rig.click("look-dark");
  EXPECT_EQ(reopenings, 2);
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(sheet->isVisible());
}

TEST(WindowHabits, TheGuideOpensFromTheSheetAndItsPagesFollowTheirLinks)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_F1);
  rig.click("guideButton");
  auto& sheet = *rig.window().findChild<gui::GuideOverlay*>();
  auto& page = *rig.window().findChild<QTextBrowser*>("guidePage");
  ASSERT_TRUE(sheet.isVisible());
  EXPECT_TRUE(rig.window().rect().contains(sheet.geometry()));
  EXPECT_TRUE(page.toPlainText().contains("Five tutorials"));
  page.setSource(page.source().resolved(QUrl("surgeon.md")));
  EXPECT_TRUE(page.toPlainText().contains("Enter the measurements"));
  EXPECT_LE(page.document()->size().width(), page.viewport()->width());
  rig.click("guideBackButton");
  EXPECT_TRUE(page.toPlainText().contains("Five tutorials"));
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(sheet.isVisible());
  rig.pressKey(Qt::Key_F1, Qt::ShiftModifier);
  EXPECT_TRUE(sheet.isVisible());
}

}  // namespace
}  // namespace perilymph::test

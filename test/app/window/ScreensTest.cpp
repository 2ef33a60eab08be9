// SPDX-License-Identifier: BSD-3-Clause

// The first window of a user who has no settings yet, on the screen and under the window manager
// that test/support/with-display provides.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QTest>
#include <QWindow>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "gui/pages/start/StartPage.h"
#include "gui/program/Languages.h"
#include "gui/run/UserSettings.h"
#include "gui/shell/Help.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/OverlayStack.h"
#include "gui/shell/WindowPlace.h"
#include "gui/widgets/Theme.h"

namespace perilymph::test {
namespace {

constexpr int patience_ms = 60'000;

/// The screen without panels. Qt rounds each margin of a frame up to a whole logical pixel.
QRect availableScreen()
{
  return QGuiApplication::primaryScreen()->availableGeometry().adjusted(-1, -1, 1, 1);
}

bool liesInScrollArea(const QWidget& widget)
{
  for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget())
    if (qobject_cast<const QScrollArea*>(at) != nullptr) return true;
  return false;
}

QRect onScreen(const QWidget& widget) { return {widget.mapToGlobal(QPoint(0, 0)), widget.size()}; }

/// The first window, shown at its first size.
struct FirstWindowRig {
  FirstWindowRig()
  {
    gui::UserSettings().clear();
    // as the program does; what a case has chosen is more than 1
    if (gui::textScale() <= 1.0)
      gui::setTextScale(
          gui::fittingTextScale(1.0, QGuiApplication::primaryScreen()->availableGeometry()));
    auto scenario = session::loadScenario("contour-published");
    if (!scenario) throw std::runtime_error(scenario.error().message);
    window = std::make_unique<gui::MainWindow>(*std::move(scenario), std::nullopt);
    gui::restorePlace(*window);
    bool isDrawn = false;
    QObject::connect(window.get(), &gui::MainWindow::firstFrameShown, window.get(),
                     [&] { isDrawn = true; });
    window->show();
    const auto opened = window->open();
    if (!opened) throw std::runtime_error(opened.error().message);
    const bool isReady = QTest::qWaitFor(
        [&] { return isDrawn && window->windowHandle()->frameMargins().top() > 0; }, patience_ms);
    if (!isReady) throw std::runtime_error("The window got neither frame nor picture.");
  }

  std::unique_ptr<gui::MainWindow> window;
};

struct FirstWindow : ::testing::Test, FirstWindowRig {};

TEST_F(FirstWindow, LiesWithItsFrameInTheScreen)
{
  EXPECT_TRUE(QTest::qWaitFor([&] { return availableScreen().contains(window->frameGeometry()); },
                              patience_ms))
      << window->frameGeometry().width() << " x " << window->frameGeometry().height() << " in "
      << availableScreen().width() << " x " << availableScreen().height();
}

TEST_F(FirstWindow, ShowsEveryControlOfTheInsertionPage)
{
  ASSERT_TRUE(QTest::qWaitFor([&] { return availableScreen().contains(window->frameGeometry()); },
                              patience_ms));
  int controls = 0;
  for (const QWidget* widget : window->findChildren<QWidget*>()) {
    const bool isControl = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                           qobject_cast<const QLineEdit*>(widget) != nullptr ||
                           qobject_cast<const QComboBox*>(widget) != nullptr ||
                           qobject_cast<const QLabel*>(widget) != nullptr;
    if (!isControl || !widget->isVisible() || liesInScrollArea(*widget)) continue;
    ++controls;
    const QRect place = onScreen(*widget);
    EXPECT_TRUE(onScreen(*window).contains(place) && availableScreen().contains(place))
        << widget->objectName().toStdString() << " at " << place.x() << ", " << place.y() << ", "
        << place.width() << " x " << place.height();
  }
  EXPECT_GT(controls, 12);
}

TEST_F(FirstWindow, StaysInTheScreenAtItsMinimumSize)
{
  window->showNormal();
  window->resize(window->minimumSize());
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return window->frameGeometry().size().boundedTo(availableScreen().size()) ==
               window->frameGeometry().size();
      },
      patience_ms));
}

TEST_F(FirstWindow, CutsNoTextOfAnyPage)
{
  for (const gui::Page* page : window->pages().all()) {
    window->showPage(*page);
    EXPECT_TRUE(QTest::qWaitFor([&] { return cutTextsOf(*window).empty(); }, patience_ms / 10));
    keepPicture(*window, "first-" + page->id().toStdString());
    for (const std::string& text : cutTextsOf(*window))
      ADD_FAILURE() << page->id().toStdString() << ": " << text;
  }
}

class AWindowWithTextOf150Percent : public testing::TestWithParam<const char*> {
protected:
  void SetUp() override
  {
    gui::setTextScale(1.5);
    gui::useLanguage(*QCoreApplication::instance(), GetParam());
  }
  void TearDown() override
  {
    gui::useLanguage(*QCoreApplication::instance(), "en");
    gui::setTextScale(1.0);
  }
  static void expectWhole(QWidget& window, const std::string& name)
  {
    // measures of the cochlea come late, and nested layouts take some turns
    EXPECT_TRUE(QTest::qWaitFor([&] { return cutTextsOf(window).empty(); }, patience_ms)) << name;
    keepPicture(window, name + "-" + GetParam());
    for (const std::string& text : cutTextsOf(window)) ADD_FAILURE() << name << ": " << text;
  }
};

TEST_P(AWindowWithTextOf150Percent, CutsNoText)
{
  constexpr int fewestPixels = 1200;  // across, independent of the device's: 800 at 100 %
  if (availableScreen().width() < fewestPixels)
    GTEST_SKIP() << "A screen of " << availableScreen().width()
                 << " pixels is too small for text of 150 %.";
  FirstWindowRig rig;
  gui::MainWindow& window = *rig.window;
  for (const gui::Page* page : window.pages().all()) {
    window.showPage(*page);
    expectWhole(window, page->id().toStdString());
  }
  auto& start = *window.findChild<gui::StartPage*>();
  window.showPage("start");
  start.showNewPatient();
  expectWhole(window, "patient");
  start.showPatients();
  expectWhole(window, "patients");
  window.showPage("insert");
  window.sheets().toggleSettings();
  expectWhole(window, "settings");
  window.sheets().leave();
  window.sheets().toggleDevices();
  expectWhole(window, "devices");
  window.sheets().leave();
  window.sheets().toggleAbout();
  expectWhole(window, "about");
  window.sheets().leave();
  window.sheets().help().toggleKeys();
  expectWhole(window, "keys");
}

INSTANTIATE_TEST_SUITE_P(Language, AWindowWithTextOf150Percent, testing::Values("en", "de"),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace perilymph::test

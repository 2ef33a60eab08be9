// SPDX-License-Identifier: BSD-3-Clause

// The first window of a user who has no settings yet, on the screen and under the window manager
// that test/support/with-display provides.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QTest>
#include <QWindow>

#include "gui/parts/UserSettings.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/WindowPlace.h"

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

struct FirstWindow : ::testing::Test {
  FirstWindow()
  {
    gui::UserSettings().clear();
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

}  // namespace
}  // namespace perilymph::test

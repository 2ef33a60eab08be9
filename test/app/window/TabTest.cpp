// SPDX-License-Identifier: BSD-3-Clause

// The Tab key: its order, and the ring around the widget with the focus.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QTest>
#include <algorithm>
#include <vector>

#include "Contrast.h"
#include "WindowRig.h"
#include "gui/shell/TopBar.h"
#include "gui/widgets/Theme.h"

namespace perilymph::test {
namespace {

/// The pixels whose color differs by a contrast of 3:1 or more between two pictures.
struct RingPixels {
  QRect frame;     ///< Their bounding rectangle.
  int count = 0;   ///< All of them.
  int inside = 0;  ///< Those more than 8 px from the frame's edges.
};

RingPixels ringOf(const QImage& focused, const QImage& unfocused)
{
  RingPixels ring;
  const auto isRing = [&](int x, int y) {
    return contrast(focused.pixelColor(x, y), unfocused.pixelColor(x, y)) >= 3.0;
  };
  for (int y = 0; y < focused.height(); ++y)
    for (int x = 0; x < focused.width(); ++x) {
      if (!isRing(x, y)) continue;
      ring.frame = ring.frame.united(QRect(x, y, 1, 1));
      ++ring.count;
    }
  const QRect middle = ring.frame.adjusted(8, 8, -8, -8);
  for (int y = middle.top(); y <= middle.bottom(); ++y)
    for (int x = middle.left(); x <= middle.right(); ++x) ring.inside += isRing(x, y) ? 1 : 0;
  return ring;
}

std::string nameOf(const QWidget* stop)
{
  return std::string(stop->metaObject()->className()) + " " + stop->objectName().toStdString();
}

/// Presses Tab from the window until a stop comes again; calls `atStop` at each of them.
std::vector<QWidget*> walkTab(WindowRig& rig, const std::function<void(QWidget*)>& atStop)
{
  rig.window().activateWindow();
  if (!WindowRig::waitUntil([] { return QApplication::focusWidget() != nullptr; })) return {};
  rig.window().setFocus();
  std::vector<QWidget*> stops;
  for (int i = 0; i < 200; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    if (std::find(stops.begin(), stops.end(), now) != stops.end()) break;
    stops.push_back(now);
    if (atStop) atStop(now);
  }
  return stops;
}

TEST(TabKey, GoesThroughThePageThenTheBarWithTheLinksToPagesLast)
{
  WindowRig rig;
  for (const gui::Page* page : rig.window().pages().all()) {
    rig.window().showPage(*page);
    QStringList stops;
    for (const QWidget* stop : walkTab(rig, {})) stops << stop->objectName();
    const QStringList bar{"startPageButton",    "keysButton",         "settingsButton",
                          "menuButton",         "ctPageButton",       "planPageButton",
                          "insertPageButton",   "outcomePageButton",  "comparePageButton",
                          "validatePageButton", "sessionsPageButton", "studiesPageButton",
                          "outcomesPageButton"};
    ASSERT_GT(stops.size(), bar.size()) << page->id().toStdString();
    EXPECT_EQ(stops.mid(stops.size() - bar.size()), bar) << stops.join(' ').toStdString();
  }
}

class FocusRing : public ::testing::TestWithParam<gui::ColorScheme> {
protected:
  void SetUp() override { gui::setShownColorScheme(GetParam()); }
  void TearDown() override { gui::setShownColorScheme(gui::ColorScheme::dark); }
};

TEST_P(FocusRing, SurroundsEveryStopOfTabWithAContrastOfThree)
{
  WindowRig rig;
  for (const gui::Page* page : rig.window().pages().all()) {
    rig.window().showPage(*page);
    std::vector<QImage> pictures;
    const auto stops =
        walkTab(rig, [&pictures](QWidget* stop) { pictures.push_back(stop->grab().toImage()); });
    rig.window().setFocus();
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const RingPixels ring = ringOf(pictures[i], stops[i]->grab().toImage());
      const int around = 2 * (ring.frame.width() + ring.frame.height());
      EXPECT_GE(ring.frame.height(), 16) << nameOf(stops[i]);
      EXPECT_GE(ring.count, 0.8 * around) << nameOf(stops[i]);
      if (qobject_cast<QAbstractButton*>(stops[i]) != nullptr) {
        EXPECT_EQ(ring.inside, 0) << nameOf(stops[i]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothColorSchemes, FocusRing,
                         ::testing::Values(gui::ColorScheme::dark, gui::ColorScheme::light));

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// The three tutorials of the user guide, step by step: a surgeon with a patient's measures, a
// clinician who compares techniques, a visitor at a booth.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QIcon>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <algorithm>

#include "OwnFolders.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/kiosk/KioskWindow.h"
#include "gui/kiosk/SpeedPad.h"
#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/sessions/SessionsPage.h"

namespace perilymph::test {
namespace {

/// A temporary folder for the output of a tutorial.
class AWalk : public testing::Test {
protected:
  static bool canStart(WindowRig& rig)
  {
    return WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); });
  }
  /// The array is at full depth, and the window shows it.
  static bool isThere(WindowRig& rig)
  {
    return WindowRig::waitUntil([&] {
      return rig.now().output.workflow == haptics::Workflow::finished &&
             rig.button("startButton").text() == "Start";
    });
  }
  /// All measures of the shown cochlea are shown.
  static bool isComputed(WindowRig& rig)
  {
    return WindowRig::waitUntil([&] {
      const auto labels = rig.window().findChildren<QLabel*>();
      return std::none_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text() == "computing…";
      });
    });
  }
  /// Every row of the library shows its picture.
  static bool picturesCome(const QTableView& list)
  {
    const auto isPainted = [&list](int row) {
      const QVariant icon = list.model()->index(row, 0).data(Qt::DecorationRole);
      const QImage picture = icon.value<QIcon>().pixmap(list.iconSize()).toImage();
      return !picture.isNull() && picture.pixelColor(picture.rect().center()).alpha() > 0;
    };
    return WindowRig::waitUntil([&] {
      for (int row = 0; row < list.model()->rowCount(); ++row)
        if (!isPainted(row)) return false;
      return true;
    });
  }

  DataFolder data_;
};

TEST_F(AWalk, OfASurgeonEndsAtFullDepthOfThePatientsCochlea)
{
  Walk walk("surgeon");
  WindowRig rig;
  rig.window().showPage("start");
  walk.step(1, rig.window());

  rig.click("patientCard");
  for (const auto& [field, text] : {std::pair{"patientName", "P-014"}, std::pair{"aValue", "9.0"},
                                    std::pair{"bValue", "6.6"}}) {
    auto* line = rig.window().findChild<QLineEdit*>(QLatin1String(field));
    line->selectAll();
    QTest::keyClicks(line, QLatin1String(text));
  }
  rig.click("leftEar");
  ASSERT_TRUE(isComputed(rig));
  walk.step(2, rig.window());

  rig.click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.window().control().scenario().patient().label == "P-014"; }));
  rig.choose("arraySelector", "slim-straight");
  ASSERT_TRUE(canStart(rig));
  ASSERT_TRUE(isComputed(rig));
  walk.step(3, rig.window());

  rig.click("pointerChoice");
  rig.window().setFocus();
  rig.holdKey(Qt::Key_Space);
  rig.holdKey(Qt::Key_Down);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 13.0; }));
  walk.step(4, rig.window());

  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().control().isAtDepth(); }));
  rig.releaseKey(Qt::Key_Down);
  rig.releaseKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.label("hintLabel").contains("Full depth"); }));
  const auto& card = *rig.window().findChild<gui::ResultCard*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return card.isVisible(); }));
  walk.step(5, rig.window());
  EXPECT_EQ(rig.window().control().scenario().patient().basalTurn->a, millimeters(9.0));
  EXPECT_EQ(walk.left(), "");
}

TEST_F(AWalk, OfAClinicianSetsTwoTechniquesSideBySide)
{
  Walk walk("clinician");
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(isThere(rig));
  walk.step(1, rig.window());

  rig.click("resetButton");
  rig.choose("techniqueSelector", "aos");
  ASSERT_TRUE(canStart(rig));
  rig.click("startButton");
  ASSERT_TRUE(isThere(rig));
  rig.click("resetButton");
  rig.click("sessionsPageButton");
  auto& list = *rig.window().findChild<QTableView*>("sessionList");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return list.model()->rowCount() == 2; }));
  ASSERT_TRUE(picturesCome(list));
  list.setFocus();
  QTest::keyClick(&list, Qt::Key_A, Qt::ControlModifier);
  walk.step(2, rig.window());

  rig.click("compareButton");
  auto& page = *rig.window().findChild<gui::ComparePage*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.runs().size() == 2; }));
  auto& plot = *rig.window().findChild<gui::ComparisonPlot*>();
  QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier,
                    QPoint(plot.width() * 2 / 3, plot.height() / 2));
  walk.step(3, rig.window());

  rig.click("sessionsPageButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return !rig.window().findChild<gui::SessionsPage*>()->isBusy(); }));
  list.selectRow(1);
  rig.click("ghostButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.label("sessionStatus").contains("reference"); }));
  rig.click("insertPageButton");
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 12.0; }));
  walk.step(4, rig.window());
  EXPECT_EQ(walk.left(), "");
}

TEST_F(AWalk, OfAVisitorEndsOnTheBoardOfTheDay)
{
  Walk walk("visitor");
  auto scenario = session::loadScenario("booth");
  ASSERT_TRUE(scenario) << scenario.error().message;
  gui::KioskWindow window(*scenario, data_.path() / "board.txt");
  window.show();
  ASSERT_TRUE(window.open());
  const auto travel_mm = [&window] {
    return inMillimeters(Length::fromSi(window.control().now().output.travel));
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 10.0; }));
  walk.step(1, window);

  QTest::mouseClick(window.findChild<QAbstractButton*>("inviteButton"), Qt::LeftButton);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return window.stage() == gui::KioskStage::turn; }));
  auto& pad = *window.findChild<gui::SpeedPad*>();
  QTest::mousePress(&pad, Qt::LeftButton, {}, QPoint(pad.width() / 12, pad.height() / 2));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 11.0; }));
  walk.step(2, window);

  ASSERT_TRUE(WindowRig::waitUntil([&] { return window.stage() == gui::KioskStage::result; }));
  walk.step(3, window);
  EXPECT_EQ(walk.left(), "");
}

}  // namespace
}  // namespace perilymph::test

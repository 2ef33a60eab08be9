// SPDX-License-Identifier: BSD-3-Clause

// A translocation as a clinician meets it: in the replay, and beside another insertion.

#include <gtest/gtest.h>

#include <QTableWidget>
#include <algorithm>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/scene/ForceLabel.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/ContourFromBelow.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

void record(const std::filesystem::path& file, const session::Overrides& overrides)
{
  const auto scenario = session::loadScenario("surgery-flex28", overrides);
  ASSERT_TRUE(scenario) << scenario.error().message;
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      file);
  ASSERT_TRUE(insertion) << insertion.error().message;
  ASSERT_TRUE((*insertion)->runToEnd([](const haptics::TickRecord&) { return true; }, 40'000));
  ASSERT_TRUE((*insertion)->closeRecording());
}

class ATranslocation : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    folder_ = std::make_unique<TemporaryFolder>();
    record(through(), contourFromBelow());
    record(held(), contourFromBelow("0"));
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::filesystem::path through() { return *folder_ / "through.insertion"; }
  static std::filesystem::path held() { return *folder_ / "held.insertion"; }

  static std::unique_ptr<TemporaryFolder> folder_;
  DataFolder data_;
};

std::unique_ptr<TemporaryFolder> ATranslocation::folder_;

TEST_F(ATranslocation, IsComparedWithAnInsertionInWhichThePartitionHeld)
{
  WindowRig rig;
  auto& page = *rig.window().findChild<gui::ComparePage*>();
  rig.click("comparePageButton");
  page.compare({through(), held()});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.runs().size() == 2; }));
  const auto& table = *rig.window().findChild<QTableWidget*>("comparisonTable");
  int column = 0;
  while (column < table.columnCount() &&
         table.horizontalHeaderItem(column)->text() != "Translocation")
    ++column;
  ASSERT_LT(column, table.columnCount());
  EXPECT_FALSE(table.isColumnHidden(column));
  ASSERT_TRUE(page.runs()[0].translocation);
  EXPECT_EQ(table.item(0, column)->text().toStdString(), "7.3 mm");
  EXPECT_EQ(table.item(1, column)->text(), "–");
  keepPicture(rig.window(), "translocation-compare");

  page.compare({held(), held()});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.runs()[0].translocation; }));
  EXPECT_TRUE(table.isColumnHidden(column));
}

TEST_F(ATranslocation, IsSeenInEveryViewOfItsReplay)
{
  WindowRig rig;
  rig.window().replay(through());
  const auto& replay = rig.window().insertion().replay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return replay.isOpen(); }));
  auto& player = rig.window().insertion().replay();
  player.pause();
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    player.seek(replay.playback().ticks() - 1);  // as far as it is computed
    return replay.now().isAbove.any();
  }));
  rig.pressKey(Qt::Key_L);
  const QString known = QStringLiteral("translocation: partition ruptured at 57° by 42 mN");
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig.window().findChild<gui::ForceLabel*>()->accessibleName().contains(known);
  }));
  auto* line = rig.window().findChild<gui::Scrubber*>();
  const auto mark = std::ranges::find_if(line->marks(), [](const gui::ReplayMark& each) {
    return each.text.contains("rupture of the partition");
  });
  ASSERT_NE(mark, line->marks().end());
  EXPECT_TRUE(mark->isAlarm);
  QStringList texts;
  for (const gui::ReplayMark& each : line->marks()) texts << each.text.section(": ", 1);
  EXPECT_TRUE(texts.contains("translocation")) << texts.join(", ").toStdString();
  EXPECT_TRUE(texts.contains("peak insertion force"));
  int turns = 0;  // of the event loop: the picture that was due is shown
  ASSERT_TRUE(WindowRig::waitUntil([&] { return ++turns > 20; }));
  keepPicture(rig.window(), "translocation-replay");
}

}  // namespace
}  // namespace perilymph::test

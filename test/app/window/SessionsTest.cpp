// SPDX-License-Identifier: BSD-3-Clause

// The library of recordings and their replay in the real window.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <future>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/sessions/SessionTable.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/pages/sessions/Thumbnails.h"
#include "gui/widgets/Notice.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Recording.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// A recording of a short insertion, made without a window.
fs::path record(const std::string& name, const session::Overrides& more = {})
{
  session::Overrides overrides = {{"nodes", "40"}, {"stop_travel_mm", "1.0"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  const auto scenario = session::loadScenario("contour-published", overrides);
  EXPECT_TRUE(scenario);
  fs::create_directories(sessionFolder());
  const fs::path file = sessionFolder() / (name + ".insertion");
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      file);
  EXPECT_TRUE(insertion) << insertion.error().message;
  EXPECT_TRUE((*insertion)->runToEnd(nullptr));
  return file;
}

/// A window with an initially empty library.
class Sessions : public testing::Test {
protected:
  void openLibrary()
  {
    rig_ = std::make_unique<WindowRig>();
    rig_->click("sessionsPageButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }));
  }
  gui::SessionsPage& page() { return *rig_->window().findChild<gui::SessionsPage*>(); }
  QTableView& list() { return *rig_->window().findChild<QTableView*>("sessionList"); }
  int rows() { return list().model()->rowCount(); }
  void choose(int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    const QRect place = list().visualRect(list().model()->index(row, 2));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, modifiers, place.center());
  }
  bool replayBarIsShown() { return rig_->window().findChild<gui::ReplayBar*>()->isVisible(); }
  /// Types another name for the chosen recording.
  void rename(const char* name)
  {
    rig_->click("renameButton");
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
  }
  std::uint64_t replayedTick()
  {
    // "1.222 of 3.000 s" in ticks of a millisecond
    const double seconds = rig_->label("replayTime").section(QLatin1Char(' '), 0, 0).toDouble();
    return std::uint64_t(std::lround(1e3 * seconds));
  }

  DataFolder data_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(Sessions, ExplainThePageWithoutRecordings)
{
  openLibrary();
  EXPECT_EQ(rows(), 0);
  EXPECT_FALSE(list().isVisible());
  EXPECT_FALSE(rig_->button("replayButton").isEnabled());
}

/// Several recordings of one insertion as separate files.
void recordMany(int number)
{
  const fs::path first = record("20260101T000000Z");
  for (int i = 1; i < number; ++i) {
    char name[48];
    std::snprintf(name, sizeof name, "20260102T%06dZ.insertion", i);
    fs::create_hard_link(first, sessionFolder() / name);
  }
}

std::size_t picturesKept()
{
  std::size_t kept = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(session::libraryCache(sessionFolder()), ignored))
    kept += entry.path().extension() == ".png" ? 1 : 0;
  return kept;
}

TEST_F(Sessions, OfThousandsAreDrawnWhereVisible)
{
  recordMany(2000);
  openLibrary();
  ASSERT_EQ(rows(), 2000);
  EXPECT_TRUE(rig_->label("sessionCount").contains("2000"));
  // a jump to the end requests the last pictures, not those between
  list().scrollToBottom();
  const QRect last = list().visualRect(list().model()->index(rows() - 1, gui::SessionTable::name));
  EXPECT_TRUE(list().viewport()->rect().intersects(last));
  ASSERT_TRUE(WindowRig::waitUntil([] { return picturesKept() > 0; }));
  const int seen = list().viewport()->height() / list().rowHeight(0) + 2;
  EXPECT_LE(picturesKept(), std::size_t(2 * seen) + gui::Thumbnails::maxRequests);
  rig_->window().findChild<QLineEdit*>("sessionSearch")->setText("001999");
  EXPECT_EQ(rows(), 1);
}

TEST_F(Sessions, CanBeCanceledWhileTheyAreReadAndAreListedUpToThere)
{
  recordMany(2000);
  rig_ = std::make_unique<WindowRig>();
  rig_->click("sessionsPageButton");
  ASSERT_TRUE(page().isBusy());
  rig_->window().findChild<gui::SessionsPage*>()->setFocus();
  QTest::keyClick(&page(), Qt::Key_Escape);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }));
  EXPECT_LT(rows(), 2000);
  EXPECT_TRUE(rig_->label("sessionStatus").contains("Canceled:"))
      << rows() << " rows: " << rig_->label("sessionStatus").toStdString();
  // nothing is lost: reading continues when the page is opened again
  rig_->click("insertPageButton");
  rig_->click("sessionsPageButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rows() == 2000; }));
}

TEST_F(Sessions, HoldTheInsertionThatRanInThisWindow)
{
  openLibrary();
  rig_->click("insertPageButton");
  rig_->click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.5; }));
  rig_->click("resetButton");
  rig_->click("sessionsPageButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rows() == 1; }));
}

TEST_F(Sessions, AreFoundByTyping)
{
  record("first");
  record("second", {{"side", "left"}});
  openLibrary();
  ASSERT_EQ(rows(), 2);
  QTest::keyClicks(rig_->window().findChild<QLineEdit*>("sessionSearch"), "left");
  EXPECT_EQ(rows(), 1);
  EXPECT_TRUE(rig_->label("sessionCount").contains("1 of 2"));
}

TEST_F(Sessions, ThatCannotBeReadAreListedWithASentence)
{
  fs::create_directories(sessionFolder());
  std::ofstream(sessionFolder() / "letter.insertion") << "Dear colleague,";
  openLibrary();
  ASSERT_EQ(rows(), 1);
  choose(0);
  EXPECT_TRUE(rig_->label("sessionStatus").contains("is not a recording"))
      << rig_->label("sessionStatus").toStdString();
  EXPECT_FALSE(rig_->button("replayButton").isEnabled());
}

/// A recording of which the program was killed before the array moved: no tick, not closed.
fs::path recordNothing(const std::string& name)
{
  const fs::path file = sessionFolder() / (name + ".insertion");
  const auto scenario = session::loadScenario("contour-published");
  EXPECT_TRUE(scenario);
  session::RecordingFacts facts;
  facts.scenarioName = "contour-published";
  facts.scenarioText = scenario->text();
  facts.startedUtc = "2031-01-02T03:04:05Z";
  fs::create_directories(sessionFolder());
  const fs::path whole = file.string() + ".begun";
  {
    auto recording = session::Recording::create(whole, facts);
    EXPECT_TRUE(recording) << recording.error().message;
    // what a kill leaves on the disk
    for (const char* tail : {"-wal", ""})
      if (fs::exists(whole.string() + tail))
        fs::copy_file(whole.string() + tail, file.string() + tail);
  }
  fs::remove(whole);
  return file;
}

TEST_F(Sessions, OfNoInsertionAreMarkedSayWhyAndCanBeDeleted)
{
  const fs::path empty = recordNothing("20310102T030405Z-contour-published");
  record("20100102T030405Z-done");
  openLibrary();
  keepPicture(rig_->window(), "sessions-empty");
  ASSERT_EQ(rows(), 2);  // the newest first
  EXPECT_EQ(list().model()->index(0, gui::SessionTable::outcome).data().toString(), "empty");
  choose(0);
  EXPECT_TRUE(rig_->label("sessionStatus").contains("ended before the insertion began"))
      << rig_->label("sessionStatus").toStdString();
  EXPECT_FALSE(rig_->button("replayButton").isEnabled());
  const QPoint place = list().visualRect(list().model()->index(0, 2)).center();
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, place);
  EXPECT_EQ(rig_->window().page(), "sessions");
  EXPECT_TRUE(rig_->label("sessionStatus").contains("ended before the insertion began"));
  choose(1, Qt::ControlModifier);
  EXPECT_FALSE(rig_->button("compareButton").isEnabled());
  EXPECT_TRUE(rig_->label("sessionStatus").contains("Only insertions can be compared"));
  choose(0);
  rig_->click("deleteButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy() && rows() == 1; }));
  EXPECT_FALSE(fs::exists(empty));
}

TEST_F(Sessions, OfNoInsertionAreNotAmongTheLastInsertions)
{
  recordNothing("20310102T030405Z-contour-published");
  record("20100102T030405Z-done");
  rig_ = std::make_unique<WindowRig>();
  rig_->window().showPage("start");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().findChild<QAbstractButton*>("recentRecording0") != nullptr; }));
  EXPECT_TRUE(rig_->button("recentRecording0").text().startsWith("Replay done"));
  EXPECT_EQ(rig_->window().findChild<QAbstractButton*>("recentRecording1"), nullptr);
}

TEST_F(Sessions, ThatCannotBeReplayedSayWhyOnThePageOfTheClick)
{
  const fs::path file = record("20100102T030405Z-done");
  rig_ = std::make_unique<WindowRig>();
  rig_->window().showPage("start");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().findChild<QAbstractButton*>("recentRecording0") != nullptr; }));
  fs::remove(file);
  rig_->click("recentRecording0");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->window().notice().isVisible(); }));
  EXPECT_TRUE(rig_->window().notice().sentence().contains("20100102T030405Z-done"));
  EXPECT_EQ(rig_->window().page(), "start");
}

TEST_F(Sessions, AreListedWhileAnotherOneBlocksItsReader)
{
  std::promise<void> end;
  WindowRig rig;
  gui::SessionsPage page(rig.window().control(), nullptr,
                         [ended = end.get_future().share()](
                             const auto&, const auto&, const auto& progress, const auto& listed,
                             const auto&) -> Result<std::vector<session::SessionSummary>> {
                           session::SessionSummary good;
                           good.file = "good.insertion";
                           good.highlights.duration = 1.0;
                           progress(0, 2);
                           listed(good);
                           ended.wait();
                           return std::vector{good};
                         });
  page.show();
  page.onShown();
  auto* list = page.findChild<QTableView*>("sessionList");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return list->model()->rowCount() == 1; }));
  EXPECT_TRUE(page.isBusy());
  EXPECT_TRUE(list->isVisible());
  list->selectRow(0);
  EXPECT_TRUE(page.findChild<QAbstractButton*>("replayButton")->isEnabled());
  end.set_value();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
}

TEST_F(Sessions, ThatWereDeletedAreRestored)
{
  const fs::path file = record("first");
  openLibrary();
  choose(0);
  QTest::keyClick(&list(), Qt::Key_Delete);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rows() == 0; }));
  EXPECT_FALSE(fs::exists(file));
  rig_->click("undoDeleteButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rows() == 1; }));
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(Sessions, AreRenamed)
{
  record("first");
  openLibrary();
  choose(0);
  rename("tuesday");
  if (HasFatalFailure()) return;
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return fs::exists(sessionFolder() / "tuesday.insertion"); }));
}

TEST_F(Sessions, KeepTheTypedTextWhereANameIsRefused)
{
  record("first");
  openLibrary();
  choose(0);
  rename("a/b");
  if (HasFatalFailure()) return;
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->label("sessionStatus").contains("a/b"); }));
  auto* editor = list().viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  EXPECT_EQ(editor->text(), "a/b");
  QTest::keyClick(editor, Qt::Key_Backspace);
  QTest::keyClick(editor, Qt::Key_Backspace);
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return fs::exists(sessionFolder() / "a.insertion"); }));
}

TEST_F(Sessions, AreReadAgainByTheirOwnTab)
{
  record("first");
  openLibrary();
  ASSERT_EQ(rows(), 1);
  record("second");
  rig_->click("sessionsPageButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rows() == 2; }));
}

TEST_F(Sessions, SayHowEachInsertionEnded)
{
  record("20260101T000000Z-complete");
  record("20260102T000000Z-resisted", {{"stop_travel_mm", "10.0"}, {"stop_force_N", "0.02"}});
  openLibrary();
  QStringList outcomes;  // the newest first
  for (int row = 0; row < rows(); ++row)
    outcomes << list().model()->index(row, gui::SessionTable::outcome).data().toString();
  EXPECT_EQ(outcomes, QStringList({"resistance", "stop reached"}));
}

TEST_F(Sessions, ShowEarTechniqueAndNameWholeInTheSmallestWindow)
{
  using Column = gui::SessionTable::Column;
  record("20261122T014506Z-P-017", {{"side", "left"}, {"technique", "aos"}});
  openLibrary();
  rig_->window().resize(rig_->window().minimumSize());
  const auto isWhole = [&](int column) {
    const QString text = list().model()->index(0, column).data().toString();
    constexpr int padding_px = 24;  // of the style sheet and around texts, both sides
    return list().fontMetrics().horizontalAdvance(text) + padding_px <= list().columnWidth(column);
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return list().width() < 1024; }));
  for (const auto& [column, text] :
       {std::pair{Column::ear, "left"}, std::pair{Column::technique, "Advance off-stylet"},
        std::pair{Column::name, "P-017"}}) {
    EXPECT_EQ(list().model()->index(0, column).data().toString(), text);
    EXPECT_TRUE(isWhole(column)) << text;
  }
  for (const int column : {Column::recorded, Column::outcome, Column::angle, Column::peak})
    EXPECT_TRUE(isWhole(column)) << column;
  EXPECT_FALSE(list().horizontalScrollBar()->isVisible());
  const auto header = [&](int column) {
    return list().model()->headerData(column, Qt::Horizontal).toString();
  };
  EXPECT_EQ(header(Column::recorded), QString::fromUtf8("Recorded ↓"));  // the newest first
  EXPECT_EQ(header(Column::ear), "Ear");
}

TEST_F(Sessions, LeaveKeysWithAltToTheWindow)
{
  record("first");
  openLibrary();
  choose(0);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Home, Qt::AltModifier);
  EXPECT_EQ(rig_->window().page(), "start");
}

class AReplay : public Sessions {
protected:
  void openReplay()
  {
    file_ = record("first");
    openLibrary();
    choose(0);
    rig_->click("replayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return replayBarIsShown(); }));
  }

  gui::ReplayPlayer& replay() { return rig_->window().insertion().replay(); }

  fs::path file_;
};

TEST_F(AReplay, PlaysToItsEndAndSaysThatItsBitsAgree)
{
  openReplay();
  EXPECT_EQ(rig_->window().page(), "insert");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig_->label("replayStatus").contains("identical replay");
  })) << rig_->label("replayStatus").toStdString();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->readOut("travelReadOut") == "1.0"; }))
      << rig_->readOut("travelReadOut").toStdString();
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return rig_->button("replayPlayButton").text() == "Play"; }));
}

TEST_F(AReplay, ShowsItsWholeVerdictInANarrowWindow)
{
  openReplay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return replay().isChecked(); }));
  auto& status = *rig_->window().findChild<QLabel*>("replayStatus");
  for (const int width : {1024, 1280, 1366}) {
    rig_->window().resize(width, 700);
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      return rig_->window().width() == width && status.text().contains("identical replay");
    }));
    QCoreApplication::processEvents();
    EXPECT_LE(status.heightForWidth(status.width()), status.height()) << width;
  }
}

TEST_F(AReplay, RunsNoHapticLoop)
{
  openReplay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->readOut("travelReadOut") == "1.0"; }));
  EXPECT_FALSE(rig_->window().control().isRunning());
  EXPECT_EQ(rig_->window().control().input(), gui::InputSource::scripted);
  EXPECT_EQ(rig_->now().tick, 0u);
}

TEST_F(AReplay, StepsByOneTickWithTheArrowKeys)
{
  openReplay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return replay().place() > 100; }));
  rig_->pressKey(Qt::Key_Space);
  EXPECT_FALSE(replay().isPlaying());
  const std::uint64_t there = replay().place();
  rig_->pressKey(Qt::Key_Right);
  EXPECT_EQ(replay().place(), there + 1);
  rig_->pressKey(Qt::Key_Left);
  rig_->pressKey(Qt::Key_Left);
  EXPECT_EQ(replay().place(), there - 1);
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return replay().now().tick > 0 && replayedTick() == replay().now().tick; }));
}

TEST_F(AReplay, GoesWhereTheScrubberIsClicked)
{
  openReplay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return replay().isChecked(); }));
  replay().pause();
  auto* scrubber = rig_->window().findChild<gui::Scrubber*>();
  QTest::mouseClick(scrubber, Qt::LeftButton, Qt::NoModifier, scrubber->rect().center());
  const double ticks = double(replay().playback().ticks());
  const double pixel = ticks / scrubber->width();
  EXPECT_NEAR(double(replay().place()), 0.5 * ticks, 2.0 * pixel);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return std::abs(scrubber->fraction() - 0.5) < 0.05; }));
}

TEST_F(AReplay, GoesSlowerAndFasterInSteps)
{
  openReplay();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->label("replaySpeed") == "1 ×"; }));
  for (int i = 0; i < 5; ++i) rig_->click("replaySlowerButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->label("replaySpeed") == "0.1 ×"; }));
  for (int i = 0; i < 9; ++i) rig_->click("replayFasterButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->label("replaySpeed") == "4 ×"; }));
}

TEST_F(AReplay, ReturnsToTheInsertion)
{
  openReplay();
  rig_->pressKey(Qt::Key_Escape);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !replayBarIsShown(); }));
  rig_->click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.3; }));
}

}  // namespace
}  // namespace perilymph::test

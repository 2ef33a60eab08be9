// SPDX-License-Identifier: BSD-3-Clause

// The booth: it runs a demonstration, a visitor inserts with a finger, and it returns to the
// demonstration.

#include <gtest/gtest.h>

#include <QFontDatabase>
#include <fstream>

#include "BoothFixture.h"
#include "perilymph/test/TestPicture.h"

namespace perilymph::test {
namespace {

using gui::KioskStage;

TEST_F(Booth, ShowsAnInsertionUntilSomebodyTouches)
{
  open();
  EXPECT_EQ(window_->stage(), KioskStage::attract);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 0.5; }));
  click("inviteButton");
  EXPECT_EQ(window_->stage(), KioskStage::turn);
  EXPECT_EQ(window_->control().input(), gui::InputSource::pointer);
  EXPECT_EQ(travel_mm(), 0.0);
}

TEST_F(Booth, RepeatsTheInsertionWhenItIsOver)
{
  open({{"stop_travel_mm", "1.0"}});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return window_->control().isAtDepth(); }));
  seconds_ += 1.0;
  ASSERT_TRUE(framesPass());
  seconds_ += 30.0;
  EXPECT_TRUE(WindowRig::waitUntil([&] { return travel_mm() < 0.5; }));
  EXPECT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 0.5; }));
}

TEST_F(Booth, AVisitorInsertsByHoldingAFingerAndSeesTheirPlace)
{
  open({{"stop_travel_mm", "2.0"}});
  click("inviteButton");
  ASSERT_TRUE(waitUntil(KioskStage::turn));
  pressPad();
  ASSERT_TRUE(waitUntil(KioskStage::result));
  EXPECT_TRUE(label("kioskTitle").contains("rank 1 of 1")) << label("kioskTitle").toStdString();
  EXPECT_TRUE(label("kioskSentence").contains("mN"));
  gui::Leaderboard kept(boardFile());
  ASSERT_EQ(kept.entriesOf(aDay).size(), 1u);
  EXPECT_NEAR(kept.entriesOf(aDay)[0].peak_mN, 1e3 * window_->turn().peakForce(), 0.01);
}

TEST_F(Booth, TheArrayRestsWhenTheFingerIsLifted)
{
  open();
  click("inviteButton");
  pressPad();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 0.5; }));
  releasePad();
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return window_->control().now().output.workflow == haptics::Workflow::paused; }));
  const double rested_mm = travel_mm();
  const std::uint64_t tick = window_->control().now().tick;
  ASSERT_TRUE(WindowRig::waitUntil([&] { return window_->control().now().tick > tick + 500; }));
  EXPECT_NEAR(travel_mm(), rested_mm, 0.01);
}

TEST_F(Booth, TheFartherRightTheFingerTheFasterTheArray)
{
  open();
  click("inviteButton");
  QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(2, 10));
  EXPECT_EQ(pad().speed(), gui::SpeedPad::slowest);
  QTest::mouseRelease(&pad(), Qt::LeftButton);
  EXPECT_EQ(pad().speed().si(), 0.0);
  QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(pad().width() - 2, 10));
  EXPECT_EQ(pad().speed(), gui::SpeedPad::fastest);
}

TEST_F(Booth, AfterAMinuteUntouchedItShowsItselfAgain)
{
  open();
  click("inviteButton");
  ASSERT_EQ(window_->stage(), KioskStage::turn);
  seconds_ += 59.0;
  ASSERT_TRUE(framesPass());
  EXPECT_EQ(window_->stage(), KioskStage::turn);
  seconds_ += 2.0;
  EXPECT_TRUE(waitUntil(KioskStage::attract));
}

TEST_F(Booth, AFingerThatStaysIsNotForgotten)
{
  open();
  click("inviteButton");
  QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(2, 10));
  for (int i = 0; i < 3; ++i) {
    seconds_ += 40.0;
    ASSERT_TRUE(framesPass());
    EXPECT_EQ(window_->stage(), KioskStage::turn);
  }
}

TEST_F(Booth, TheKeyboardAloneIsEnough)
{
  open({{"stop_travel_mm", "1.0"}});
  QTest::keyClick(window_.get(), Qt::Key_Space);
  ASSERT_TRUE(waitUntil(KioskStage::turn));
  QTest::keyPress(window_.get(), Qt::Key_Space);
  ASSERT_TRUE(waitUntil(KioskStage::result));
  QTest::keyRelease(window_.get(), Qt::Key_Space);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(waitUntil(KioskStage::attract));
}

TEST_F(Booth, OnlyItsOwnKeysEndIt)
{
  open();
  int ends = 0;
  QObject::connect(window_.get(), &gui::KioskWindow::ended, window_.get(), [&ends] { ++ends; });
  for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_F4, Qt::Key_Q, Qt::Key_F11, Qt::Key_F1})
    QTest::keyClick(window_.get(), key, Qt::AltModifier);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
  EXPECT_EQ(ends, 0);
  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(ends, 1);
}

TEST_F(Booth, KeepsNoRecordings)
{
  open();
  EXPECT_FALSE(window_->control().recording());
  click("inviteButton");
  EXPECT_FALSE(window_->control().recording());
  EXPECT_EQ(window_->control().recordingError(), "");
}

TEST_F(Booth, EveryTargetIsAsHighAsAFingerNeeds)
{
  constexpr int min_px = 64;
  open();
  for (const char* name : {"inviteButton", "pullButton", "handleButton", "startOverButton",
                           "doneButton", "againButton"})
    EXPECT_GE(window_->findChild<QAbstractButton*>(QLatin1String(name))->height(), min_px) << name;
  EXPECT_GE(pad().height(), min_px);
}

/// The image format of picture tests, lowest row first.
DrawnPicture drawn(const QImage& image)
{
  const QImage rgb = image.convertToFormat(QImage::Format_RGB888);
  DrawnPicture picture{rgb.width(), rgb.height(), {}};
  for (int y = rgb.height() - 1; y >= 0; --y)
    picture.rgb.insert(picture.rgb.end(), rgb.constScanLine(y),
                       rgb.constScanLine(y) + 3 * rgb.width());
  return picture;
}

TEST_F(Booth, InvitesAsAccepted)
{
  // at rest, because a moving array would be at a different position each time
  open({{"stop_travel_mm", "2.0"}, {"speed_mm_s", "10.0"}});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return window_->control().isAtDepth(); }));
  QImage before, now;
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    before = now;
    if (!framesPass()) return false;
    now = window_->grab().toImage();
    return now == before;
  }));
  ASSERT_EQ(now.size(), QSize(1280, 800));
  // Qt 6 places letters between pixels. Inter 4.1 of Debian 13 draws other letters than Inter 4.0 of Debian 12,
  // which writes "Inter Extra Bold".
  const bool isNewer = QFontDatabase().families().contains(QStringLiteral("Inter ExtraBold"));
  const char* accepted = QT_VERSION_MAJOR > 5 ? "kiosk-qt-6"
                         : isNewer            ? "kiosk-inter-4.1"
                                              : "kiosk";
  EXPECT_EQ(comparedWithAccepted(drawn(now), accepted), "");
}

gui::KioskEntry entry(int minute, double peak_mN) { return {QTime(14, minute), peak_mN, 9.0, 0}; }

TEST(Leaderboard, RanksTheLowestPeakFirstAndTheEarlierOfEquals)
{
  const TemporaryFolder folder;
  gui::Leaderboard board(folder.path() / "board");
  EXPECT_EQ(board.enter(aDay, entry(1, 80.0)), 1);
  EXPECT_EQ(board.enter(aDay, entry(2, 70.0)), 1);
  EXPECT_EQ(board.enter(aDay, entry(3, 80.0)), 3);
}

TEST(Leaderboard, IsBounded)
{
  const TemporaryFolder folder;
  const auto file = folder.path() / "board";
  {
    std::ofstream full(file);
    full << "perilymph booth 1\n2026-11-20\n";
    for (std::size_t i = 0; i < gui::Leaderboard::capacity; ++i)
      full << "14:00:00 " << 50 + i % 10 << ".00 9.0 0\n";
  }
  gui::Leaderboard board(file);
  EXPECT_FALSE(board.enter(aDay, entry(50, 200.0)));
  EXPECT_EQ(board.enter(aDay, entry(50, 40.0)), 1);
  gui::Leaderboard again(file);
  EXPECT_EQ(again.entriesOf(aDay).size(), gui::Leaderboard::capacity);
}

TEST(Leaderboard, KeepsVisitorsBestAndMedianOverARestartOfTheSameDay)
{
  const TemporaryFolder folder;
  {
    gui::Leaderboard board(folder.path() / "board");
    for (int i = 0; i < 3; ++i) board.addVisitor(aDay);
    board.enter(aDay, entry(1, 80.0));
    board.enter(aDay, entry(2, 30.0));
    EXPECT_EQ(board.statisticsOf(aDay).median_mN, 55.0);  // of an even number
    board.enter(aDay, entry(3, 31.0));
  }
  gui::Leaderboard board(folder.path() / "board");
  const gui::DayStatistics day = board.statisticsOf(aDay);
  EXPECT_EQ(day.visitors, 3);
  EXPECT_EQ(day.insertions, 3);
  EXPECT_EQ(day.best_mN, 30.0);
  EXPECT_EQ(day.median_mN, 31.0);
  const gui::DayStatistics next = board.statisticsOf(aDay.addDays(1));
  EXPECT_EQ(next.visitors, 0);
  EXPECT_FALSE(next.median_mN);
}

TEST(Leaderboard, RestartsEveryDay)
{
  const TemporaryFolder folder;
  gui::Leaderboard board(folder.path() / "board");
  board.enter(aDay, entry(1, 80.0));
  EXPECT_TRUE(board.entriesOf(aDay.addDays(1)).empty());
}

TEST(Leaderboard, ADamagedFileCostsItsDamagedLinesOnly)
{
  const TemporaryFolder folder;
  const auto file = folder.path() / "board";
  std::ofstream(file) << "perilymph booth 1\n2026-11-20\n14:00:00 80.5 9.0 1\nnonsense\n"
                         "14:01:00 nan 9.0 1\n14:02:00 -3 9.0 1\n99:00:00 70 9.0 1\n";
  gui::Leaderboard board(file);
  ASSERT_EQ(board.entriesOf(aDay).size(), 1u);
  EXPECT_EQ(board.entriesOf(aDay)[0].peak_mN, 80.5);
}

TEST(Leaderboard, ThatCannotBeKeptSaysSo)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "taken") << "a file where a folder is needed";
  gui::Leaderboard board(folder.path() / "taken" / "board");
  EXPECT_EQ(board.enter(aDay, entry(1, 80.0)), 1);
  EXPECT_FALSE(board.error().empty());
}

haptics::Snapshot moment(double travel_mm, double force_mN)
{
  haptics::Snapshot now;
  now.output.workflow = haptics::Workflow::inserting;
  now.output.travel = 1e-3 * travel_mm;
  now.output.axialForce = now.peak.force = 1e-3 * force_mN;
  return now;
}

TEST(VisitorSession, CountsTurningBackButNotTrembling)
{
  gui::VisitorSession turn;
  for (const double travel_mm : {0.0, 1.0, 2.0, 1.9, 2.1, 2.0, 3.0, 2.0, 1.0, 1.1, 1.0, 4.0, 3.0})
    turn.follow(moment(travel_mm, 10.0));
  EXPECT_EQ(turn.reversals(), 2);  // at 3 mm and at 4 mm
  EXPECT_NEAR(turn.deepestTravel(), 4e-3, 1e-12);
}

}  // namespace
}  // namespace perilymph::test

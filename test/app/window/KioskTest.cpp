// SPDX-License-Identifier: BSD-3-Clause

// The booth: it runs a demonstration, a visitor inserts with a finger, and it returns to the
// demonstration.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QFontDatabase>
#include <QLabel>
#include <QTest>
#include <fstream>

#include "KeptPicture.h"
#include "WindowRig.h"
#include "gui/kiosk/KioskWindow.h"
#include "gui/kiosk/SpeedPad.h"
#include "gui/scene/ForceLabel.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/TestPicture.h"

namespace perilymph::test {
namespace {

using gui::KioskStage;

const QDate aDay(2026, 11, 20);

/// A booth with a clock that the test controls.
class Booth : public testing::Test {
protected:
  void open(const session::Overrides& overrides = {})
  {
    auto scenario = session::loadScenario("contour-published", overrides);
    ASSERT_TRUE(scenario) << scenario.error().message;
    gui::KioskClock clock;
    clock.seconds = [this] { return seconds_; };
    clock.today = [] { return QDateTime(aDay, QTime(14, 3, 21)); };
    window_ = std::make_unique<gui::KioskWindow>(*scenario, boardFile(), clock,
                                                 WindowRig::sharedCochleae());
    window_->show();
    const auto opened = window_->open();
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 0.0; }));
  }

  std::filesystem::path boardFile() const { return folder_.path() / "booth" / "board.txt"; }
  double travel_mm() const
  {
    return inMillimeters(Length::fromSi(window_->control().now().output.travel));
  }
  /// Processes events at the current time of the clock.
  bool framesPass()
  {
    const std::uint64_t end = window_->frames() + 3;
    return WindowRig::waitUntil([&] { return window_->frames() >= end; });
  }
  bool waitUntil(KioskStage stage)
  {
    return WindowRig::waitUntil([&] { return window_->stage() == stage; });
  }
  gui::SpeedPad& pad() { return *window_->findChild<gui::SpeedPad*>(); }
  QString label(const char* name)
  {
    return window_->findChild<QLabel*>(QLatin1String(name))->text();
  }
  void click(const char* name)
  {
    QTest::mouseClick(window_->findChild<QAbstractButton*>(QLatin1String(name)), Qt::LeftButton);
  }
  /// Puts a finger on the pad, near its fast end.
  void pressPad()
  {
    QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(pad().width() - 40, pad().height() / 2));
  }
  void releasePad() { QTest::mouseRelease(&pad(), Qt::LeftButton); }

  TemporaryFolder folder_;
  double seconds_ = 1000.0;
  std::unique_ptr<gui::KioskWindow> window_;
};

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
  EXPECT_TRUE(label("kioskTitle").contains("place 1")) << label("kioskTitle").toStdString();
  EXPECT_TRUE(label("kioskTitle").contains("mN"));
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
  // Inter 4.1 of Debian 13 draws other letters than Inter 4.0 of Debian 12, which writes "Inter Extra Bold".
  const bool isNewer = QFontDatabase().hasFamily(QStringLiteral("Inter ExtraBold"));
  EXPECT_EQ(comparedWithAccepted(drawn(now), isNewer ? "kiosk-inter-4.1" : "kiosk"), "");
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
  gui::Leaderboard board(folder.path() / "board");
  for (int i = 0; i < 30; ++i) board.enter(aDay, entry(i, 50.0 + i));
  EXPECT_EQ(board.entriesOf(aDay).size(), gui::Leaderboard::capacity);
  EXPECT_FALSE(board.enter(aDay, entry(50, 200.0)));
  gui::Leaderboard again(folder.path() / "board");
  EXPECT_EQ(again.entriesOf(aDay).size(), gui::Leaderboard::capacity);
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

TEST(VisitorSession, ComparesThePeakWithWhatWasMeasuredInPatients)
{
  const auto peaks = analysis::peaksInPatients();
  ASSERT_TRUE(peaks);
  // peaks of 44.8 to 102.4 mN: Rau et al. 2024
  EXPECT_TRUE(gui::peakText(0.0447, peaks).startsWith("Below"));
  EXPECT_TRUE(gui::peakText(0.0449, peaks).startsWith("Within"));
  EXPECT_TRUE(gui::peakText(0.1025, peaks).startsWith("Above"));
}

TEST_F(Booth, IsReadFromOneAndAHalfMeters)
{
  open();
  EXPECT_GE(window_->findChild<gui::ForceLabel*>()->font().pixelSize(), 20);
  EXPECT_EQ(window_->findChild<gui::ForceLabel*>()->height(), 36);  // one line
  EXPECT_FALSE(window_->findChild<QLabel*>("magnificationLabel")->isVisible());
  EXPECT_GE(window_->findChild<QLabel*>("viewLabel")->font().pixelSize(), 20);
  keepPicture(*window_, "booth");
}

}  // namespace
}  // namespace perilymph::test

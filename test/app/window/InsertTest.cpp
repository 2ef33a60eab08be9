// SPDX-License-Identifier: BSD-3-Clause

// The buttons of the window: start, pause, withdraw, reset, stylet.

#include <gtest/gtest.h>

#include <QLabel>
#include <set>

#include "WindowRig.h"
#include "gui/scene/PhaseLine.h"
#include "gui/widgets/Selector.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using haptics::Workflow;

// A resting base may move by rounding errors; a moving one would travel 2 mm in the same time.
constexpr double rest_mm = 0.01;
// The window notices the arrival within a frame: 16 ms or, on a busy machine, much longer.
constexpr double overshoot_mm = 1.0;

std::set<std::filesystem::path> sessions()
{
  std::set<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(sessionFolder(), ignored))
    if (entry.path().extension() == ".insertion") files.insert(entry.path());
  return files;
}

TEST(Window, StartMovesTheArrayIntoTheCochlea)
{
  WindowRig rig;
  const double depthBefore = rig.now().output.depth;
  rig.click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  EXPECT_GT(rig.now().output.depth, depthBefore);
}

TEST(Window, ShowsTheAngleOfTheTipBeforeTheStart)
{
  WindowRig rig;
  const double before = rig.now().output.angularDepth;
  EXPECT_GT(before, 0.0);
  rig.click("startButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::inserting; }));
  // 2 mm/s move the tip by less than a degree in the first frames
  EXPECT_NEAR(rig.now().output.angularDepth, before, 0.1);
}

TEST(Window, PauseHoldsTheArrayWhereItIs)
{
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  rig.click("startButton");  // its text is now Pause
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  const double held_mm = rig.travel_mm();
  ASSERT_TRUE(rig.runForTicks(1000));
  EXPECT_NEAR(rig.travel_mm(), held_mm, rest_mm);
}

TEST(Window, WithdrawTakesTheArrayBackToItsStartAndNoFurther)
{
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 1.0; }));
  rig.click("withdrawButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 0.2; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !rig.window().control().isMoving(); }));
  ASSERT_TRUE(rig.runForTicks(500));
  EXPECT_NEAR(rig.travel_mm(), 0.0, overshoot_mm);
}

TEST(Window, ResetReturnsToTheStartWithARecordingOfItsOwn)
{
  const auto before = sessions();
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  rig.click("resetButton");
  EXPECT_EQ(rig.travel_mm(), 0.0);
  EXPECT_EQ(rig.readOut("travelReadOut"), "0.0");
  EXPECT_FALSE(rig.window().control().isRunning());

  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  EXPECT_EQ(sessions().size(), before.size() + 2);
}

TEST(Window, AWindowThatIsOnlyLookedAtLeavesNoRecordingBehind)
{
  const auto before = sessions();
  {
    WindowRig rig;
  }
  EXPECT_EQ(sessions(), before);
}

TEST(Window, StopsAtFullDepthAndOffersTheWayOut)
{
  WindowRig rig(session::Overrides{{"stop_travel_mm", "1.0"}, {"speed_mm_s", "4.0"}});
  rig.click("startButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::finished; }));
  EXPECT_NEAR(rig.travel_mm(), 1.0, rest_mm);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !rig.button("startButton").isEnabled(); }));
  auto* phase = rig.window().findChild<gui::PhaseLine*>();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return phase->phase() == analysis::Phase::full; }));

  rig.click("withdrawButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 0.3; }));
}

TEST(Window, StartingAgainOnTheWayOutStillStopsAtFullDepth)
{
  WindowRig rig(session::Overrides{{"stop_travel_mm", "2.0"}, {"speed_mm_s", "0.5"}});
  rig.click("startButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::finished; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("withdrawButton").isEnabled(); }));
  rig.click("withdrawButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 1.9; }));
  rig.click("startButton");  // its text is Pause while the array is withdrawn
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); }));
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 1.9; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !rig.window().control().isMoving(); }));
  ASSERT_TRUE(rig.runForTicks(500));
  EXPECT_LT(rig.travel_mm(), 2.0 + overshoot_mm);
}

TEST(Window, RecognizesFullDepthAgainAfterAWithdrawal)
{
  WindowRig rig(session::Overrides{{"stop_travel_mm", "2.0"}, {"speed_mm_s", "0.5"}});
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::finished; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("withdrawButton").isEnabled(); }));
  rig.pressKey(Qt::Key_Backspace);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() < 1.9; }));
  rig.pressKey(Qt::Key_Space);  // pauses
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); }));
  rig.pressKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() >= 2.0; }));
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !rig.button("startButton").isEnabled(); }));
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig.window().findChild<gui::Selector*>("arraySelector")->isEnabled(); }));
  EXPECT_TRUE(rig.label("hintLabel").contains("Press Withdraw or Reset"))
      << rig.label("hintLabel").toStdString();
  EXPECT_TRUE(rig.button("withdrawButton").isEnabled());
}

TEST(Window, SaysWhereTheTipIsWhenTheArrayIsBackAtItsStart)
{
  WindowRig rig(session::Overrides{{"stop_travel_mm", "1.0"}, {"speed_mm_s", "4.0"}});
  rig.click("startButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::finished; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("withdrawButton").isEnabled(); }));
  rig.click("withdrawButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return !rig.window().control().isAtDepth() && rig.now().output.workflow == Workflow::finished;
  }));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig.label("hintLabel").contains("2.0 mm inside");
  })) << rig.label("hintLabel").toStdString();
  EXPECT_FALSE(rig.label("hintLabel").contains("withdrawn"));
  auto* phase = rig.window().findChild<gui::PhaseLine*>();
  EXPECT_EQ(phase->phase(), analysis::Phase::opening);
}

TEST(Window, NumbersOnThePictureAreThoseOfTheLoop)
{
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 2.0; }));
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  ASSERT_TRUE(rig.runForTicks(1000));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig.readOut("travelReadOut").toDouble() == std::round(10 * rig.travel_mm()) / 10;
  })) << rig.readOut("travelReadOut").toStdString()
      << " instead of " << rig.travel_mm();
  // the angle is that of the most apical contact
  const gui::InsertionControl& control = rig.window().control();
  const auto contacts =
      analysis::contactPositions(control.anatomy(), control.scenario().array(), rig.now());
  ASSERT_TRUE(contacts.front().isInserted);
  EXPECT_NEAR(rig.readOut("angleReadOut").toDouble(), inDegrees(contacts.front().angle), 0.51);
  EXPECT_LT(inDegrees(contacts.front().angle), inDegrees(radians(rig.now().output.angularDepth)));
  EXPECT_NEAR(rig.readOut("forceReadOut").toDouble(), rig.now().output.axialForce * 1e3, 0.51);
}

TEST(Window, PullsTheStyletWhileTheArrayStays)
{
  WindowRig rig;
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.workflow == Workflow::paused; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("styletButton").isEnabled(); }));
  const double held_mm = rig.travel_mm();
  rig.click("styletButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.now().output.styletWithdrawal > 1e-3; }));
  EXPECT_NEAR(rig.travel_mm(), held_mm, 0.5);  // the curling tip changes the depth a little
}

TEST(Window, RecordsWhereItIsTold)
{
  const TemporaryFolder folder;
  const auto file = folder / "kept.insertion";
  {
    WindowRig rig({}, file);
    rig.click("startButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  }
  const auto kept = session::RecordedInsertion::open(file);
  ASSERT_TRUE(kept) << kept.error().message;
}

TEST(Window, WithoutARecordingTheInsertionGoesOnAndSaysSo)
{
  const TemporaryFolder folder;
  const std::string before = std::getenv("XDG_DATA_HOME");
  std::ofstream(folder / "no-folder") << "a file where a folder is wanted";
  setenv("XDG_DATA_HOME", (folder / "no-folder").c_str(), 1);
  WindowRig rig;
  setenv("XDG_DATA_HOME", before.c_str(), 1);
  rig.click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  EXPECT_TRUE(rig.label("statusLabel").contains("NOT recording"))
      << rig.label("statusLabel").toStdString();
  EXPECT_TRUE(rig.label("bannerText").contains("not being recorded"))
      << rig.label("bannerText").toStdString();
}

}  // namespace
}  // namespace perilymph::test

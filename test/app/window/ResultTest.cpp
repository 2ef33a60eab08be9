// SPDX-License-Identifier: BSD-3-Clause

// The card at the end of an insertion, and the recording that it is then.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QTableView>
#include <QTimer>
#include <algorithm>
#include <filesystem>

#include "KeptPicture.h"
#include "WindowRig.h"
#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/sessions/SessionTable.h"
#include "gui/report/InsertionResults.h"
#include "gui/shell/TopBar.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using haptics::Workflow;

class ShownResult : public testing::Test {
protected:
  ShownResult() : rig_(session::Overrides{{"stop_travel_mm", "3.0"}, {"speed_mm_s", "4.0"}}) {}

  gui::ResultCard& card() { return *rig_.window().findChild<gui::ResultCard*>(); }
  gui::InsertionController& insertion() { return rig_.window().insertion(); }
  QStringList texts()
  {
    QStringList found;
    for (const auto* label : card().findChildren<QLabel*>()) found << label->text();
    return found;
  }
  void insert()
  {
    rig_.click("startButton");
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return rig_.now().output.workflow == Workflow::finished; }));
    EXPECT_TRUE(card().isHidden());
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !card().isHidden(); }));
  }
  QString pill() { return rig_.window().findChild<gui::DeviceLight*>()->text(); }
  /// What the newest row of the sessions says in place of its time.
  QString newestRow()
  {
    const auto* list = rig_.window().findChild<QTableView*>("sessionList");
    return list->model()->index(0, gui::SessionTable::recorded).data().toString();
  }
  std::uint64_t ticksOfWholeRecording()
  {
    const auto recorded = session::RecordedInsertion::open(insertion().result()->file);
    EXPECT_TRUE(recorded) << recorded.error().message;
    if (!recorded) return 0;
    EXPECT_TRUE(recorded->wasClosed());
    EXPECT_EQ(recorded->check()->damage, "");
    return recorded->ticks();
  }

  WindowRig rig_;
};

TEST_F(ShownResult, IsShownAtTheEndWithNothingToPressAndIsARecordingFromThenOn)
{
  insert();
  EXPECT_TRUE(rig_.label("resultTitle").startsWith("Stopped as set"));
  const auto recorded = session::RecordedInsertion::open(insertion().result()->file);
  ASSERT_TRUE(recorded) << recorded.error().message;
  double peak = 0.0;
  ASSERT_TRUE(recorded->forEach([&](const haptics::TickRecord& record) {
    peak = std::max(peak, record.output.axialForce);
    return true;
  }));
  EXPECT_THAT(texts(),
              testing::Contains(QStringLiteral("%1 mN").arg(gui::numberText(peak * 1e3, 1))));
  const std::uint64_t inserted = ticksOfWholeRecording();

  // a withdrawal is added to the recording, and it ends once more
  rig_.click("withdrawButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return card().isHidden(); }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !card().isHidden(); }));
  EXPECT_EQ(rig_.label("resultTitle"), "Withdrawn");
  EXPECT_GT(ticksOfWholeRecording(), inserted);
}

TEST_F(ShownResult, OfAHandThatHoldsOnStatesTheRestOnEveryPageUntilItIsRecorded)
{
  rig_.click("pointerChoice");
  rig_.click("startButton");
  EXPECT_EQ(pill(), "running");
  rig_.holdKey(Qt::Key_Space);
  rig_.holdKey(Qt::Key_Down);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig_.now().output.workflow == Workflow::finished; }));
  rig_.releaseKey(Qt::Key_Down);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pill() == "ended, resting"; }));
  EXPECT_TRUE(rig_.label("statusLabel").startsWith("recording the rest"));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !card().isHidden(); }));
  EXPECT_EQ(pill(), "ended");
  const std::uint64_t first = ticksOfWholeRecording();

  // the hand opens, which ends the rest: what follows is recorded, until it rests once more
  rig_.click("closeResultButton");
  rig_.releaseKey(Qt::Key_Space);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pill() == "ended, resting"; }));
  rig_.click("sessionsPageButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return newestRow() == "recording the rest"; }));
  EXPECT_FALSE(rig_.button("reportButton").isEnabled());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return newestRow().startsWith("20"); }));
  EXPECT_EQ(pill(), "ended");
  EXPECT_TRUE(rig_.button("reportButton").isEnabled());
  const auto* result = insertion().result().get();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return insertion().result().get() != result; }));
  EXPECT_GT(ticksOfWholeRecording(), first);
  EXPECT_TRUE(card().isHidden());  // it was closed
}

TEST_F(ShownResult, AgainInsertsOnceMoreWithARecordingOfItsOwnAndComparesBoth)
{
  insert();
  const auto first = insertion().result()->file;
  rig_.click("resultAgainButton");
  EXPECT_TRUE(card().isHidden());
  EXPECT_FALSE(insertion().result());
  EXPECT_EQ(insertion().recordingBefore(), first);
  EXPECT_NE(rig_.window().control().recording(), first);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !card().isHidden(); }));
  rig_.click("resultCompareButton");
  const auto* curves = rig_.window().findChild<gui::ComparisonPlot*>();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return curves != nullptr && curves->isVisible(); }));
}

TEST_F(ShownResult, StatesWhatClinicsReportOfItsArray)
{
  rig_.choose("arraySelector", "flex28");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig_.window().control().scenario().array().name == "FLEX28" &&
           rig_.button("startButton").isEnabled();
  }));
  insert();
  EXPECT_TRUE(texts().contains("clinics report"));
  EXPECT_TRUE(texts().contains("575 (IQR 465–584)°")) << texts().join('|').toStdString();
  EXPECT_TRUE(texts().contains("FLEX28, not validated")) << texts().join('|').toStdString();
  EXPECT_FALSE(texts().join('|').contains("A hand that stops"));  // nor would it have stopped

  // of one that a hand would have ended
  gui::ReportContent content = *insertion().result();
  content.passedStop = {millinewtons(100), millimeters(14.2), degrees(410), 7, 12};
  card().show(content, QStringLiteral("Full depth"));
  EXPECT_TRUE(texts().contains("A hand that stops at 100 mN"));
  EXPECT_TRUE(texts().contains("would have ended at 14.2 mm, 410°, 7 of 12 contacts inside"));
  keepPicture(rig_.window(), "result-clinics");
}

TEST_F(ShownResult, SavesItsContactsWithADictionaryOfTheirColumns)
{
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "contacts.csv";
  insert();
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    dialog->selectFile(QString::fromStdString(file.string()));
    static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
  });
  watch.start(20);
  rig_.click("resultContactsButton");
  watch.stop();
  const auto table = readWhole(file);
  ASSERT_TRUE(table);
  EXPECT_EQ(std::ranges::count(*table, '\n'), 23);  // 22 contacts of a Contour
  EXPECT_THAT(*table, testing::StartsWith("array,contact,draws,angle_deg,"));
  const auto dictionary = readWhole(folder / "contacts-dictionary.csv");
  ASSERT_TRUE(dictionary);
  EXPECT_THAT(*dictionary, testing::HasSubstr("mismatch_semitones,semitones,"));
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// Studies that are made, canceled and continued in the window.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QRegularExpression>
#include <QTableWidget>
#include <QTest>
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/studies/StudiesPage.h"
#include "gui/pages/studies/StudyPanel.h"
#include "gui/pages/studies/StudyPlot.h"
#include "gui/pages/studies/StudyStore.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Selector.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

gui::StudiesPage& pageOf(WindowRig& rig) { return *rig.window().findChild<gui::StudiesPage*>(); }

QAbstractButton& emptyButton(WindowRig& rig)
{
  return *pageOf(rig).findChild<QAbstractButton*>("emptyPageButton");
}

/// Keeps a picture of the window at a size, after its layouts came to rest.
void keep(WindowRig& rig, const QSize& size, const std::string& name)
{
  if (qEnvironmentVariableIsEmpty("PERILYMPH_SCREEN_PICTURES")) return;
  rig.window().resize(size);
  static_cast<void>(pictureOf(rig.window()));
  pageOf(rig).plot().render();
  keepPicture(rig.window(), name + "-" + std::to_string(size.width()));
}

/// Opens the form from the empty page, and enters FLEX24 and FLEX28 in some cochleae with the
/// friction of soap; coarse.
void enter(WindowRig& rig, const char* title, const char* cochleae)
{
  rig.window().showPage("studies");
  emptyButton(rig).click();
  ASSERT_TRUE(rig.button("startStudyButton").isVisible());
  rig.type("newStudyTitle", title);
  rig.type("newStudySimulated", cochleae);
  rig.click("newStudy-friction-estimate-from-pig-tissue");
  rig.click("newStudy-friction-soap-10");
  rig.type("newStudy-speed_mm_s-low", "1");
  rig.type("newStudy-speed_mm_s-high", "3");
  rig.choose("newStudyResolution", "coarse");
}

bool canStart(WindowRig& rig)
{
  return WindowRig::waitUntil([&] { return rig.button("startStudyButton").isEnabled(); });
}

bool isComplete(WindowRig& rig, std::size_t insertions)
{
  gui::StudiesPage& page = pageOf(rig);
  return WindowRig::waitUntil([&] {
    return page.columns() && page.columns()->size() == insertions && page.summary() != nullptr;
  });
}

std::string contentOf(const fs::path& file)
{
  const auto content = readWhole(file);
  EXPECT_TRUE(content) << file;
  return content ? *content : std::string();
}

class ANewStudy : public testing::Test {
protected:
  DataFolder data_;
};

TEST_F(ANewStudy, IsProposedWithATitleThatNoOtherHas)
{
  WindowRig rig;
  rig.window().showPage("studies");
  emptyButton(rig).click();
  auto& title = *pageOf(rig).findChild<QLineEdit*>("newStudyTitle");
  const QString first = title.text();
  EXPECT_TRUE(first.startsWith("Study of "));
  gui::StudyDraft draft;
  draft.title = first.toStdString();
  ASSERT_TRUE(gui::saveStudy(draft));
  rig.click("leaveNewStudyButton");
  emptyButton(rig).click();
  EXPECT_EQ(title.text(), first + " (2)");
  rig.type("newStudyTitle", "Mine");
  rig.click("leaveNewStudyButton");
  emptyButton(rig).click();
  EXPECT_EQ(title.text(), "Mine");
}

TEST_F(ANewStudy, OfSixtyInsertionsIsRunFilteredAndExported)
{
  WindowRig rig;
  enter(rig, "Two lengths", "30");
  ASSERT_TRUE(canStart(rig)) << rig.label("newStudyNote").toStdString();
  EXPECT_TRUE(rig.label("newStudyNote").contains("60 insertions, about"));
  EXPECT_TRUE(rig.label("newStudyNote").contains("an estimate from 2 that were run now"));
  for (const QSize& size : {QSize(1366, 768), QSize(1280, 800)}) keep(rig, size, "new-study");
  rig.click("startStudyButton");
  ASSERT_TRUE(isComplete(rig, 60)) << rig.label("studyStatus").toStdString();
  EXPECT_EQ(rig.label("studyTitle"), "Two lengths");
  gui::StudiesPage& page = pageOf(rig);
  for (const QSize& size : {QSize(1366, 768), QSize(1280, 800)}) keep(rig, size, "study-summary");

  // the tables
  auto& groups = *page.findChild<QTableWidget*>("studyGroups");
  ASSERT_EQ(groups.rowCount(), 2);
  EXPECT_EQ(groups.item(0, 0)->text(), "FLEX24");
  EXPECT_EQ(groups.item(0, 2)->text(), "0");                     // stopped
  EXPECT_TRUE(groups.item(0, 1)->text().startsWith("100 % ("));  // complete
  auto& differences = *page.findChild<QTableWidget*>("studyDifferences");
  ASSERT_EQ(differences.rowCount(), 1);
  EXPECT_EQ(differences.item(0, 1)->text(), "30 pairs, 30 cochleae");
  ASSERT_TRUE(page.summary()->groups[0].samples.ran.trend);
  EXPECT_LT(page.summary()->groups[0].samples.ran.trend->slope().high,
            0.0);  // larger cochleae, less angle

  // the filter, and the export of what is shown
  rig.click("study-array-flex28");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.summary() && groups.rowCount() == 1; }));
  const TemporaryFolder exported;
  ASSERT_TRUE(page.writeInto(exported.path()));
  const std::string points = contentOf(exported / "points.csv");
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 31);
  const study::StudyGroup& group = page.summary()->groups[0];
  const std::string row = "\nflex24,all that ran,30," + std::to_string(group.complete()) + "," +
                          std::to_string(group.stopped()) + ",0,";
  EXPECT_NE(contentOf(exported / "groups.csv").find(row), std::string::npos);
  EXPECT_TRUE(groups.item(0, 3)->text().startsWith(
      QString::number(group.samples.ran.quartiles[0]->value, 'f', 0) + " ("));

  // what was run can be repeated: the settings are beside the results, as the command line reads them
  const fs::path folder = page.folder();
  EXPECT_EQ(folder.parent_path(), gui::studiesFolder());
  const auto again = study::loadStudy(folder / gui::studySettingsFile);
  ASSERT_TRUE(again) << again.error().message;
  const TemporaryFolder other;
  const auto ran = study::runShard(*again, study::shardOf(60, 1, 1), other.path(), 1, {});
  ASSERT_TRUE(ran && *ran);
  ASSERT_TRUE(study::mergeShards(other.path()));
  EXPECT_TRUE(contentOf(other / study::mergedFile) == contentOf(folder / study::mergedFile));
}

TEST_F(ANewStudy, ThatWasCanceledContinuesToTheSameBytes)
{
  WindowRig rig;
  enter(rig, "Canceled", "60");
  ASSERT_TRUE(canStart(rig)) << rig.label("newStudyNote").toStdString();
  rig.click("startStudyButton");
  gui::StudiesPage& page = pageOf(rig);
  auto& bar = *page.findChild<QProgressBar*>();
  // 65 of 120 ran: those that ended one after the other are kept
  ASSERT_TRUE(WindowRig::waitUntil([&] { return bar.maximum() == 1000 && bar.value() > 540; }));
  rig.click("cancelStudyButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
  const gui::StoredStudy kept = gui::readStoredStudy(page.folder());
  EXPECT_FALSE(kept.isComplete);
  EXPECT_EQ(kept.cases, 120u);
  EXPECT_GE(kept.done, 60u);
  EXPECT_LT(kept.done, 120u);
  EXPECT_EQ(
      rig.label("studyStatus"),
      QString("Canceled. %1 of 120 insertions are kept; Continue runs the rest.").arg(kept.done));
  EXPECT_EQ(page.columns(), nullptr);
  rig.click("continueStudyButton");
  ASSERT_TRUE(isComplete(rig, 120)) << rig.label("studyStatus").toStdString();

  const auto whole = study::loadStudy(page.folder() / gui::studySettingsFile);
  ASSERT_TRUE(whole) << whole.error().message;
  const TemporaryFolder other;
  const auto ran = study::runShard(*whole, study::shardOf(120, 1, 1), other.path(), 2, {});
  ASSERT_TRUE(ran && *ran);
  ASSERT_TRUE(study::mergeShards(other.path()));
  for (const char* name : {study::mergedFile, study::mergedTable})
    EXPECT_TRUE(contentOf(other / name) == contentOf(page.folder() / name)) << name;
}

TEST_F(ANewStudy, IsRefusedInOneSentenceWhileAFieldIsWrong)
{
  WindowRig rig;
  enter(rig, "Wrong", "2");
  const auto says = [&](const char* sentence) {
    return WindowRig::waitUntil([&] { return rig.label("newStudyNote").contains(sentence); });
  };
  rig.type("newStudy-speed_mm_s-low", "fast");
  EXPECT_TRUE(says("Speed, mm/s, from: “fast” is no number."));
  EXPECT_FALSE(rig.button("startStudyButton").isEnabled());
  rig.type("newStudy-speed_mm_s-low", "5");
  EXPECT_TRUE(says("Speed, mm/s, from is 5, above the other limit, 3."));
  rig.type("newStudy-speed_mm_s-high", "900");
  EXPECT_TRUE(says("speed_mm_s")) << rig.label("newStudyNote").toStdString();
  rig.type("newStudy-speed_mm_s-high", "6");
  rig.type("newStudySimulated", "1.5");
  EXPECT_TRUE(says("is “1.5”; a whole number from 0 to 1,000,000 is needed."));
  rig.type("newStudySimulated", "0");
  EXPECT_TRUE(says("There is no cochlea."));
  EXPECT_FALSE(rig.button("startStudyButton").isEnabled());
  EXPECT_FALSE(fs::exists(gui::studiesFolder()));
  rig.pressKey(Qt::Key_Escape);  // back to the empty page
  EXPECT_TRUE(emptyButton(rig).isVisible());
}

TEST_F(ANewStudy, HasShippedPatientsBesideItsSettings)
{
  WindowRig rig;
  rig.window().showPage("studies");
  emptyButton(rig).click();
  const auto boxes =
      pageOf(rig).findChildren<gui::CheckBox*>(QRegularExpression("^newStudy-patient-"));
  ASSERT_FALSE(boxes.isEmpty());
  rig.click(boxes.front()->objectName().toLatin1().constData());
  rig.type("newStudySimulated", "0");
  rig.type("newStudyTitle", "One patient");
  rig.choose("newStudyResolution", "coarse");
  ASSERT_TRUE(canStart(rig)) << rig.label("newStudyNote").toStdString();
  rig.click("startStudyButton");
  ASSERT_TRUE(isComplete(rig, 2)) << rig.label("studyStatus").toStdString();
  const std::string patient =
      boxes.front()->objectName().mid(int(std::strlen("newStudy-patient-"))).toStdString() +
      ".toml";
  EXPECT_TRUE(fs::exists(pageOf(rig).folder() / patient));
  EXPECT_EQ(pageOf(rig).columns()->result(0).cochlea, patient);

  // and it is offered when the next one is made
  rig.click("newStudyButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.button("openStoredStudyButton").isEnabled(); }));
  auto& stored = *pageOf(rig).findChild<gui::Selector*>("storedStudies");
  EXPECT_EQ(stored.currentText(), "One patient · complete");
}

}  // namespace
}  // namespace perilymph::test

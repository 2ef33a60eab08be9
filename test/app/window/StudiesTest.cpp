// SPDX-License-Identifier: BSD-3-Clause

// The page of studies, with the result of a small study that is run first.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "OwnFolders.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/studies/StudiesPage.h"
#include "gui/pages/studies/StudyPanel.h"
#include "gui/pages/studies/StudyPlot.h"
#include "gui/pages/studies/StudyText.h"
#include "gui/program/Languages.h"
#include "gui/scene/PlainVtkWidget.h"
#include "gui/setup/SetupTitle.h"
#include "gui/text/Numbers.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// Two arrays with two frictions in eight virtual cochleae; coarse and fast.
constexpr const char* studyText = R"(
title = "Two lengths in eight cochleae"
scenario = "mean-flex28"
seed = 1
depth = "full"
[cochleae]
virtual = 8
[vary]
array = ["flex24", "flex28"]
friction = ["tissue", "soap-10"]
nodes = [30]
dt_ms = [10.0]
[ranges]
speed_mm_s = [2.0, 4.0]
)";
constexpr std::size_t insertions = 32;

class AStudy : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    folder_ = std::make_unique<TemporaryFolder>();
    const auto study = study::parseStudy(studyText, folder_->path() / "study.toml");
    ASSERT_TRUE(study) << study.error().message;
    ASSERT_EQ(study->size(), insertions);
    const auto ran =
        study::runShard(*study, study::shardOf(insertions, 1, 1), folder_->path(), 2, {});
    ASSERT_TRUE(ran) << ran.error().message;
    const auto merged = study::mergeShards(folder_->path());
    ASSERT_TRUE(merged) << merged.error().message;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path file() { return folder_->path() / study::mergedFile; }
  static gui::StudiesPage& pageOf(WindowRig& rig)
  {
    return *rig.window().findChild<gui::StudiesPage*>();
  }
  /// Opens the study on its page, and waits until it is drawn.
  static bool open(WindowRig& rig)
  {
    rig.window().showPage("studies");
    gui::StudiesPage& page = pageOf(rig);
    page.open(file());
    if (!WindowRig::waitUntil([&] { return page.columns() != nullptr; })) return false;
    for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();  // nested layouts
    page.plot().render();
    return true;
  }
  static bool isReplaying(WindowRig& rig)
  {
    return WindowRig::waitUntil([&] { return rig.window().insertion().replay().isOpen(); });
  }

  DataFolder data_;

private:
  static std::unique_ptr<TemporaryFolder> folder_;
};

std::unique_ptr<TemporaryFolder> AStudy::folder_;

TEST_F(AStudy, IsExplainedBeforeOneIsOpened)
{
  WindowRig rig;
  rig.click("studiesPageButton");
  EXPECT_EQ(rig.window().page(), "studies");
  const auto labels = pageOf(rig).findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->isVisible() && label->text().contains("perilymph-cli study");
  }));
}

TEST_F(AStudy, IsFollowedByASmallerOneWhilePointsAreChosen)
{
  TemporaryFolder folder;
  const auto study = study::parseStudy(R"(
title = "Two insertions"
scenario = "mean-flex28"
seed = 1
depth = "full"
[cochleae]
virtual = 1
[vary]
array = ["flex24", "flex28"]
nodes = [30]
dt_ms = [10.0]
)",
                                       folder.path() / "study.toml");
  ASSERT_TRUE(study) << study.error().message;
  ASSERT_TRUE(study::runShard(*study, study::shardOf(study->size(), 1, 1), folder.path(), 1, {}));
  ASSERT_TRUE(study::mergeShards(folder.path()));
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  gui::StudiesPage& page = pageOf(rig);
  QTest::keyClick(&page.plot(), Qt::Key_End);  // the last of the many
  ASSERT_TRUE(page.plot().selected());
  page.open(folder.path() / study::mergedFile);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.columns()->size() == 2; }));
  page.plot().render();
  EXPECT_FALSE(page.plot().selected());
  EXPECT_EQ(page.plot().rows().size(), 2u);
}

TEST_F(AStudy, ThatIsNoneIsRefusedInOneSentence)
{
  WindowRig rig;
  rig.window().showPage("studies");
  const TemporaryFolder folder;
  const fs::path other = folder.path() / "other.sqlite";
  std::ofstream(other) << "a text";
  pageOf(rig).open(other);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !pageOf(rig).isBusy(); }));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig.label("studyStatus").contains("other.sqlite is not a study of Perilymph");
  })) << rig.label("studyStatus").toStdString();
  EXPECT_EQ(pageOf(rig).columns(), nullptr);
}

TEST_F(AStudy, OfMeasuresThatWereChangedByHandSaysSo)
{
  const TemporaryFolder folder;
  const fs::path changed = folder.path() / "changed.sqlite";
  const std::string note =
      "The measures of P-017 were changed by hand after the program wrote them. Do not use them as "
      "measured in a CT.";
  {
    study::StudyResult result;
    result.cochlea = "p.toml (measures changed by hand)";
    auto of = study::StudyFile::openToContinue(
        changed, {"One", "", "ab12", version(), 1, 0, 1, {note, "The measures of B"}});
    ASSERT_TRUE(of) << of.error().message;
    ASSERT_TRUE(of->append({result}) && of->close());
  }
  WindowRig rig;
  rig.window().showPage("studies");
  pageOf(rig).open(changed);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pageOf(rig).columns() != nullptr; }));
  EXPECT_EQ(rig.label("studyStatus").toStdString(), note);
  pageOf(rig).open(file());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pageOf(rig).columns()->size() == insertions; }));
  EXPECT_EQ(rig.label("studyStatus"), "");
}

TEST_F(AStudy, IsFilteredByArrayAndBySizeOfTheCochlea)
{
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  EXPECT_EQ(rig.label("studyCount"), "32 of 32 insertions");
  rig.click("study-array-flex24");
  EXPECT_EQ(rig.label("studyCount"), "16 of 32 insertions");
  EXPECT_EQ(pageOf(rig).plot().rows().size(), 16u);
  rig.type("studyMinA", "99");
  EXPECT_EQ(rig.label("studyCount"), "0 of 32 insertions");
  rig.click("resetStudyFilterButton");
  EXPECT_EQ(rig.label("studyCount"), "32 of 32 insertions");
}

TEST_F(AStudy, SaysWhichLimitIsNoNumberAndIsOpenedWithoutThoseOfTheStudyBefore)
{
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  rig.type("studyMinA", "abc");
  EXPECT_TRUE(rig.label("studyStatus").contains("“abc” is no number"))
      << rig.label("studyStatus").toStdString();
  EXPECT_EQ(rig.label("studyCount"), "32 of 32 insertions");
  rig.type("studyMinA", "99");
  EXPECT_EQ(rig.label("studyStatus"), "");
  rig.type("studyMaxA", "9");
  EXPECT_TRUE(rig.label("studyStatus").contains("Exchange the limits"));
  const auto columns = pageOf(rig).columns();
  pageOf(rig).open(file());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return pageOf(rig).columns() != columns; }));
  EXPECT_EQ(rig.label("studyCount"), "32 of 32 insertions");
}

TEST_F(AStudy, ShowsTheInsertionOfAPointThatIsClicked)
{
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  gui::StudyPlot& plot = pageOf(rig).plot();
  auto& view = *plot.findChild<gui::PlainVtkWidget*>();
  std::optional<std::uint32_t> there;
  QPoint place;
  for (int y = 0; y < view.height() && !there; y += 6)
    for (int x = 0; x < view.width() && !there; x += 6) {
      place = {x, y};
      there = plot.chart().pick(x, view.height() - y, 4.0);
    }
  ASSERT_TRUE(there);
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
  ASSERT_TRUE(plot.selected());
  EXPECT_EQ(*plot.selected(), *there);
  EXPECT_TRUE(rig.button("replayStudyButton").isEnabled());
}

TEST_F(AStudy, NamesSettingsAndCochleaeInWords)
{
  EXPECT_EQ(gui::inTheList(gui::settingTitle("ending")), "Outcome");
  EXPECT_EQ(gui::inTheList(gui::settingTitle("coupling")), "Input coupling");
  EXPECT_EQ(gui::inTheList(gui::settingTitle("stop_force_N")), "Force limit, mN");
  EXPECT_EQ(gui::valueText("stop_force_N", "0.1"), "100");
  EXPECT_EQ(gui::valueText("speed_mm_s", "0.35"), "0.35");
  EXPECT_EQ(gui::unitOf("peak_mN"), "mN");
  EXPECT_EQ(gui::levelText("medel-standard"), "MED-EL Standard");
  EXPECT_EQ(gui::levelText("soap-10"), "Soap 10 %: speed-independent");
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  QTest::keyClick(&pageOf(rig).plot(), Qt::Key_End);
  const auto labels = pageOf(rig).findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().startsWith("Simulated cochlea ");
  }));
  // each length under its name: the duct's by the formula of the other pages, from A and B
  const study::StudyResult& result = pageOf(rig).columns()->result(*pageOf(rig).plot().selected());
  const auto values = gui::valuesOf(result);
  const auto valueOf = [&](const char* name) {
    const auto found = std::ranges::find_if(
        values, [&](const auto& each) { return each.first == QLatin1String(name); });
    return found == values.end() ? QString() : found->second;
  };
  EXPECT_EQ(valueOf("Cochlear duct length, mm"),
            gui::numberText(inMillimeters(anatomy::ellipticCircularDuctLength(
                                millimeters(result.a_mm), millimeters(result.b_mm))),
                            1));
  EXPECT_EQ(valueOf("Scala tympani length, mm"), gui::numberText(result.scalaLength_mm, 1));
}

TEST_F(AStudy, NamesFrictionsAndWritesNumbersInTheLanguageOfTheWindow)
{
  EXPECT_EQ(gui::levelText("soap-10"), "Soap 10 %: speed-independent");
  gui::useLanguage(*QCoreApplication::instance(), QStringLiteral("de"));
  const QString friction = gui::levelText("soap-10"), speed = gui::valueText("speed_mm_s", "0.35");
  QString field, box;
  {
    WindowRig rig;
    rig.window().showPage("studies");
    pageOf(rig).findChild<QAbstractButton*>("emptyPageButton")->click();
    field = pageOf(rig).findChild<QLineEdit*>("newStudy-speed_mm_s-low")->text();
    box = rig.button("newStudy-friction-soap-10").text();
  }
  gui::useLanguage(*QCoreApplication::instance(), QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(friction, "Seife 10 %: geschwindigkeitsunabhängig");
  EXPECT_EQ(box, "Seife 10 %: geschwindigkeitsunabhängig");
  EXPECT_EQ(speed, "0,35");
  EXPECT_EQ(field, "0,35");
}

TEST_F(AStudy, IsWalkedThroughWithTheKeyboard)
{
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  gui::StudyPlot& plot = pageOf(rig).plot();
  const auto& angles = pageOf(rig).columns()->quantity("angle_deg")->values;
  QTest::keyClick(&plot, Qt::Key_End);  // the deepest
  ASSERT_TRUE(plot.selected());
  EXPECT_EQ(angles[*plot.selected()], *std::max_element(angles.begin(), angles.end()));
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_EQ(angles[*plot.selected()], *std::min_element(angles.begin(), angles.end()));
  const double lowest = angles[*plot.selected()];
  QTest::keyClick(&plot, Qt::Key_Up);
  EXPECT_GE(angles[*plot.selected()], lowest);
}

TEST_F(AStudy, IsReadRunAgainAndReplayedInSteps)
{
  Walk walk("studies");
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  gui::StudiesPage& page = pageOf(rig);
  rig.click("study-friction-tissue");
  QTest::keyClick(&page.plot(), Qt::Key_End);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.summary() != nullptr; }));
  page.plot().render();
  walk.step(1, rig.window());
  rig.click("replayStudyButton");
  ASSERT_TRUE(isReplaying(rig)) << rig.label("studyStatus").toStdString();
  EXPECT_EQ(rig.window().page(), "insert");
  EXPECT_TRUE(gui::subjectText(rig.window().insertion().replay().playback().scenario())
                  .startsWith("Simulated cochlea "))
      << gui::subjectText(rig.window().insertion().replay().playback().scenario()).toStdString();
  EXPECT_TRUE(rig.label("studyStatus").contains("as in the study"))
      << rig.label("studyStatus").toStdString();
  EXPECT_EQ(walk.left(), "");
}

TEST_F(AStudy, RunsAnInsertionOnceOnly)
{
  WindowRig rig;
  ASSERT_TRUE(open(rig));
  gui::StudiesPage& page = pageOf(rig);
  QTest::keyClick(&page.plot(), Qt::Key_Home);
  QTest::keyClick(&page.plot(), Qt::Key_Return);
  ASSERT_TRUE(isReplaying(rig));
  const fs::path recording = rig.window().insertion().replay().playback().file();
  const auto written = fs::last_write_time(recording);
  rig.window().showPage("studies");
  QTest::keyClick(&page.plot(), Qt::Key_Return);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().page() == "insert"; }));
  EXPECT_EQ(fs::last_write_time(recording), written);
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// The clinician's workflow: two recorded insertions are selected in the library, compared at a
// cursor, exported, and written as a report.

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <system_error>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/StatusLine.h"
#include "perilymph/database/Database.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

class Clinician : public testing::Test {
protected:
  Clinician()
  {
    rig_ = std::make_unique<WindowRig>(
        session::Overrides{{"stop_travel_mm", "2.0"}, {"speed_mm_s", "2.0"}});
  }

  /// Inserts to full depth with the button, and resets the array.
  void insertOnce()
  {
    rig_->click("insertPageButton");
    rig_->click("startButton");
    ASSERT_TRUE(WindowRig::waitUntil(
        [&] { return rig_->now().output.workflow == haptics::Workflow::finished; }));
    rig_->click("resetButton");
  }
  void openLibrary(int rows)
  {
    rig_->click("sessionsPageButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return list().model()->rowCount() == rows; }));
  }
  void compareBoth()
  {
    insertOnce();
    insertOnce();
    openLibrary(2);
    list().selectAll();
    rig_->click("compareButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return page().runs().size() == 2; }));
  }

  /// Chooses an entry by the keyboard.
  void chooseIn(const char* name, int index)
  {
    auto& box = *rig_->window().findChild<QComboBox*>(QLatin1String(name));
    while (box.currentIndex() != index)
      QTest::keyClick(&box, box.currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
  }

  QTableView& list() { return *rig_->window().findChild<QTableView*>("sessionList"); }
  QTableWidget& table() { return *rig_->window().findChild<QTableWidget*>("comparisonTable"); }
  gui::ComparePage& page() { return *rig_->window().findChild<gui::ComparePage*>(); }
  gui::ComparisonPlot& plot() { return *rig_->window().findChild<gui::ComparisonPlot*>(); }
  QString cell(int row, const char* header)
  {
    for (int column = 0; column < table().columnCount(); ++column)
      if (table().horizontalHeaderItem(column)->text().startsWith(QLatin1String(header)))
        return table().item(row, column)->text();
    return QStringLiteral("no column ") + QLatin1String(header);
  }

  DataFolder data_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(Clinician, SeesTheForceOfEachRunAtTheCursor)
{
  compareBoth();
  EXPECT_EQ(rig_->window().page(), "compare");
  QTest::mouseClick(&plot(), Qt::LeftButton, Qt::NoModifier, QPoint(plot().width() / 12, 100));
  const double before_mm = plot().cursorPlace();
  QTest::keyClick(&plot(), Qt::Key_Right);
  EXPECT_NEAR(plot().cursorPlace(), before_mm + 0.1, 1e-9);
  for (int row = 0; row < 2; ++row) {
    const auto force = analysis::forceAt(
        analysis::curveOver(page().runs()[std::size_t(row)], analysis::CurveAxis::travel),
        plot().cursorPlace() * 1e-3);
    ASSERT_TRUE(force);
    EXPECT_NEAR(cell(row, "At ").section(QLatin1Char(' '), 0, 0).toDouble(), *force * 1e3, 0.051);
    EXPECT_EQ(plot().valuesAtCursor()[row].toStdString(),
              QStringLiteral("%1 mN").arg(gui::numberText(*force * 1e3, 1)).toStdString());
  }
  plot().setCursorPlace(16.0);  // the insertions end at 2 mm
  EXPECT_EQ(plot().valuesAtCursor(), QStringList({"–", "–"}));
}

TEST_F(Clinician, ReadsTheWholeVerbThatTheChosenRecordingsMakePrimary)
{
  insertOnce();
  insertOnce();
  openLibrary(2);
  list().selectAll();
  const auto& verb = rig_->button("compareButton");
  ASSERT_TRUE(verb.property("primary").toBool());
  QPushButton same(verb.text());
  same.setFont(verb.font());
  same.setProperty("primary", true);
  same.ensurePolished();
  EXPECT_GE(verb.width(), same.sizeHint().width());
}

TEST_F(Clinician, SeesThatARecordingWasChangedByHand)
{
  insertOnce();
  insertOnce();
  openLibrary(2);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(sessionFolder()))
    if (entry.path().extension() == ".insertion") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  ASSERT_EQ(files.size(), 3u);  // the next one has begun
  files.pop_back();
  {
    auto database = database::Database::openNew(files[0]);
    ASSERT_TRUE(database) << database.error().message;
    ASSERT_TRUE(database->run("UPDATE meta SET value = '9' WHERE key = 'seed'"));
  }
  page().compare(files);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page().runs().size() == 2; }));
  rig_->window().showPage("compare");
  for (int row = 0; row < 2; ++row)
    EXPECT_EQ(table().item(row, 0)->text().contains("changed by hand"), row == 0);
  keepPicture(rig_->window(), "compare-changed-by-hand");
}

TEST_F(Clinician, ReadsPeakWorkAndReasonsInNumbersWithUnits)
{
  compareBoth();
  for (int row = 0; row < 2; ++row) {
    EXPECT_TRUE(cell(row, "Peak force").endsWith(" mN"));
    EXPECT_TRUE(cell(row, "at depth").endsWith(" mm"));
    EXPECT_TRUE(cell(row, "Insertion work").endsWith(" mJ"));
    EXPECT_EQ(cell(row, "Mean speed"), "2.00 mm/s");
    EXPECT_TRUE(cell(row, "Insertion time").endsWith(" s"));
    EXPECT_EQ(cell(row, "Reversals"), "0");
    EXPECT_TRUE(cell(row, "Score").endsWith("of 100"));
  }
  const QString reasons = rig_->label("scoreReasons");
  for (const char* word : {"speed", "reversals", "peak force", "smoothness", "Kesler", "Rau"})
    EXPECT_TRUE(reasons.contains(QLatin1String(word))) << word;
}

TEST_F(Clinician, ExportsTableCurvesAndFigure)
{
  compareBoth();
  const TemporaryFolder folder;
  const auto written = page().writeInto(folder.path());
  ASSERT_TRUE(written) << written.error().message;
  const auto rows = readWhole(folder / "comparison.csv");
  ASSERT_TRUE(rows);
  EXPECT_EQ(std::count(rows->begin(), rows->end(), '\n'), 3);  // a header and two insertions
  const auto curves = readWhole(folder / "curves.svg");
  ASSERT_TRUE(curves);
  EXPECT_NE(curves->find("published measurements"),
            std::string::npos);  // of the published experiment
  EXPECT_FALSE(QImage(QString::fromStdString((folder / "curves.png").string())).isNull());
}

TEST_F(Clinician, ComparesOverTheAngle)
{
  compareBoth();
  chooseIn("comparisonAxis", 2);
  EXPECT_EQ(plot().content().axis, analysis::CurveAxis::angle);
  EXPECT_FALSE(plot().content().published);  // printed over travel
  // the tip is some degrees inside when the insertion begins
  const auto& curve = page().runs()[0].overAngle;
  ASSERT_GT(curve.size(), 2u);
  const analysis::AxisPoint& point = curve[curve.size() / 2];
  const double place_deg = inDegrees(radians(point.place));
  plot().setCursorPlace(place_deg);
  EXPECT_EQ(table().horizontalHeaderItem(1)->text(),
            QStringLiteral("At %1°").arg(gui::numberText(place_deg, 0)));
  EXPECT_NEAR(cell(0, "At ").section(QLatin1Char(' '), 0, 0).toDouble(), point.force * 1e3, 0.051);
  const TemporaryFolder folder;
  ASSERT_TRUE(page().writeInto(folder.path()));
  const auto curves = readWhole(folder / "curves.csv");
  ASSERT_TRUE(curves);
  EXPECT_EQ(curves->substr(0, 10), "angle_deg,");
  chooseIn("comparisonAxis", 0);
  EXPECT_TRUE(plot().content().published);
}

TEST_F(Clinician, ReadsMeanAndNumberOfOneGroup)
{
  compareBoth();
  auto& groups = *rig_->window().findChild<QTableWidget*>("groupsTable");
  EXPECT_FALSE(groups.isVisible());
  chooseIn("comparisonGroups", 2);
  EXPECT_TRUE(groups.isVisible());
  EXPECT_FALSE(table().isVisible());
  ASSERT_EQ(groups.columnCount(), 2);  // nothing to differ from
  EXPECT_EQ(groups.horizontalHeaderItem(1)->text(), "standard, n = 2");
  const TemporaryFolder folder;
  ASSERT_TRUE(page().writeInto(folder.path()));
  EXPECT_TRUE(fs::exists(folder / "groups.csv"));
  EXPECT_TRUE(fs::exists(folder / "differences.csv"));
}

/// An insertion of the published experiment with few nodes.
void record(const fs::path& file, const session::Overrides& overrides)
{
  const auto scenario = session::loadScenario("contour-published", overrides);
  ASSERT_TRUE(scenario) << scenario.error().message;
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      file);
  ASSERT_TRUE(insertion) << insertion.error().message;
  ASSERT_TRUE((*insertion)->runToEnd([](const haptics::TickRecord&) { return true; }, 60'000));
  ASSERT_TRUE((*insertion)->closeRecording());
}

TEST_F(Clinician, ComparesTwoTechniquesOfFiveRecordingsEach)
{
  const TemporaryFolder folder;
  std::vector<fs::path> files;
  const std::pair<const char*, const char*> settings[] = {
      {"11.0", "0.8"}, {"11.3", "1.0"}, {"11.6", "1.3"}, {"11.9", "1.7"}, {"12.2", "2.0"}};
  for (const char* technique : {"standard", "aos"})
    for (const auto& [stop_mm, speed] : settings) {
      files.push_back(folder / (std::string(technique) + stop_mm + ".insertion"));
      record(files.back(), {{"technique", technique},
                            {"stop_travel_mm", stop_mm},
                            {"speed_mm_s", speed},
                            {"nodes", "30"}});
    }
  page().compare(files);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page().runs().size() == 10; }));
  chooseIn("comparisonAxis", 2);
  chooseIn("comparisonGroups", 2);
  ASSERT_EQ(plot().content().curves.size(), 2u);
  auto& groups = *rig_->window().findChild<QTableWidget*>("groupsTable");
  // textbook formulas over the peaks, in mN; advance off-stylet is the first group by name
  double mean[2] = {}, variance[2] = {};
  for (std::size_t i = 0; i < 10; ++i)
    mean[i < 5 ? 1 : 0] += page().runs()[i].profile.peak.force * 1e3 / 5.0;
  for (std::size_t i = 0; i < 10; ++i) {
    const double off = page().runs()[i].profile.peak.force * 1e3 - mean[i < 5 ? 1 : 0];
    variance[i < 5 ? 1 : 0] += off * off / 4.0;
  }
  EXPECT_EQ(groups.horizontalHeaderItem(3)->text(), "advance off-stylet − standard, 95 %");
  EXPECT_TRUE(rig_->label("mixedGroups")
                  .contains("standard mixes insertions that differ in set "
                            "speed, stop"))
      << rig_->label("mixedGroups").toStdString();
  ASSERT_EQ(groups.item(1, 0)->text(), "peak insertion force");
  for (int group = 0; group < 2; ++group)
    EXPECT_EQ(
        groups.item(1, 1 + group)->text().toStdString(),
        QStringLiteral("%1 ± %2 mN")
            .arg(gui::numberText(mean[group], 0), gui::numberText(std::sqrt(variance[group]), 0))
            .toStdString());
  EXPECT_TRUE(groups.item(1, 3)->text().startsWith(gui::numberText(mean[0] - mean[1], 0) + " ("));
  plot().setCursorPlace(
      100.0);  // the mean curve with its deviation, as in the first row of the table
  for (int group = 0; group < 2; ++group)
    EXPECT_EQ(plot().valuesAtCursor()[group].toStdString(),
              groups.item(0, 1 + group)->text().toStdString());
  int turns = 0;  // of the event loop: the table has its height
  ASSERT_TRUE(WindowRig::waitUntil([&] { return ++turns > 20; }));
  EXPECT_EQ(groups.verticalScrollBar()->maximum(), 0);  // every row is seen
  EXPECT_LE(groups.mapTo(&page(), groups.rect().bottomLeft()).y(), page().height());
  keepPicture(rig_->window(), "compare-two-techniques");
  chooseIn("comparisonGroups", 0);
  keepPicture(rig_->window(), "compare-ten");
}

TEST_F(Clinician, PutsAReferenceBehindTheNextInsertionIsWarnedAndRemovesIt)
{
  insertOnce();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() == 0.0; }));
  const QImage withoutReference = rig_->picture();
  openLibrary(1);
  rig_->click("ghostButton");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig_->label("sessionStatus").contains("reference"); }));
  rig_->click("insertPageButton");
  EXPECT_TRUE(rig_->label("referenceName").contains("contour-published"));
  const auto* warning = rig_->window().findChild<QLabel*>("referenceWarning");
  EXPECT_FALSE(warning->isVisible());
  EXPECT_NE(rig_->picture(), withoutReference);  // its array, too
  rig_->choose("arraySelector", "flex28");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return warning->isVisible(); }));
  EXPECT_TRUE(warning->text().contains("another array (Nucleus 24 Contour)"))
      << warning->text().toStdString();
  EXPECT_FALSE(warning->text().contains("cochlea"));
  rig_->choose("anatomySelector", "mean");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return warning->text().contains("another cochlea"); }));
  rig_->click("removeReferenceButton");
  EXPECT_FALSE(rig_->window().findChild<QLabel*>("referenceName")->isVisible());
  rig_->click("restoreButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->picture() == withoutReference; }));
}

TEST_F(Clinician, IsLedFromAnEmptyComparisonToTheRecordings)
{
  rig_->click("comparePageButton");
  page().findChild<QAbstractButton*>("emptyPageButton")->click();
  EXPECT_EQ(rig_->window().page(), "sessions");
}

TEST_F(Clinician, SeesArrayTechniqueAndPatientOfEachRow)
{
  compareBoth();
  for (int row = 0; row < 2; ++row)
    for (const char* part : {"Nucleus 24 Contour", "standard", "published", "right ear"})
      EXPECT_TRUE(cell(row, "Insertion").contains(QLatin1String(part))) << part;
  EXPECT_TRUE(cell(0, "Tip angle").endsWith("°"));
}

TEST_F(Clinician, SavesIntoTheFolderOfDocuments)
{
  compareBoth();
  QString folder;
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    folder = dialog->directory().absolutePath();
    dialog->reject();
  });
  watch.start(20);
  rig_->click("exportButton");
  EXPECT_EQ(folder, gui::documentsFolder());
  EXPECT_FALSE(folder.contains("perilymph/sessions"));
}

TEST_F(Clinician, WritesAReportThatCanBeReadAgain)
{
  insertOnce();
  openLibrary(1);
  const fs::path pdf = data_.path() / "report.pdf";
  for (const auto& entry : fs::directory_iterator(sessionFolder()))
    if (entry.path().extension() == ".insertion" &&
        entry.path() != rig_->window().control().recording())
      rig_->window().findChild<gui::SessionsPage*>()->saveReport(entry.path(), {pdf});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return fs::exists(pdf); }));
  ProgramOutcome read;
  try {
    read = run({.program = "pdftotext",
                .arguments = {"-layout", pdf.string(), "-"},
                .environment = {},
                .folder = {}});
  } catch (const std::system_error&) {
    GTEST_SKIP() << "pdftotext is not installed. Install the package poppler-utils.";
  }
  ASSERT_EQ(read.status, 0) << read.err;
  for (const std::string& caption :
       {std::string("For research and training"), std::string("Not a medical device"),
        std::string("Peak insertion force"), std::string("Replay verified"), std::string("SHA-256"),
        buildId(), std::string("Nucleus 24 Contour"), std::string("Static friction"),
        std::string("Kesler et al. 2017"), std::string("Limits")})
    EXPECT_NE(read.out.find(caption), std::string::npos) << caption;
}

}  // namespace
}  // namespace perilymph::test

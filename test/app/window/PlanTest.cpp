// SPDX-License-Identifier: BSD-3-Clause

// The page Plan, with small plans of a coarse model.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QAbstractButton>
#include <QAbstractItemDelegate>
#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QTableWidget>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "SaveDialog.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/plan/ContactTable.h"
#include "gui/pages/plan/PlanList.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/plan/PlanScene.h"
#include "gui/pages/plan/PlanView.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/widgets/Notice.h"
#include "gui/widgets/Selector.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// Folders of its own for patients and plans, and a scenario whose insertions take little time.
class APlan : public testing::Test {
protected:
  static gui::PlanPage& pageOf(WindowRig& rig)
  {
    auto& page = *rig.window().findChild<gui::PlanPage*>();
    return page;
  }
  /// Chooses the first shipped patient, as nobody is chosen in a folder without patients.
  static void chooseExample(WindowRig& rig)
  {
    const auto& patients = *rig.window().findChild<QComboBox*>("planPatientSelector");
    rig.choose("planPatientSelector", patients.itemData(0).toString().toUtf8());
  }
  /// Shows the page with these arrays chosen.
  gui::PlanPage& show(WindowRig& rig, const std::vector<std::string>& arrays, const char* draws)
  {
    rig.click("planPageButton");
    gui::PlanPage& page = pageOf(rig);
    // the guide's pictures show the shipped scenario
    if (!qEnvironmentVariableIsSet("PERILYMPH_GUIDE_PICTURES")) page.setScenario(scenario());
    chooseExample(rig);
    rig.click("planNoArraysButton");
    for (const std::string& array : arrays) rig.click(("plan-array-" + array).c_str());
    rig.choose("planDraws", draws);
    return page;
  }
  /// Every number of the table has its unit, and every column says how its values are obtained.
  static void expectUnits(const QAbstractItemModel& rows)
  {
    ASSERT_EQ(rows.rowCount(), 2);
    const QStringList units{"",   "°",     "%",     "mN",    "mN",    "mN",
                            "mN", "of 16", "of 16", "of 16", "of 16", "of 16"};
    for (int column = 0; column < units.size(); ++column) {
      EXPECT_GT(rows.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().size(), 40);
      // what bands hold is said once, above the table
      EXPECT_FALSE(rows.headerData(column, Qt::Horizontal).toString().contains("friction"));
      for (int row = 0; row < rows.rowCount(); ++row) {
        const QString text = rows.index(row, column).data().toString();
        EXPECT_TRUE(text.endsWith(units[column])) << text.toStdString();
      }
    }
    EXPECT_TRUE(rows.headerData(2, Qt::Horizontal, Qt::ToolTipRole).toString().contains("differ"));
  }
  static void expectSorting(gui::PlanList& list)
  {
    const QAbstractItemModel& rows = *list.model();
    const auto value = [&](int row, int column) {
      return rows.index(row, column).data(gui::PlanTable::sortRole).toDouble();
    };
    for (const int column : {1, 3, 6, 7}) {
      list.sortByColumn(column, Qt::AscendingOrder);
      EXPECT_LE(value(0, column), value(1, column)) << column;
      list.sortByColumn(column, Qt::DescendingOrder);
      EXPECT_GE(value(0, column), value(1, column)) << column;
    }
  }
  static bool isDone(gui::PlanPage& page)
  {
    return WindowRig::waitUntil([&] { return page.plan() && !page.isBusy(); });
  }
  std::string scenario() const
  {
    const fs::path file = folder_.path() / "coarse.toml";
    std::ofstream(file) << "title = 'coarse'\narray = 'flex28'\nanatomy = 'mean'\n"
                           "friction = 'estimate-from-pig-tissue'\nnodes = 20\ndt_ms = 10.0\n"
                           "start_inside_mm = 1.0\nstop_travel_mm = 20.0\n";
    return file.string();
  }
  /// Carries an array to the page Insert, whose chart shows the plan behind it.
  static void expectInsertion(WindowRig& rig, gui::PlanPage& page, Walk& walk)
  {
    page.list().selectRow(0);
    const std::string name = page.list().model()->index(0, 0).data().toString().toStdString();
    rig.click("insertPlanArrayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      return rig.window().page() == "insert" &&
             rig.window().control().scenario().array().name == name &&
             rig.button("startButton").isEnabled();
    }));
    const session::Scenario& scenario = rig.window().control().scenario();
    EXPECT_EQ(scenario.patient().basalTurn->a, page.plan()->request.patient.basalTurn->a);
    gui::ForceCharts& charts = *rig.window().views().charts();
    ASSERT_TRUE(charts.plan());
    EXPECT_TRUE(charts.showPlanIn(scenario));
    EXPECT_FALSE(charts.plan()->points.empty());
    EXPECT_TRUE(charts.plan()->label.contains(
        "lowest to highest of 16 simulations over friction 0.08 to 0.33"))
        << charts.plan()->label.toStdString();
    settle();
    keepPicture(rig.window(), "plan-inserted");
    walk.step(4, rig.window());
    rig.choose("arraySelector", "medel-standard");  // the plan is of another array
    ASSERT_TRUE(WindowRig::waitUntil(
        [&] { return rig.window().control().scenario().arrayName() == "medel-standard"; }));
    EXPECT_FALSE(charts.showPlanIn(rig.window().control().scenario()));
    rig.click("planPageButton");
  }
  /// Opens one array, then both, with the keyboard.
  static void expectArrayAndComparison(WindowRig& rig, gui::PlanPage& page, Walk& walk)
  {
    page.list().selectRow(0);
    QTest::keyClick(&page.list(), Qt::Key_Return);
    ASSERT_TRUE(WindowRig::waitUntil([&] { return page.view().shownScenes() == 1; }))
        << rig.label("planStatus").toStdString();
    const auto& contacts = *page.findChild<QTableWidget*>("planContacts");
    EXPECT_EQ(contacts.rowCount(), 12);
    EXPECT_TRUE(contacts.item(0, 2)->text().endsWith("°"));
    EXPECT_TRUE(contacts.item(0, 3)->text().endsWith(" mm"));
    EXPECT_TRUE(contacts.item(0, 4)->text().endsWith("Hz"));
    EXPECT_TRUE(contacts.item(0, 7)->text().endsWith(" st"));
    settle();
    keepPicture(rig.window(), "plan-array");
    walk.step(3, rig.window());
    rig.click("planTableButton");
    page.list().selectAll();
    EXPECT_EQ(rig.button("openPlanArrayButton").text(), "Compare 2 arrays");
    rig.click("openPlanArrayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return page.view().shownScenes() == 2; }));
    expectLinked(page.view());
    settle();
    keepPicture(rig.window(), "plan-compared");
    EXPECT_TRUE(page.cancel());  // Esc leads back to the table
    EXPECT_TRUE(page.list().isVisible());
  }
  /// A turn of the first picture turns the second.
  static void expectLinked(gui::PlanView& view)
  {
    const auto axis = [&view](std::size_t place) {
      double away[3];
      view.scene(place).scene()->renderer().GetActiveCamera()->GetDirectionOfProjection(away);
      return Eigen::Vector3d(away[0], away[1], away[2]);
    };
    const Eigen::Vector3d before = axis(1);
    gui::PlanScene& first = view.scene(0);
    QTest::mousePress(&first, Qt::LeftButton, Qt::NoModifier, QPoint(40, 40));
    QMouseEvent move(QEvent::MouseMove, QPointF(40, 90), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&first, &move);
    QTest::mouseRelease(&first, Qt::LeftButton, Qt::NoModifier, QPoint(40, 90));
    EXPECT_GT((axis(1) - before).norm(), 0.1);
    EXPECT_LT((axis(1) - axis(0)).norm(), 1e-9);
  }
  static void settle()
  {
    for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();
  }
  static std::string jsonOf(gui::PlanPage& page)
  {
    const auto json = planning::planJson(*page.plan());
    return json ? *json : json.error().message;
  }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
};

/// Fewer simulations than users are offered, for this process and those that it starts.
class FewDraws {
public:
  FewDraws() { qputenv(fewDraws, "1"); }
  ~FewDraws() { qunsetenv(fewDraws); }
  FewDraws(const FewDraws&) = delete;
  FewDraws& operator=(const FewDraws&) = delete;
};

TEST_F(APlan, MadeAtTheCommandLineOpensByItsNameWithTheNumbersOfItsFile)
{
  const FewDraws few;
  const fs::path array = folder_ / "arrays/mine.toml", made = folder_ / "made";
  fs::create_directories(array.parent_path());
  fs::copy_file(resource("plugins/electrodes/med-el/flex24.toml"), array);
  ProgramCall call{programFolder() / "perilymph-cli",
                   {"plan", "--patient", "measured", "--arrays", "contour", "arrays/mine.toml",
                    "--samples", "3", "--seed", "5000000000", "--out", "made"},
                   {},
                   folder_.path()};
  const ProgramOutcome outcome = run(call);
  ASSERT_EQ(outcome.status, 0) << outcome.err;

  using Json = nlohmann::json;
  const auto arraysOf = [](const std::string& text) {
    Json arrays = Json::parse(text)["arrays"];
    for (Json& each : arrays)
      each.erase("array");  // the place of a file, as it was given or absolute
    return arrays;
  };
  const auto written = readWhole(made / "plan.json");
  ASSERT_TRUE(written);
  const Json expected = arraysOf(*written);
  WindowRig rig;
  gui::PlanPage& page = pageOf(rig);
  rig.window().openFile(made / "plan.json");
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_TRUE(page.plan()->isCurrent) << rig.label("planStatus").toStdString();
  EXPECT_EQ(rig.label("planStatus"), "");
  EXPECT_EQ(arraysOf(jsonOf(page)), expected);
  const QAbstractItemModel& rows = *page.list().model();
  ASSERT_EQ(rows.rowCount(), 2);
  for (int row = 0; row < 2; ++row) {
    const auto of = [&](const Json& each) {
      return each["name"] == rows.index(row, 0).data().toString().toStdString();
    };
    const auto found = std::find_if(expected.begin(), expected.end(), of);
    ASSERT_NE(found, expected.end());
    const QString median = QString::number((*found)["angle_deg"]["median"].get<double>(), 'f', 0);
    EXPECT_TRUE(rows.index(row, 1).data().toString().startsWith(median)) << row;
  }
  page.list().selectAll();
  rig.click("openPlanArrayButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return page.view().shownScenes() == 2; }))
      << rig.label("planStatus").toStdString();

  // moved to where the path that was given leads nowhere
  const fs::path moved = folder_ / "elsewhere/deeper/plan";
  fs::create_directories(moved.parent_path());
  fs::rename(made, moved);
  page.planFor(page.plan()->request.patient);
  rig.window().openFile(moved);
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_TRUE(page.plan()->isCurrent) << rig.label("planStatus").toStdString();
  EXPECT_EQ(arraysOf(jsonOf(page)), expected);

  // without the array's file, as on another machine: as it was made, and said so
  fs::remove(array);
  page.planFor(page.plan()->request.patient);
  rig.window().openFile(moved / "plan.json");
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_FALSE(page.plan()->isCurrent);
  EXPECT_EQ(page.plan()->seal, Seal::intact);
  EXPECT_TRUE(rig.label("planStatus").contains("it is shown as it was made"));
  ASSERT_EQ(page.plan()->arrays.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(page.plan()->arrays[i].angle_deg.median,
                expected[i]["angle_deg"]["median"].get<double>(), 1e-3);
}

TEST_F(APlan, OfAFormerCommandLineIsRefusedWithWhatToDo)
{
  std::ofstream(folder_ / "plan.json") << "{}";
  WindowRig rig;
  rig.window().openFile(folder_ / "plan.json");
  EXPECT_TRUE(rig.label("planStatus").contains("but no plan.toml"))
      << rig.label("planStatus").toStdString();
}

TEST_F(APlan, IsExplainedBeforeOneIsMade)
{
  WindowRig rig;
  rig.click("planPageButton");
  EXPECT_EQ(rig.window().page(), "plan");
  const auto labels = pageOf(rig).findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->isVisible() && label->text().contains("press Compute");
  }));
  // nobody's cochlea is planned unless it is chosen
  EXPECT_FALSE(rig.button("computePlanButton").isEnabled());
  EXPECT_EQ(rig.button("computePlanButton").toolTip(), "Choose a patient with A and B first.");
  const auto& patients = *rig.window().findChild<QComboBox*>("planPatientSelector");
  EXPECT_EQ(patients.currentText(), "Choose a patient");
  EXPECT_TRUE(patients.itemText(0).startsWith("Example: "));
  chooseExample(rig);
  EXPECT_TRUE(rig.button("computePlanButton").isEnabled());
  const auto& offer = *pageOf(rig).findChild<QPushButton*>("emptyPageButton");
  EXPECT_TRUE(offer.isVisible());
  rig.click("planNoArraysButton");
  EXPECT_FALSE(offer.isVisible());
  EXPECT_FALSE(rig.button("computePlanButton").isEnabled());
  EXPECT_EQ(rig.button("computePlanButton").toolTip(), "Choose an array first.");
}

TEST_F(APlan, IsOfferedWithSixteenSimulationsAndMore)
{
  WindowRig rig;
  rig.click("planPageButton");
  const auto& draws = *rig.window().findChild<QComboBox*>("planDraws");
  ASSERT_GT(draws.count(), 0);
  for (int i = 0; i < draws.count(); ++i) EXPECT_GE(draws.itemData(i).toInt(), 16);
  EXPECT_EQ(draws.currentData().toInt(), 64);
}

TEST_F(APlan, ShowsThePatientsMeasuresWithTheirErrors)
{
  anatomy::Patient patient;
  patient.label = "P-031";
  patient.side = anatomy::Side::left;
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.0), millimeters(6.6), std::nullopt};
  patient.errors = anatomy::BasalTurnErrors{millimeters(0.1), millimeters(0.2)};
  ASSERT_TRUE(gui::savePatientInLibrary(patient));
  WindowRig rig;
  rig.click("planPageButton");
  pageOf(rig).planFor(patient);
  EXPECT_TRUE(rig.label("planPatient").contains("P-031"));
  const QString measures = rig.label("planMeasures");
  EXPECT_TRUE(measures.contains("A 9.00 ± 0.20 mm")) << measures.toStdString();
  EXPECT_TRUE(measures.contains("B 6.60 ± 0.39 mm")) << measures.toStdString();
  EXPECT_TRUE(measures.contains("H not measured")) << measures.toStdString();
  EXPECT_FALSE(rig.label("planPatient").contains("changed by hand"));
  patient.seal = Seal::changed;
  pageOf(rig).planFor(patient);
  EXPECT_TRUE(rig.label("planPatient").contains("P-031 · left ear · measures changed by hand"));
  keepPicture(rig.window(), "plan-changed-by-hand");
}

TEST_F(APlan, IsMadeSeenInsertedAndOpenedAgainInSteps)
{
  Walk walk("planning");
  std::string made;
  {
    WindowRig rig;
    gui::PlanPage& page = show(rig, {"flex24", "flex28"}, "16");
    walk.step(1, rig.window());
    rig.click("computePlanButton");
    // before the first bands the page says what it computes, and how long it takes
    const auto isSaid = [&page](const char* text) {
      const auto labels = page.findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [text](const QLabel* each) {
        return each->isVisible() && each->text().contains(QString::fromUtf8(text));
      });
    };
    EXPECT_TRUE(isSaid("Computing the plan"));
    EXPECT_TRUE(isSaid("FLEX24 · FLEX28"));
    EXPECT_FALSE(isSaid("press Compute"));
    EXPECT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy() || isSaid(" left. "); }));
    EXPECT_TRUE(page.isBusy()) << "it said nothing of the time left";
    keepPicture(rig.window(), "plan-computing");
    ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
    settle();
    keepPicture(rig.window(), "plan-table");
    walk.step(2, rig.window());
    expectUnits(*page.list().model());
    EXPECT_TRUE(
        rig.label("planNote")
            .contains("bands: lowest to highest of 16 simulations over friction 0.08 to 0.33"))
        << rig.label("planNote").toStdString();
    expectSorting(page.list());
    const planning::ArrayPlan& first = page.plan()->arrays[0];
    EXPECT_EQ(first.draws, 16u);
    EXPECT_LT(first.angle_deg.low, first.angle_deg.high);
    made = jsonOf(page);
    const fs::path pdf = saveBy(rig, "planReportButton", {folder_.path()});
    EXPECT_THAT(pdf.filename().string(),
                testing::MatchesRegex("[A-Za-z0-9-]+-(right|left)-plan\\.pdf"));
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return rig.label("planStatus").contains("-plan.pdf"); }));
    EXPECT_GT(fs::file_size(pdf), 20'000u);
    expectArrayAndComparison(rig, page, walk);
    expectInsertion(rig, page, walk);
    auto* notes = page.findChild<QPlainTextEdit*>("planNotes");
    ASSERT_TRUE(notes->isEnabled());
    QTest::keyClicks(notes, "Steep approach.");
  }
  WindowRig rig;
  rig.click("planPageButton");
  chooseExample(rig);
  gui::PlanPage& page = pageOf(rig);
  auto* plans = page.findChild<QComboBox*>("planSelector");
  ASSERT_EQ(plans->count(), 2);
  rig.choose("planSelector", plans->itemData(1).toString().toUtf8());
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_EQ(jsonOf(page), made);
  EXPECT_EQ(page.findChild<QPlainTextEdit*>("planNotes")->toPlainText(), "Steep approach.");
  EXPECT_TRUE(page.findChild<QCheckBox*>("plan-array-flex24")->isChecked());
  EXPECT_FALSE(page.findChild<QCheckBox*>("plan-array-medel-standard")->isChecked());
  EXPECT_EQ(walk.left(), "");

  // other measures of this ear are in use now
  EXPECT_EQ(rig.label("planSuperseded"), "");
  anatomy::Patient other = page.plan()->request.patient;
  const QString old = QString::number(inMillimeters(other.basalTurn->a), 'f', 2);
  other.basalTurn->a = other.basalTurn->a + millimeters(0.3);
  const QString now = QString::number(inMillimeters(other.basalTurn->a), 'f', 2);
  ASSERT_TRUE(gui::savePatientInLibrary(other));
  rig.click("comparePageButton");
  rig.click("planPageButton");
  const QString sentence =
      "This plan is of A " + old + " mm; the measures in use are A " + now + " mm.";
  EXPECT_EQ(rig.label("planSuperseded"), sentence);
  keepPicture(rig.window(), "plan-superseded");
  page.list().selectRow(0);
  rig.click("insertPlanArrayButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().page() == "insert"; }));
  EXPECT_TRUE(rig.window().notice().sentence().startsWith(sentence))
      << rig.window().notice().sentence().toStdString();
}

TEST_F(APlan, GoesOnBehindAnotherPageAndContinuesAfterItWasCanceled)
{
  WindowRig rig;
  gui::PlanPage& page = show(rig, {"flex24"}, "16");
  rig.click("computePlanButton");
  ASSERT_TRUE(page.isBusy());
  rig.click("startPageButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.plan() != nullptr; }));  // the first 8 draws
  rig.click("planPageButton");
  rig.click("cancelPlanButton");
  EXPECT_FALSE(page.isBusy());
  const auto first = page.plan();
  EXPECT_EQ(first->arrays[0].draws, 8u);
  EXPECT_TRUE(rig.label("planStatus").contains("Canceled"));
  rig.click("computePlanButton");
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_EQ(page.plan()->arrays[0].draws, 16u);
  ASSERT_EQ(page.plan()->insertions.size(), 16u);
  for (std::size_t i = 0; i < first->insertions.size(); ++i) {
    EXPECT_EQ(page.plan()->insertions[i].insertion.peak, first->insertions[i].insertion.peak) << i;
    EXPECT_EQ(page.plan()->insertions[i].insertion.apical, first->insertions[i].insertion.apical);
  }
}

TEST_F(APlan, WithTheFrictionOfASimulantStopsEarlierAndSaysSo)
{
  WindowRig rig;
  gui::PlanPage& page = show(rig, {"flex28"}, "16");
  rig.click("computePlanButton");
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  const double usual_deg = page.plan()->arrays[0].angle_deg.median;
  EXPECT_FALSE(rig.label("planNote").contains("simulant"));
  rig.choose("planFriction", "tissue");
  rig.click("computePlanButton");
  ASSERT_TRUE(isDone(page)) << rig.label("planStatus").toStdString();
  EXPECT_LT(page.plan()->arrays[0].angle_deg.median, usual_deg - 60.0);
  EXPECT_TRUE(rig.label("planNote").contains("friction of a tissue simulant"));
  settle();
  keepPicture(rig.window(), "plan-simulant");
  page.list().selectRow(0);
  rig.click("insertPlanArrayButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig.window().page() == "insert" &&
           rig.window().control().scenario().friction().kineticCoefficient == 0.24;
  }));
  rig.click("planPageButton");
  // both are kept, each with its friction
  auto* plans = page.findChild<QComboBox*>("planSelector");
  ASSERT_EQ(plans->count(), 3);
  for (int i = 1; i < plans->count(); ++i) {
    rig.choose("planSelector", plans->itemData(i).toString().toUtf8());
    ASSERT_TRUE(isDone(page));
    const bool isSimulant = plans->itemText(i).contains("simulant");
    EXPECT_EQ(page.plan()->request.friction.has_value(), isSimulant);
    EXPECT_EQ(page.findChild<gui::Selector*>("planFriction")->value(), isSimulant ? "tissue" : "");
  }
}

TEST(AContactTable, IsWideEnoughForTheNumbersOfManyDraws)
{
  const planning::Plan plan = syntheticPlan(64);
  for (const std::size_t draws : {std::size_t{8}, std::size_t{64}, std::size_t{4096}}) {
    gui::ContactTable table(nullptr);
    std::vector<planning::ContactBand> contacts = plan.arrays[0].contacts;
    contacts[0].draws = draws;
    table.show(contacts, draws);
    QStyleOptionViewItem option;
    option.initFrom(&table);
    option.font = table.font();
    for (int row = 0; row < table.rowCount(); ++row)
      for (int column = 0; column < table.columnCount(); ++column) {
        const QModelIndex cell = table.model()->index(row, column);
        EXPECT_GE(table.columnWidth(column), table.itemDelegate()->sizeHint(option, cell).width())
            << cell.data().toString().toStdString();
      }
  }
}

TEST_F(APlan, ThatCannotBeKeptSaysSoInOneSentence)
{
  WindowRig rig;
  gui::PlanPage& page = show(rig, {"flex24"}, "16");
  std::ofstream(state_.path() / "perilymph") << "a file in place of the folder";
  rig.click("computePlanButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
  EXPECT_TRUE(rig.label("planStatus").contains("cannot be created"))
      << rig.label("planStatus").toStdString();
  EXPECT_TRUE(rig.button("computePlanButton").isEnabled());
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// The list of saved patients: tags, notes, archive, and what belongs to one of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTableWidget>
#include <QTest>
#include <fstream>
#include <regex>
#include <sstream>

#include "KeptPicture.h"
#include "OwnFolders.h"
#include "SaveDialog.h"
#include "WindowRig.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/report/InsertionResults.h"
#include "gui/report/MeasureTable.h"
#include "gui/report/ReportContent.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlanStore.h"
#include "gui/text/Numbers.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PatientRegistry.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

const std::string seriesHash = "5ca1ab1e" + std::string(56, '0');

/// Folders of its own with two patients, and their list.
class PatientList : public testing::Test {
protected:
  PatientList() : other_(save("P-019")), file_(save("P-018")) {}

  static anatomy::Patient patient(const char* code)
  {
    anatomy::Patient patient;
    patient.label = code;
    patient.side = anatomy::Side::left;
    patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
    patient.origin.seriesKey = seriesHash;
    return patient;
  }
  static fs::path save(const char* code)
  {
    const auto file = gui::savePatientInLibrary(patient(code));
    if (!file) throw std::runtime_error(file.error().message);
    auto record = *session::loadPatientRecord(*file);
    EXPECT_EQ(record.scans.size(), 1u);
    EXPECT_EQ(record.scans.front().series, seriesHash);
    record.scans.front().savedUtc = "2021-07-08T12:10:11Z";  // not when the test runs
    EXPECT_TRUE(session::savePatientRecord(record, *file));
    return *file;
  }

  /// Opens the list with a patient selected.
  void open(const char* code)
  {
    rig_ = std::make_unique<WindowRig>();
    rig_->window().activateWindow();
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->window().isActiveWindow(); }));
    openAgain(code);
  }
  void openAgain(const char* code)
  {
    rig_->window().showPage("start");
    rig_->click("allPatientsButton");
    select(code);
  }
  void select(const char* code)
  {
    const auto found = list().findItems(QLatin1String(code), Qt::MatchStartsWith);
    ASSERT_EQ(found.size(), 1);
    const QRect place = list().visualItemRect(found.front());
    QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
  }
  template <class Widget>
  Widget& find(const char* name)
  {
    auto* widget = rig_->window().findChild<Widget*>(QLatin1String(name));
    if (widget == nullptr) throw std::runtime_error(name);
    return *widget;
  }
  void typeNote(const char* text)
  {
    notes().setFocus();
    QTest::keyClicks(&notes(), QLatin1String(text));
  }
  QListWidget& list() { return find<QListWidget>("patientList"); }
  QPlainTextEdit& notes() { return find<QPlainTextEdit>("patientNotes"); }
  QTableWidget& history() { return find<QTableWidget>("patientHistory"); }
  void type(const char* field, const char* text)
  {
    auto& line = find<QLineEdit>(field);
    line.setText(QLatin1String(text));
    Q_EMIT line.editingFinished();
  }
  static std::string notesIn(const fs::path& file)
  {
    return session::loadPatientRecord(file)->notes;
  }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  fs::path other_, file_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(PatientList, SaysOfMeasuresThatTheyWereChangedByHandAndOfNoScanOfThem)
{
  const std::string forged(64, 'd');
  std::string text = *readWhole(file_);
  text.replace(text.find("9.1"), 3, "9.9");
  ASSERT_TRUE(writeWhole(file_, text.replace(text.find(seriesHash), 64, forged)));
  open("P-018");
  const QString mark = QStringLiteral("measures changed by hand");
  EXPECT_TRUE(rig_->label("patientDetailsName").contains(mark));
  EXPECT_EQ(list().findItems(QStringLiteral("changed by hand: A 9.90"), Qt::MatchContains).size(),
            1);
  EXPECT_EQ(list().findItems(QStringLiteral("changed by hand"), Qt::MatchContains).size(), 1);
  keepPicture(rig_->window(), "patient-changed-by-hand");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return history().rowCount() > 0; }));
  ASSERT_EQ(history().rowCount(), 1);  // the scan of the record
  for (int i = 0; i < history().columnCount(); ++i) {
    const auto* cell = history().item(0, i);
    EXPECT_FALSE(cell != nullptr && cell->text().contains(QLatin1String("dddd")));
  }
  select("P-019");
  EXPECT_FALSE(rig_->label("patientDetailsName").contains(mark));
}

TEST_F(PatientList, LosesNoNoteOfAnotherWindow)
{
  open("P-018");
  auto record = *session::loadPatientRecord(file_);
  record.notes = "theirs";
  ASSERT_TRUE(session::savePatientRecord(record, file_));  // another window saves
  typeNote("ours");
  select("P-019");
  EXPECT_TRUE(rig_->label("patientStatus").contains("Another program changed the record"));
  EXPECT_EQ(notesIn(file_), "theirs\n\nours");
  select("P-018");
  EXPECT_EQ(notes().toPlainText(), "theirs\n\nours");
}

TEST_F(PatientList, SaysWhichRecordWasChangedByHand)
{
  std::string text = *readWhole(session::recordFileOf(file_));
  text.replace(text.find("2021-07-08"), 10, "2020-07-08");
  std::ofstream(session::recordFileOf(file_)) << text;
  open("P-018");
  EXPECT_TRUE(rig_->label("patientDetailsName").contains("record changed by hand"));
  select("P-019");
  EXPECT_FALSE(rig_->label("patientDetailsName").contains("changed by hand"));
}

TEST_F(PatientList, SaysWhoseMeasuresWereChangedByHand)
{
  std::string text = *readWhole(file_);
  text.replace(text.find("9.1"), 3, "9.4");
  std::ofstream(file_) << text;
  open("P-018");
  EXPECT_TRUE(rig_->label("patientDetailsName").contains("measures changed by hand"));
  select("P-019");
  EXPECT_FALSE(rig_->label("patientDetailsName").contains("changed by hand"));
}

TEST_F(PatientList, FindsATagAndHidesTheArchived)
{
  open("P-018");
  ASSERT_EQ(list().count(), 2);
  type("patientTags", "EAS, revision");
  EXPECT_EQ(session::loadPatientRecord(file_)->tags, (std::vector<std::string>{"EAS", "revision"}));
  type("patientSearch", "revis");
  ASSERT_EQ(list().count(), 1);
  EXPECT_TRUE(list().item(0)->text().contains("EAS, revision"));

  rig_->click("archivePatientButton");
  EXPECT_TRUE(session::loadPatientRecord(file_)->isArchived);
  EXPECT_EQ(list().count(), 0);
  find<QAbstractButton>("showArchived").setChecked(true);
  EXPECT_EQ(list().count(), 1);
  rig_->click("archivePatientButton");
  EXPECT_FALSE(session::loadPatientRecord(file_)->isArchived);
  rig_->click("leavePickerButton");
  const auto isTagged = [&](const char* link) {
    return rig_->button(link).accessibleName().contains("EAS, revision");
  };
  EXPECT_NE(isTagged("recentPatient0"), isTagged("recentPatient1"));
}

TEST_F(PatientList, KeepsNotesWhenTheirFieldPatientOrPageIsLeft)
{
  open("P-018");
  EXPECT_TRUE(notes().placeholderText().contains("no names"));
  typeNote("Narrow round window.");
  QTest::keyClick(&notes(), Qt::Key_Tab);
  EXPECT_EQ(notesIn(file_), "Narrow round window.");
  EXPECT_TRUE(rig_->label("patientStatus").contains("P-018"));
  QTest::keyClick(&notes(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(notes().toPlainText(), "Narrow round window.");  // what is saved can be undone
  QTest::keyClick(&notes(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  typeNote(" Facial recess wide.");
  select("P-019");
  EXPECT_EQ(notes().toPlainText(), "");
  typeNote("Other ear.");
  rig_->click("leavePickerButton");
  EXPECT_EQ(notesIn(other_), "Other ear.");
  EXPECT_NE(notesIn(file_).find("wide."), std::string::npos);
  openAgain("P-018");
  EXPECT_EQ(notes().toPlainText().toStdString(), notesIn(file_));
  type("patientSearch", "other EAR");
  ASSERT_EQ(list().count(), 1);
  EXPECT_TRUE(list().item(0)->text().startsWith("P-019"));
}

TEST_F(PatientList, LosesNoNoteThatCannotBeSavedAndTakesNoneThatIsTooLong)
{
  open("P-018");
  const fs::path record = session::recordFileOf(file_);
  fs::remove(record);
  fs::create_directories(record / "a folder in its place");
  typeNote("Important.");
  select("P-019");
  EXPECT_TRUE(rig_->label("patientStatus").contains("P-018-left"));
  select("P-018");
  EXPECT_EQ(notes().toPlainText(), "Important.");
  fs::remove_all(record);
  rig_->click("leavePickerButton");
  EXPECT_EQ(notesIn(file_), "Important.");

  openAgain("P-018");
  notes().insertPlainText(QString(int(session::maxNotes), QChar(0xE4)));
  EXPECT_TRUE(rig_->label("patientStatus").contains("4000"));
  EXPECT_LE(notes().toPlainText().toUtf8().size(), int(session::maxNotes));
  rig_->click("leavePickerButton");
  EXPECT_EQ(notesIn(file_).size(), session::maxNotes);
}

/// A patient's left ear with a scan, a plan and an insertion.
class PatientHistoryPage : public PatientList {
protected:
  std::string scenario() const
  {
    const fs::path file = folder_.path() / "coarse.toml";
    std::ofstream(file) << "title = 'coarse'\narray = 'flex28'\nanatomy = 'mean'\n"
                           "friction = 'tissue'\nnodes = 20\ndt_ms = 10.0\n"
                           "start_inside_mm = 1.0\nstop_travel_mm = 4.0\n";
    return file.string();
  }
  /// A plan of 2022, after the scan of 2021.
  void plan() const
  {
    gui::StoredPlan stored;
    stored.request.patient = patient("P-018");
    stored.request.arrays = {"flex24", "flex28"};
    stored.request.scenario = scenario();
    stored.request.resolution.reset();
    stored.request.draws = 2;
    stored.folder = gui::folderOfPlan(stored.request);
    stored.shownDraws = 2;
    stored.isComplete = true;
    stored.madeUtc = "2022-02-03T12:05:06Z";
    ASSERT_TRUE(planning::savePlanFolder(stored));
    const auto made = planning::makePlan(stored.request, stored.folder / gui::planDrawsFile, {});
    ASSERT_TRUE(made) << made.error().message;
  }
  /// A recorded insertion into the patient's cochlea, and one into another's.
  void insert() const
  {
    for (const fs::path& patient : {file_, other_}) {
      const auto one = session::loadScenario(scenario(), {{"patient", patient.string()}});
      ASSERT_TRUE(one) << one.error().message;
      fs::create_directories(sessionFolder());
      auto insertion = session::Insertion::prepare(
          *one, std::make_unique<device::ScriptedDevice>(one->speed().si(), one->timeStep().si()),
          sessionFolder() / (patient.stem().string() + ".insertion"));
      ASSERT_TRUE(insertion) << insertion.error().message;
      ASSERT_TRUE((*insertion)->runToEnd(nullptr));
    }
  }
  void openHistory()
  {
    open("P-018");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return history().isVisible(); }));
    ASSERT_EQ(history().rowCount(), 3);
  }
  std::string cell(int row, int column)
  {
    return history().item(row, column)->text().toStdString();
  }
  void clickRow(int row)
  {
    const QRect place = history().visualItemRect(history().item(row, 2));
    QTest::mouseClick(history().viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
  }
};

TEST_F(PatientHistoryPage, IsNewestFirstAndOpenedByAClickOrEnter)
{
  plan();
  insert();
  openHistory();
  keepPicture(rig_->window(), "patient-history");
  EXPECT_EQ(cell(0, 1), "Insertion");
  EXPECT_TRUE(std::regex_match(cell(0, 2),
                               std::regex("FLEX28 · depth [0-9]+\\.[0-9] mm · peak [0-9.]+ mN")))
      << cell(0, 2);
  EXPECT_EQ(cell(1, 1), "Plan");
  EXPECT_EQ(cell(1, 2), "2 arrays · 2 simulations");
  EXPECT_EQ(cell(1, 0).substr(0, 10), "2022-02-03");
  EXPECT_EQ(cell(2, 1), "Scan");
  EXPECT_EQ(cell(2, 2), "series 5ca1ab1e0000");
  EXPECT_EQ(cell(2, 0).substr(0, 10), "2021-07-08");
  EXPECT_NE(history().item(2, 2)->toolTip().toStdString().find(seriesHash), std::string::npos);

  clickRow(1);
  ASSERT_EQ(rig_->window().page(), "plan");
  auto& page = *rig_->window().findChild<gui::PlanPage*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.plan() && !page.isBusy(); }))
      << rig_->label("planStatus").toStdString();
  EXPECT_EQ(page.plan()->request.patient.label, "P-018");
  EXPECT_EQ(page.plan()->arrays.size(), 2u);

  openAgain("P-018");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return history().isVisible(); }));
  clickRow(2);
  EXPECT_EQ(rig_->window().page(), "ct");
  EXPECT_TRUE(
      rig_->label("ctStatus").contains("P-018 was measured is no longer where it was read"));

  openAgain("P-018");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return history().isVisible(); }));
  notes().setFocus();
  QTest::keyClick(&notes(), Qt::Key_Tab);
  EXPECT_TRUE(history().hasFocus());
  QTest::keyClick(&history(), Qt::Key_Return);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->window().page() == "insert"; }));
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().findChild<gui::ReplayBar*>()->isVisible(); }));
}

TEST_F(PatientHistoryPage, HasEveryVersionOfTheMeasuresBesideTheOneInUse)
{
  anatomy::Patient other = gui::findSavedPatient("P-018", patient("P-018").side)->patient;
  const double before_mm = inMillimeters(other.basalTurn->a);
  other.basalTurn->a = other.basalTurn->a + millimeters(0.6);
  ASSERT_TRUE(session::savePatientVersion(other, file_, {"2031-07-08T09:10:11Z"}, false));
  open("P-018");
  const auto& versions = *rig_->window().findChild<QTableWidget*>("measureVersions");
  keepPicture(rig_->window(), "patient-measures");
  ASSERT_GE(versions.rowCount(), 2);
  EXPECT_TRUE(versions.item(0, 0)->text().startsWith("2031-07-08"));
  EXPECT_TRUE(versions.item(0, 1)->text().startsWith("in use: "));
  const auto start = [](double value_mm) {
    return QStringLiteral("%1 ± ").arg(value_mm, 0, 'f', 2);
  };
  EXPECT_TRUE(versions.item(0, 2)->text().startsWith(start(before_mm + 0.6)));
  EXPECT_TRUE(versions.item(1, 2)->text().startsWith(start(before_mm)));
  EXPECT_FALSE(versions.item(1, 1)->text().contains("in use"));
  // 0.6 mm is beyond what an error of 0.1 mm in each explains, B is the same
  EXPECT_TRUE(versions.item(1, 2)->toolTip().contains("+0.60 ± "));
  EXPECT_TRUE(versions.item(1, 2)->toolTip().contains("Beyond"));
  EXPECT_TRUE(versions.item(1, 3)->toolTip().contains("Within"));
}

TEST_F(PatientHistoryPage, IsSavedAsATableOfAllPatientsWithTheNumbersOfTheirReports)
{
  insert();
  open("P-018");
  const fs::path file = saveBy(*rig_, "exportTableButton", {folder_.path()});
  EXPECT_TRUE(std::regex_match(file.filename().string(),
                               std::regex("patients-[0-9]{4}-[0-9]{2}-[0-9]{2}\\.csv")))
      << file;
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig_->label("patientStatus").contains("The table is in");
  })) << rig_->label("patientStatus").toStdString();
  keepPicture(rig_->window(), "patients-table");
  EXPECT_TRUE(rig_->button("exportTableButton").isEnabled());
  // the same as by the command line
  const auto registry = planning::patientRegistry(planning::ownRegistryFolders());
  ASSERT_TRUE(registry) << registry.error().message;
  EXPECT_EQ(*readWhole(file), registry->csv);
  EXPECT_EQ(*readWhole(file.parent_path() / (file.stem().string() + "-dictionary.csv")),
            planning::registryDictionaryCsv());

  // a field of the row of P-018, which is the first; no field of these tables is quoted
  const auto split = [](const std::string& line) {
    return QString::fromStdString(line).split(QLatin1Char(','));
  };
  std::istringstream lines(registry->csv);
  std::string head, row;
  std::getline(lines, head);
  std::getline(lines, row);
  ASSERT_EQ(split(head).size(), split(row).size());
  const auto field = [&](const char* column) {
    return split(row)[split(head).indexOf(QLatin1String(column))];
  };
  EXPECT_EQ(field("code"), "P-018");
  const auto report = gui::gatherReport(sessionFolder() / "P-018-left.insertion", {});
  ASSERT_TRUE(report) << report.error().message;
  const auto results = gui::insertionResults(*report);
  const auto stated = [&results](const char* name) {
    const auto found = std::find_if(results.begin(), results.end(), [&](const auto& each) {
      return each.name == QLatin1String(name);
    });
    return found == results.end() ? QString() : found->value;
  };
  EXPECT_EQ(gui::forceNumber(field("insertion_peak_mN").toDouble()) + " mN",
            stated("Peak insertion force"));
  EXPECT_EQ(gui::forceNumber(field("insertion_end_mN").toDouble()) + " mN", stated("End force"));
  EXPECT_EQ(gui::numberText(field("insertion_depth_mm").toDouble(), 1) + " mm",
            stated("Insertion depth"));
  EXPECT_EQ(field("insertion_contacts_inside") + " of " + field("insertion_contacts"),
            stated("Contacts inside"));
  if (field("insertion_contacts_inside") != "0") {
    EXPECT_EQ(gui::numberText(field("insertion_angle_deg").toDouble(), 0) + QString::fromUtf8("°"),
              stated("Angular insertion depth"));
  }
  const auto rows =
      gui::basalTurnRows(gui::findSavedPatient("P-018", anatomy::Side::left)->patient);
  const double a = field("A_mm").toDouble();
  EXPECT_EQ(rows[0].value, gui::numberText(a, 2) + QString::fromUtf8(" ± ") +
                               gui::numberText(field("A_high_mm").toDouble() - a, 2) + " mm");
  EXPECT_EQ(
      gui::measureText(report->measures, report->bands, "cdl_oc_mm"),
      gui::numberText(field("cdl_oc_mm").toDouble(), 1) + QString::fromUtf8(" ± ") +
          gui::numberText(field("cdl_oc_high_mm").toDouble() - field("cdl_oc_mm").toDouble(), 1) +
          " mm");
}

TEST_F(PatientHistoryPage, IsThatOfTheSelectedEar)
{
  insert();
  open("P-019");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return history().isVisible(); }));
  ASSERT_EQ(history().rowCount(), 2);  // its own insertion and scan
  EXPECT_NE(history().item(0, 2)->toolTip().toStdString().find("P-019-left"), std::string::npos);
  EXPECT_EQ(cell(1, 1), "Scan");
}

}  // namespace
}  // namespace perilymph::test

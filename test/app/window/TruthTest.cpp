// SPDX-License-Identifier: BSD-3-Clause

// One truth: what window, reports, files, command line and Python say of one patient agrees, each read from
// the output itself. The tables below name every quantity and the outputs that carry it.

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "Readings.h"
#include "TheCtPage.h"
#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/plan/PlanTable.h"
#include "gui/report/InsertionReport.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A quantity: where a text has it, its decimals in window and reports, and the outputs that carry it.
struct Carried {
  const char* quantity;
  int decimals;
  std::vector<std::string> outputs;
};

const std::vector<std::string> measureOutputs{
    "anatomy text", "plan.json", "python", "plan report", "insertion report", "panel", "plan page"};
const std::vector<Carried> measures{
    {"A", 2, measureOutputs},
    {"B", 2, measureOutputs},
    {"H", 2, measureOutputs},
    {"duct length",
     1,
     {"anatomy text", "anatomy json", "python", "plan report", "insertion report", "panel"}}};
const std::vector<std::string> planOutputs{"plan table", "plan text", "plan.json",
                                           "arrays.csv", "python",    "plan report"};
const std::vector<Carried> plans{
    {"angular insertion depth", 0, planOutputs},
    {"coverage", 0, planOutputs},
    {"peak force", 0, planOutputs},
    {"partition force", 0, planOutputs},
    {"end force", 0, {"plan table", "plan text", "plan.json", "arrays.csv", "python"}}};
const std::vector<Carried> insertions{
    {"angular insertion depth of an insertion",
     0,
     {"simulate text", "simulate json", "contacts", "insertion report"}},
    {"tip angle",
     0,
     {"simulate text", "simulate json", "recording", "insertion report", "appendix", "sessions",
      "comparison"}},
    {"coverage of an insertion", 0, {"contacts", "insertion report"}},
    {"insertion depth", 1, {"simulate text", "simulate json", "recording", "insertion report"}},
    {"peak force of an insertion",
     1,
     {"simulate text", "simulate json", "recording", "insertion report", "appendix", "sessions",
      "comparison"}},
    {"duration", 1, {"simulate json", "recording", "sessions", "comparison"}}};

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string outputOf(const fs::path& program, std::vector<std::string> arguments)
{
  ProgramCall call{program, std::move(arguments), {}, {}};
  call.environment = {{fewDraws, "1"}, {"PYTHONPATH", (programFolder() / "../python").string()}};
  const ProgramOutcome outcome = run(call);
  EXPECT_EQ(outcome.status, 0) << program << ": " << outcome.err;
  return outcome.out;
}

/// The column of a CSV file with one row.
double cellOf(const std::string& csv, const std::string& column)
{
  std::istringstream head(csv), row(csv.substr(csv.find('\n') + 1));
  for (std::string name, cell; std::getline(head, name, ',') && std::getline(row, cell, ',');)
    if (name == column) return std::stod(cell);
  ADD_FAILURE() << "no column " << column;
  return 0.0;
}

/// The cell of a table below a header that begins so.
std::string cellOf(const QAbstractItemView& table, const char* header)
{
  const QAbstractItemModel& rows = *table.model();
  for (int column = 0; column < rows.columnCount(); ++column)
    if (rows.headerData(column, Qt::Horizontal).toString().startsWith(QLatin1String(header)))
      return rows.index(0, column).data().toString().toStdString();
  ADD_FAILURE() << "no column " << header;
  return {};
}

/// One patient, planned and inserted once by the command line, and what all outputs say of it.
class Patient {
public:
  /// @param file  The patient's file.
  explicit Patient(const fs::path& file) : file_(file)
  {
    const fs::path cli = programFolder() / "perilymph-cli";
    anatomy_ = outputOf(cli, {"anatomy", "--patient", file_, "--json", folder_ / "anatomy.json"});
    plan_ = outputOf(cli, {"plan", "--patient", file_, "--arrays", "flex24", "--samples", "1",
                           "--out", planFolder()});
    recording_ = sessionFolder() / (file_.stem().string() + ".insertion");
    fs::create_directories(recording_.parent_path());
    simulate_ = outputOf(
        cli, {"simulate", "--scenario", "mean-flex28", "--nodes", "40", "--patient", file_, "--set",
              "stop_travel_mm=12", "--json", folder_ / "simulate.json", "--record", recording_});
    python_ = Json::parse(outputOf("/usr/bin/python3", {"-c", pythonScript, file_, planFolder(),
                                                        recording_, folder_ / "simulate.json"}));
  }

  fs::path planFolder() const { return folder_ / "plan"; }
  Readings& readings() { return readings_; }

  void readMeasures()
  {
    const Json anatomy = jsonOf("anatomy.json"), plan = jsonOf("plan/plan.json")["patient"];
    const std::string report = planReport(), record = insertionReport();
    for (const std::string name : {"A", "B", "H"}) {
      readings_.addText(name, "anatomy text", anatomy_, name + "_mm");
      readings_.add(name, "plan.json", plan[name + "_mm"],
                    1.96 * plan[name + "_sd_mm"].get<double>());
      readings_.add(name, "python", python_["given"][name][0],
                    python_["given"][name][1].get<double>());
      readings_.addText(name, "plan report", report, name + ": [a-z -]+");
      readings_.addText(name, "insertion report", record, name + ": [a-z -]+");
    }
    const std::string duct = "duct length";
    readings_.addText(duct, "anatomy text", anatomy_, "\ncdl_oc_mm");
    readings_.add(duct, "anatomy json", anatomy["cdl_oc_mm"],
                  anatomy["derived"]["cdl_oc_mm"]["band"].get<double>());
    readings_.add(duct, "python", python_["duct"][0], python_["duct"][1].get<double>());
    readings_.addText(duct, "plan report", report, "Cochlear duct length \\(CDL\\)");
    readings_.addText(duct, "insertion report", record, "Cochlear duct length \\(CDL\\)");
  }

  void readPlan()
  {
    struct Band {
      const char *quantity, *key, *text;
      gui::PlanColumn column;
    };
    const Json array = jsonOf("plan/plan.json")["arrays"][0];
    const std::string csv = contentOf(planFolder() / "arrays.csv"), report = planReport();
    const std::string cell = "\\s+[0-9.]+ \\([^)]*\\)";
    std::string before = "1 FLEX24";
    const auto stored = planning::readPlan(planFolder());
    ASSERT_TRUE(stored) << stored.error().message;
    gui::PlanTable table(nullptr);
    table.setPlan(std::make_shared<const planning::Plan>(stored->plan));
    for (const Band& band :
         {Band{"angular insertion depth", "angle_deg", "angular insertion depth",
               gui::PlanColumn::angle},
          Band{"coverage", "coverage_percent", "cochlear coverage", gui::PlanColumn::coverage},
          Band{"peak force", "peak_mN", "peak insertion force", gui::PlanColumn::peak},
          Band{"partition force", "partition_mN", "force on the partition",
               gui::PlanColumn::partition},
          Band{"end force", "end_mN", "end force", gui::PlanColumn::end}}) {
      readings_.addText(band.quantity, "plan table",
                        table.index(0, int(band.column)).data().toString().toStdString(), "^");
      readings_.addText(band.quantity, "plan text", plan_, band.text);
      readings_.add(band.quantity, "plan.json", array[band.key]["median"]);
      readings_.add(band.quantity, "arrays.csv", cellOf(csv, std::string(band.key) + "_median"));
      readings_.add(band.quantity, "python", python_["plan"][band.key]);
      if (std::string(band.key) == "end_mN") continue;
      readings_.addText(band.quantity, "plan report", report, before);
      before += cell;
    }
  }

  void readInsertion()
  {
    const Json simulated = jsonOf("simulate.json"), recorded = python_["recording"];
    const std::string record = insertionReport();
    const std::string angular = "angular insertion depth of an insertion", tip = "tip angle",
                      coverage = "coverage of an insertion", depth = "insertion depth",
                      peak = "peak force of an insertion";
    readings_.addText(angular, "simulate text", simulate_, "angular insertion depth");
    readings_.add(angular, "simulate json", simulated["angular_insertion_depth_deg"]);
    readings_.add(angular, "contacts", python_["contacts"]["angle_deg"]);
    readings_.addText(angular, "insertion report", record, "Angular insertion depth");
    readings_.addText(tip, "simulate text", simulate_, "tip angle");
    readings_.add(tip, "simulate json", simulated["final_angle_deg"]);
    readings_.add(tip, "recording", recorded["deepest_angle_deg"]);
    readings_.addText(tip, "insertion report", record, "tip at");
    readings_.addText(tip, "appendix", record, "At the end +[0-9.]+ mm,");
    readings_.add(coverage, "contacts", python_["contacts"]["coverage_percent"]);
    readings_.addText(coverage, "insertion report", record, "Cochlear coverage");
    readings_.addText(depth, "simulate text", simulate_, "insertion depth");
    readings_.add(depth, "simulate json", simulated["final_depth_mm"]);
    readings_.add(depth, "recording", recorded["deepest_mm"]);
    readings_.addText(depth, "insertion report", record, "\\sInsertion depth");
    readings_.addText(peak, "simulate text", simulate_, "peak force");
    readings_.add(peak, "simulate json", 1e3 * simulated["peak_force_N"].get<double>());
    readings_.add(peak, "recording", 1e3 * recorded["peak_force_N"].get<double>());
    readings_.addText(peak, "insertion report", record, "Peak insertion force");
    readings_.addText(peak, "appendix", record.substr(record.find("Maximum wall force") - 400),
                      "Peak insertion force");
    readings_.add("duration", "simulate json", simulated["duration_s"]);
    readings_.add("duration", "recording", recorded["duration_s"]);
  }

  /// From a window of its own.
  void readWindow()
  {
    WindowRig rig({{"patient", file_.string()}, {"anatomy", "mean"}, {"array", "\"flex28\""}});
    // the start page's form has such labels, too, still empty
    QString duct;
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      for (const QLabel* each : rig.window().findChildren<QLabel*>("duct_length_mm"))
        if (each->text().contains("±")) duct = each->text();
      return !duct.isEmpty();
    }));
    for (const std::string name : {"A", "B", "H"}) {
      const auto* field =
          rig.window().findChild<QLineEdit*>(QString::fromStdString("panel" + name));
      const auto* place =
          rig.window().findChild<QLabel*>(QString::fromStdString("panel" + name + "Place"));
      const std::string error = place->text().toStdString();
      readings_.addText(name, "panel", field->text().toStdString() + error.substr(error.find(" ±")),
                        "^");
    }
    readings_.addText("duct length", "panel", duct.toStdString(), "^");

    rig.click("planPageButton");
    auto& plan = *rig.window().findChild<gui::PlanPage*>();
    const auto patient = anatomy::loadPatient(file_);
    ASSERT_TRUE(patient) << patient.error().message;
    plan.planFor(*patient);
    const std::string head = rig.label("planMeasures").toStdString();
    for (const std::string name : {"A", "B", "H"}) readings_.addText(name, "plan page", head, name);

    rig.click("sessionsPageButton");
    const auto& sessions = *rig.window().findChild<QAbstractItemView*>("sessionList");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return sessions.model()->rowCount() > 0; }));
    auto& compare = *rig.window().findChild<gui::ComparePage*>();
    compare.compare({recording_});
    const auto& compared = *rig.window().findChild<QTableWidget*>("comparisonTable");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return compared.rowCount() > 0; }));
    for (const auto& [quantity, inSessions, inComparison] :
         {std::tuple{"tip angle", "Tip", "Tip"},
          std::tuple{"peak force of an insertion", "Peak", "Peak"},
          std::tuple{"duration", "Insertion time", "Insertion time"}}) {
      readings_.addText(quantity, "sessions", cellOf(sessions, inSessions), "^");
      readings_.addText(quantity, "comparison", cellOf(compared, inComparison), "^");
    }
  }

private:
  static constexpr const char* pythonScript = R"(
import json, sys, perilymph
patient, plan, recording, simulated = sys.argv[1:]
one = perilymph.read_patient(patient)
cochlea = perilymph.Cochlea(one)
def given(name):
    sd = getattr(one, name + '_sd_mm')
    return [getattr(one, name + '_mm'), 1.96 * (0.1 if sd is None else sd)]
array = perilymph.read_plan(plan).arrays[0]
scenario = json.load(open(simulated))['scenario']
again = perilymph.simulate('mean-flex28', {'nodes': 40, 'patient': patient, 'stop_travel_mm': 12})
inside = [i for i, is_inside in enumerate(again.contacts['is_inserted']) if is_inside]
print(json.dumps({
    'given': {name.upper(): given(name) for name in 'abh'},
    'duct': [cochlea.measures()['cdl_oc_mm'], cochlea.measure_errors()['cdl_oc_mm']],
    'plan': {name: float(band[len(band) // 2]) for name, band in array.bands().items()},
    'contacts': {name: float(again.contacts[name][inside[0]]) for name in ('angle_deg', 'coverage_percent')},
    'recording': perilymph.read_recording(recording).highlights}))
)";

  Json jsonOf(const char* name) const { return Json::parse(contentOf(folder_ / name)); }

  std::string planReport() const
  {
    const fs::path pdf = folder_ / "plan.pdf";
    if (!fs::exists(pdf))
      outputOf(programFolder() / "perilymph",
               {"--plan", planFolder(), "--report", pdf, "--language", "en"});
    return outputOf("/usr/bin/pdftotext", {"-layout", pdf, "-"});
  }

  std::string insertionReport() const
  {
    const fs::path pdf = folder_ / "insertion.pdf";
    if (!fs::exists(pdf)) {
      const auto content = gui::gatherReport(recording_, {});
      EXPECT_TRUE(content) << content.error().message;
      EXPECT_TRUE(gui::writeReport(*content, pdf));
    }
    return outputOf("/usr/bin/pdftotext", {"-layout", pdf, "-"});
  }

  TemporaryFolder folder_;
  fs::path file_, recording_;
  std::string anatomy_, plan_, simulate_;
  Json python_;
  Readings readings_;
};

/// @param measured  What `ct measure` prints of the scan; empty if its measures are others.
void expectOneTruth(const fs::path& file, gui::CtPage* ct, const std::string& measured = {})
{
  Patient patient(file);
  patient.readMeasures();
  patient.readPlan();
  patient.readInsertion();
  patient.readWindow();
  for (const auto* table : {&measures, &plans, &insertions})
    for (const Carried& each : *table) {
      std::vector<std::string> outputs = each.outputs;
      if (ct != nullptr && table == &measures) {
        const bool isDuct = std::string(each.quantity) == "duct length";
        const QString label =
            isDuct ? QStringLiteral("fittedCdl") : QStringLiteral("fitted") + each.quantity;
        patient.readings().addText(each.quantity, "CT page",
                                   ct->findChild<QLabel*>(label)->text().toStdString(), "^");
        outputs.push_back("CT page");
        if (isDuct) {
          // all digits: roundings of two nearly equal numbers agree in most ears and not in all
          const ct::Measure& length = *ct->study().measures()->cdlOc;
          patient.readings().add(each.quantity, "CT fit", length.value, 1.96 * length.sd());
          outputs.push_back("CT fit");
        }
        if (!measured.empty()) {
          patient.readings().addText(each.quantity, "ct measure", measured,
                                     isDuct ? "CDL \\(OC\\)" : "\n" + std::string(each.quantity));
          outputs.push_back("ct measure");
        }
      }
      patient.readings().expectOne(each.quantity, outputs, each.decimals);
    }
}

/// Saves what a page CT shows, by its way onward to a plan.
fs::path savedBy(WindowRig& rig, const ct::CochleaMeasures& measured, const char* code)
{
  rig.type("ctPatientCode", code);
  rig.click("planCtButton");
  EXPECT_EQ(rig.window().page(), "plan");
  const bool isLeft = measured.side == anatomy::Side::left;
  return patientFolder() / (std::string(code) + (isLeft ? "-left.toml" : "-right.toml"));
}

TEST_F(TheCtPage, SaysTheSameOfTypedMeasuresEverywhere)
{
  fs::create_directories(patientFolder());
  const fs::path file = patientFolder() / "P-1-left.toml";
  std::ofstream(file)
      << "label = \"P-1\"\nside = \"left\"\na_mm = 8.84\nb_mm = 6.98\nh_mm = 3.94\n";
  expectOneTruth(file, nullptr);
}

TEST_F(TheCtPage, SaysTheSameOfAMeasuredCochleaEverywhere)
{
  measure();
  std::ostringstream at;
  at << std::setprecision(17);
  for (const double place : onDisk().phantom.inside_P) at << (at.tellp() > 0 ? "," : "") << place;
  const std::string measured =
      outputOf(programFolder() / "perilymph-cli",
               {"ct", "measure", onDisk().folder / "ct", "--at", at.str()});
  expectOneTruth(savedBy(rig_, *study().measures(), "P-2"), &page(), "\n" + measured);
}

TEST_F(TheCtPage, SaysTheSameOfCorrectedLandmarksEverywhere)
{
  measure();
  ct::CochleaMeasures steered = *study().measures();
  steered.marksByHand[ct::Mark::farWall] = study().marks()[ct::Mark::farWall];
  steered.marksByHand[ct::Mark::apex] = study().marks()[ct::Mark::apex];
  steered.h.value = std::round(100.0 * steered.h.value - 7.0) / 100.0;
  steered.h.definition += 0.05;
  study().setMeasures(steered);
  const fs::path file = savedBy(rig_, steered, "P-3");
  EXPECT_EQ(anatomy::loadPatient(file)->origin.landmarksByHand, "OW, A");
  expectOneTruth(file, &page());
}

}  // namespace
}  // namespace perilymph::test

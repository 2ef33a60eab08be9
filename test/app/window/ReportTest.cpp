// SPDX-License-Identifier: BSD-3-Clause

// The PDF report as read by poppler: one page for the record, and an appendix.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLineEdit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "OwnFolders.h"
#include "PdfReportRig.h"
#include "gui/program/Languages.h"
#include "gui/report/InsertionOutcome.h"
#include "gui/report/InsertionReport.h"
#include "gui/report/InsertionResults.h"
#include "gui/report/References.h"
#include "gui/report/ReportIssuer.h"
#include "gui/report/ReportParameters.h"
#include "gui/run/UserSettings.h"
#include "gui/setup/PlanStore.h"
#include "gui/shell/SettingsOverlay.h"
#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/ContourFromBelow.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(PdfReport, HasOnePageForTheRecordWithPatientEarAndMeasures)
{
  report("mean-flex28", {{"patient", leftPatient()}, {"stop_travel_mm", "6.0"}});
  EXPECT_THAT(text(), HasSubstr("Cochlea, measures ± 95 % interval")) << "no CT is named";
  const std::string record = text(1, 1);
  for (const char* words : {"Insertion report",
                            "left ear",
                            "FLEX28",
                            "MED-EL",
                            "basal-turn diameter",
                            "population mean",
                            "Cochlear duct length (CDL)",
                            "Cochlear coverage",
                            "Peak insertion force",
                            "End force",
                            "Force after 1 s of rest",
                            "Contacts inside",
                            "Angular insertion depth",
                            "Insertion depth",
                            "Insertion time",
                            "Maximum partition force",
                            "rupture assumed at 42–122 mN; original not available",
                            "fewer translocations than clinics report",
                            "Insertion force, mN over depth, mm",
                            "felt from 20 mN",
                            "Friction μ",
                            "Frequency, kHz",
                            "To modiolus, mm",
                            "Signature",
                            "Limits:",
                            "5 mm",
                            "270°"})
    EXPECT_THAT(record, HasSubstr(words));
  EXPECT_THAT(record, HasSubstr("Page 1 of " + std::to_string(pages())));
  EXPECT_GE(pages(), 2);
  EXPECT_LE(pages(), 4);
}

TEST_F(PdfReport, StatesThePlanBesideTheResultsAndWhatIsOutsideOfIt)
{
  auto content = gui::gatherReport(recordingOf("mean-flex28", {{"stop_travel_mm", "6.0"}}), {});
  ASSERT_TRUE(content) << content.error().message;
  const double peak_mN = content->insertion.profile.peak.force * 1e3;
  content->plan.emplace();
  content->plan->peak_mN.low = peak_mN + 2.0;
  content->plan->peak_mN.median = peak_mN + 5.0;
  content->plan->peak_mN.high = peak_mN + 9.0;
  content->plan->angle_deg.low = 0.0;
  content->plan->angle_deg.median = 100.0;
  content->plan->angle_deg.high = 720.0;
  const auto results = gui::insertionResults(*content);
  std::map<QString, gui::InsertionResult> byName;
  for (const gui::InsertionResult& each : results) byName[each.name] = each;
  EXPECT_TRUE(byName["Peak insertion force"].isOutside);
  EXPECT_FALSE(byName["Angular insertion depth"].isOutside);
  EXPECT_EQ(byName["Angular insertion depth"].plan, QString::fromUtf8("100 (0–720)°"));
  EXPECT_EQ(byName["Force after 1 s of rest"].plan, QString());  // this plan has none
  ASSERT_TRUE(gui::writeReport(*content, pdf()));
  EXPECT_THAT(text(1, 1), HasSubstr("100 (0–720)°"));
}

/// A stored plan of the synthetic patient whose insertions have a peak force of 1 to `draws` mN.
void storePlan(const std::string& name, const std::string& madeUtc, std::size_t draws,
               const planning::PlanRequest& request)
{
  planning::Plan plan = syntheticPlan(draws);
  gui::StoredPlan stored;
  stored.folder = plansFolder() / name;
  stored.request = plan.request = request;
  stored.shownDraws = draws;
  stored.madeUtc = madeUtc;
  ASSERT_TRUE(planning::savePlanFolder(stored));
  const auto json = planning::planJson(plan);
  ASSERT_TRUE(json) << json.error().message;
  std::ofstream(stored.folder / gui::planJsonFile) << *json;
}

TEST_F(PdfReport, StatesTheNewestStoredPlanOfItsArrayInItsCochleaByDate)
{
  const StateFolder state;
  const planning::PlanRequest own = syntheticPlan(1).request;
  planning::PlanRequest otherEar = own, otherArrays = own;
  otherEar.patient.side = anatomy::Side::left;
  otherArrays.arrays = {"flex24", "flexsoft"};
  storePlan("a", "2026-03-01T12:00:00Z", 16, own);
  storePlan("b", "2026-03-05T12:00:00Z", 64, own);
  storePlan("c", "2026-03-02T12:00:00Z", 32, own);
  storePlan("d", "2026-03-09T12:00:00Z", 16, otherEar);
  storePlan("e", "2026-03-09T12:00:00Z", 16, otherArrays);
  storePlan("f", "2026-03-08T12:00:00Z", 16, own);
  fs::remove(plansFolder() / "f" / gui::planJsonFile);

  const fs::path patient = state.path() / "patient.toml";
  ASSERT_TRUE(anatomy::savePatient(own.patient, patient));
  const auto content = gui::gatherReport(
      recordingOf("mean-flex28", {{"patient", patient.string()}, {"stop_travel_mm", "3.0"}}), {});
  ASSERT_TRUE(content) << content.error().message;
  ASSERT_TRUE(content->plan);
  EXPECT_EQ(content->plan->name, "plan of 2026-03-05");
  EXPECT_NEAR(content->plan->peak_mN.median, 32.5, 0.51);  // of 1 to 64 mN
  ASSERT_TRUE(gui::writeReport(*content, pdf()));
  EXPECT_THAT(text(1, 1), testing::ContainsRegex(
                              "plan of 2026-03-05, number [0-9a-f]+: 90 % at friction 0.12"));

  const auto unplanned =
      gui::gatherReport(recordingOf("mean-flex28", {{"stop_travel_mm", "3.0"}}), {});
  ASSERT_TRUE(unplanned) << unplanned.error().message;
  EXPECT_FALSE(unplanned->plan);
}

TEST_F(PdfReport, SaysFirstHowTheInsertionEndedAndWhatMakesItsResultsDoubtful)
{
  auto content = gui::gatherReport(recordingOf("mean-flex28", {{"stop_travel_mm", "3.0"}}), {});
  ASSERT_TRUE(content) << content.error().message;
  EXPECT_EQ(gui::outcomeOf(*content).value.toStdString(),
            "Stopped as set, 23.0 mm of the array outside")
      << "28 mm, 2 of them inside at the start";
  EXPECT_EQ(gui::outcomeOf(*content).detail, QString());

  content->last.status |= haptics::endedBuckled;
  content->insertion.profile.finalDepth = 0.5e-3;
  content->insertion.profile.finalAngle = 0.05;
  content->insertion.profile.ticksNotConverged = 337;
  ASSERT_TRUE(gui::writeReport(*content, pdf()));
  const std::string record = text(1, 1);
  EXPECT_THAT(record, HasSubstr("Buckled in front of the opening"));
  EXPECT_THAT(record, HasSubstr("at the end 0.5 mm, tip at 3°"));
  EXPECT_THAT(record, HasSubstr("337 samples did not converge"));
  EXPECT_EQ(gui::insertionResults(*content).front().name, "Outcome");

  content->last.status &= ~haptics::anyEnd;
  content->deepest.output.travel = 1e-3;
  EXPECT_EQ(gui::outcomeOf(*content).value, "Ended before its stop at 3.0 mm");
}

TEST_F(PdfReport, HasAnAppendixThatMakesItReproducible)
{
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  const std::string appendix = text(2);
  for (const std::string& words :
       {std::string("Traceability"), std::string("SHA-256"), buildId(),
        std::string("Replay verified"), std::string("Static friction coefficient"),
        std::string("N/m"), std::string("Random seed"), std::string("Technique score")})
    EXPECT_THAT(appendix, HasSubstr(words));
  // every number that the pages cite is in the list of references, once
  const std::string all = text();
  const std::regex number("\\[([0-9]+)\\]");
  const auto list = all.substr(all.rfind("References"));
  for (std::sregex_iterator each(all.begin(), all.end(), number), end; each != end; ++each)
    EXPECT_TRUE(std::regex_search(list, std::regex("\\[" + (*each)[1].str() + "\\] +[A-Z]")))
        << each->str();
  EXPECT_THAT(list, HasSubstr("[1]"));
  for (const char* prose : {"Choice", "recalled", "not read", "Schuster", "unverified",
                            "plugins/README", "public research code"})
    EXPECT_THAT(all, Not(HasSubstr(prose)));
  // words, not keys of a file; no folder of the user
  EXPECT_THAT(appendix, Not(HasSubstr("wall_stiffness")));
  EXPECT_THAT(appendix, Not(HasSubstr("speed_mm_s")));
  EXPECT_THAT(appendix, Not(HasSubstr("_N")));
  EXPECT_THAT(text(), Not(HasSubstr(fs::temp_directory_path().string())));
  EXPECT_THAT(text(), Not(HasSubstr("/home/")));

  auto content = gui::gatherReport(recordingOf("mean-flex28", {{"stop_travel_mm", "3.0"}}), {});
  ASSERT_TRUE(content);
  content->mayGoOn = true;
  ASSERT_TRUE(gui::writeReport(*content, pdf()));
  EXPECT_THAT(text(2), HasSubstr("when this report was made"));
}

TEST(ParametersOfAReport, AreAllThatAScenarioHas)
{
  // its own and its files' names, which stand in the head of the report
  const std::set<std::string> names{"title", "patient",           "patient_numbers.label",
                                    "array", "array_fingerprint", "calibration"};
  for (const char* shipped : {"booth", "contour-published", "mean-contour", "mean-flex28"}) {
    const auto scenario = session::loadScenario(shipped);
    ASSERT_TRUE(scenario) << scenario.error().message;
    std::size_t wanted = 0;
    for (const auto& [key, value] : scenario->values()) wanted += names.count(key) == 0 ? 1 : 0;
    EXPECT_EQ(gui::parametersOf(*scenario).size(), wanted) << shipped;
  }
}

TEST(ReferencesOfReports, AreNumberedAsTheyAreCitedAndNeverUnread)
{
  gui::References references;
  EXPECT_EQ(references.label("Rau et al. 2024, Front Neurol 15:1400455"), "[1]");
  EXPECT_EQ(references.label("Avci et al. 2014; Rau et al. 2024"), "[1, 2]");
  EXPECT_EQ(references.label("Schuster et al. 2015, Otol Neurotol 36:657"), "assumption");
  EXPECT_EQ(references.label("Choice: a bow of 1.1 mm on 4 mm."), "assumption");
  EXPECT_EQ(references.label("28 mm: reported in clinical studies of the device."),
            "general literature");
  EXPECT_EQ(references.label("Avci et al. 2014"), "[2]");
  EXPECT_EQ(references.label("Rau, Avci, Dohr and Medan").toStdString(), "[1–4]");
  const std::string list = references.list().toStdString();
  EXPECT_THAT(list, HasSubstr("Front Neurol 15:1400455"));
  EXPECT_LT(list.find("Rau"), list.find("Avci"));
  EXPECT_THAT(list, Not(HasSubstr("Schuster")));
}

TEST(ReferencesOfReports, AreByAuthorAndYear)
{
  gui::References references;
  // all that clinics report: "O'Connell 2016" is another publication than "O'Connell 2017"
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  ASSERT_TRUE(evidence);
  for (const analysis::ClinicalReport& each : evidence->reports()) {
    gui::References alone;
    EXPECT_TRUE(alone.label(each.source).startsWith('[')) << each.source;
    const std::string list = alone.list().toStdString();
    const auto space = each.reference.rfind(' ');
    EXPECT_THAT(list, HasSubstr(each.reference.substr(0, space)));
    EXPECT_THAT(list, HasSubstr(each.reference.substr(space + 1)));
  }
  // a further author is no publication: Rau 2024 is another one
  EXPECT_EQ(references.label("Salcher R, Lenarz T, Rau TS (2019), ARO, vol. 42:36 (poster)"),
            "[1]");
  EXPECT_EQ(references.label("Froehlich M, Schurzig D, Rau TS, Lenarz T (2024), PLOS ONE"), "[2]");
  EXPECT_THAT(references.list().toStdString(), Not(HasSubstr("five patients")));
}

TEST(ReferencesOfReports, HaveTheirUnreadOnesInTheGuide)
{
  const auto guide = readWhole(projectFolder() / "resources/guide/method.md");
  ASSERT_TRUE(guide);
  const std::string assumptions = guide->substr(guide->find("### Assumptions"));
  std::size_t unread = 0;
  for (const gui::Publication& each : gui::publications()) {
    if (each.wasRead) continue;
    ++unread;
    EXPECT_THAT(assumptions, HasSubstr(each.name));
  }
  EXPECT_GE(unread, 9u);
}

TEST_F(PdfReport, NamesLiningAndRimOfTheWall)
{
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  EXPECT_TRUE(std::regex_search(text(2), std::regex("Soft lining of the wall +0\\.08 mm")));
  EXPECT_TRUE(std::regex_search(text(2), std::regex("Stiffness of the opening.s rim +441")));
}

TEST_F(PdfReport, SaysWhereThePartitionRupturedAndWhichContactsAreAboveIt)
{
  report("surgery-flex28", contourFromBelow());
  const std::string record = text(1, 1);
  EXPECT_THAT(record, HasSubstr("translocation: ruptured at 57° by 42 mN, 7.3 mm above"));
  EXPECT_TRUE(std::regex_search(record, std::regex("[0-9] +SV ")));
  EXPECT_THAT(record, HasSubstr("SV: above the cochlear partition, in the scala vestibuli."));
}

TEST_F(PdfReport, NamesPatientAndEarOnEveryPage)
{
  report("mean-flex28", {{"patient", leftPatient()}, {"stop_travel_mm", "3.0"}});
  for (int page = 1; page <= pages(); ++page)
    EXPECT_THAT(text(page, page), testing::StartsWith("Patient P-017 · left ear")) << page;
}

TEST_F(PdfReport, SaysThatThereIsNoPatient)
{
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  const std::string record = text(1, 1);
  EXPECT_THAT(record, testing::StartsWith("No patient · right ear"));
  EXPECT_THAT(record, HasSubstr("average of 15 human cochleae"));
  EXPECT_THAT(record, Not(HasSubstr("population mean")));
}

TEST(SettingsOfReports, AreKeptAsTheyAreTyped)
{
  {
    gui::SettingsOverlay sheet(nullptr);
    auto* field = sheet.findChild<QLineEdit*>(QStringLiteral("report/institution"));
    ASSERT_NE(field, nullptr);
    field->setText(QStringLiteral(" ENT Clinic "));
    Q_EMIT field->editingFinished();
  }
  EXPECT_EQ(gui::ReportIssuer::fromSettings().institution, "ENT Clinic");
  gui::UserSettings().remove(QStringLiteral("report"));
  EXPECT_TRUE(gui::ReportIssuer::fromSettings().institution.isEmpty());
}

TEST_F(PdfReport, CarriesInstitutionAndOperatorOfTheSettings)
{
  gui::UserSettings().setValue(QStringLiteral("report/institution"), "ENT Clinic, Booth 7");
  gui::UserSettings().setValue(QStringLiteral("report/operator"), "K. 12");
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  EXPECT_THAT(text(1, 1), HasSubstr("K. 12"));
  for (int page = 1; page <= pages(); ++page)
    EXPECT_THAT(text(page, page), HasSubstr("ENT Clinic, Booth 7")) << page;
}

TEST_F(PdfReport, GivesForcesInMillinewtonsAndNoPublishedValuesOfAnotherArray)
{
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  const std::string all = text();
  EXPECT_THAT(all, HasSubstr(" mN"));
  EXPECT_FALSE(std::regex_search(all, std::regex("[0-9] N[^/·a-zA-Z0-9]")));
  EXPECT_THAT(all, Not(HasSubstr("published measurements")));
}

TEST_F(PdfReport, IsSetInInterAlone)
{
  report("mean-flex28", {{"stop_travel_mm", "3.0"}});
  const std::string fonts = outputOf("pdffonts", {pdf().string()});
  EXPECT_THAT(fonts, HasSubstr("Inter"));
  EXPECT_THAT(fonts, Not(HasSubstr("DejaVu")));
}

TEST_F(PdfReport, SpeaksGerman)
{
  gui::useLanguage(*QCoreApplication::instance(), QStringLiteral("de"));
  report("mean-flex28", {{"patient", leftPatient()}, {"stop_travel_mm", "3.0"}});
  if (const char* folder = std::getenv("PERILYMPH_SCREEN_PICTURES"))
    fs::copy_file(pdf(), fs::path(folder) / "report-de.pdf", fs::copy_options::overwrite_existing);
  const std::string all = text();
  for (const char* words :
       {"Insertionsbericht", "linkes Ohr", "Maximalkraft", "Insertionswinkel",
        "Abdeckung der Cochlea", "Unterschrift", "Haftreibungskoeffizient", "Seite 1 von"})
    EXPECT_THAT(all, HasSubstr(words));
  for (const char* words : {"Insertion depth", "left ear", "Technique score", "Page 1"})
    EXPECT_THAT(all, Not(HasSubstr(words)));
}

}  // namespace
}  // namespace perilymph::test

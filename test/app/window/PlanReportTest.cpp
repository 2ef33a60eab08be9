// SPDX-License-Identifier: BSD-3-Clause

// The PDF report of a plan, written without a display and read by poppler, against its plan.json.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <fstream>
#include <iterator>
#include <regex>

#include "OwnFolders.h"
#include "PlanReportRig.h"
#include "gui/report/PlanReportPdf.h"
#include "gui/report/ReportIssuer.h"
#include "gui/run/UserSettings.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t countImages(const fs::path& pdf)
{
  const std::string list = run({"pdfimages", {"-list", pdf.string()}, {}, {}}).out;
  return std::size_t(std::count(list.begin(), list.end(), '\n'));
}

/// A word of the report as a regular expression, any number of spaces before it.
/// As in the report: two decimals below 10 kHz, else one.
QString kilohertz(double frequency_Hz)
{
  return QString::number(frequency_Hz / 1e3, 'f', frequency_Hz < 9995.0 ? 2 : 1);
}

std::string spaced(const QString& text)
{
  std::string escaped = " +";
  for (const char c : text.toStdString()) {
    if (c == '(' || c == ')' || c == '.') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

QString number(const QJsonValue& value, int decimals, double factor = 1.0)
{
  return QString::number(factor * value.toDouble(), 'f', decimals);
}

/// "523 (490–560)" as plan.json states it.
std::string band(const QJsonObject& parent, const char* key, int decimals)
{
  const QJsonObject values = parent[QLatin1String(key)].toObject();
  return spaced(QStringLiteral("%1 (%2–%3)")
                    .arg(number(values[QLatin1String("median")], decimals),
                         number(values[QLatin1String("p5")], decimals),
                         number(values[QLatin1String("p95")], decimals)));
}

std::string percent(const QJsonObject& chances, const char* key)
{
  const QJsonObject chance = chances[QLatin1String(key)].toObject();
  const QJsonArray interval = chance[QLatin1String("ci95")].toArray();
  return spaced(QStringLiteral("%1 (%2–%3)")
                    .arg(number(chance[QLatin1String("value")], 0, 100.0),
                         number(interval[0], 0, 100.0), number(interval[1], 0, 100.0)));
}

TEST_F(PlanReportPdf, StatesTheNumbersOfThePlanFileWithoutADisplay)
{
  store(syntheticPlan(59));  // no band ends between two printed numbers
  const auto outcome = report(folder_.path(), pdf());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(fs::status(pdf()).permissions(), fs::perms(0600));  // it may name a patient
  const std::string text = textOf(pdf());

  QFile file(QString::fromStdString((folder_ / "plan.json").string()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QJsonObject plan = QJsonDocument::fromJson(file.readAll()).object();
  const QJsonArray arrays = plan[QLatin1String("arrays")].toArray();
  ASSERT_EQ(arrays.size(), 2);
  for (const QJsonValue& each : arrays) {  // forces above 10 mN have no decimals
    const QJsonObject array = each.toObject();
    const QJsonObject chances = array[QLatin1String("probability")].toObject();
    const std::string row =
        array[QLatin1String("name")].toString().toStdString() + band(array, "angle_deg", 0) +
        band(array, "coverage_percent", 0) + band(array, "peak_mN", 0) +
        band(array, "partition_mN", 0) + percent(chances, "all_contacts_inside") +
        percent(chances, "stopped_by_resistance") + percent(chances, "buckled") +
        percent(chances, "folded_tip") + percent(chances, "partition_ruptured");
    EXPECT_TRUE(std::regex_search(text, std::regex(row))) << row << "\n" << text;
    const std::string resistances = array[QLatin1String("name")].toString().toStdString() +
                                    band(array, "first_resistance_mm", 1) +
                                    percent(chances, "resistance_felt") +
                                    percent(chances, "partition_reaches_weakest") +
                                    percent(chances, "partition_reaches_strongest");
    EXPECT_TRUE(std::regex_search(text, std::regex(resistances))) << resistances << "\n" << text;
    for (const QJsonValue& contact : array[QLatin1String("contacts")].toArray()) {
      const std::string cells =
          band(contact.toObject(), "angle_deg", 0) + band(contact.toObject(), "to_modiolus_mm", 2) +
          spaced(kilohertz(contact.toObject()[QLatin1String("greenwood_Hz")].toDouble()));
      EXPECT_TRUE(std::regex_search(text, std::regex(cells))) << cells;
    }
  }
  for (const QJsonValue& limit : plan[QLatin1String("limits")].toArray())
    EXPECT_THAT(text, HasSubstr(limit.toString().left(40).toStdString()));
  const QJsonArray sources = plan[QLatin1String("sources")].toArray();
  EXPECT_GT(sources.size(), 5);
  // numbers of what was read; prose on how a value was chosen stands in the guide
  for (const char* prose : {"Choice", "recalled", "not read", "Schuster", "plugins/README"})
    EXPECT_THAT(text, Not(HasSubstr(prose)));
  EXPECT_TRUE(
      std::regex_search(text, std::regex("Insertion speed +\\[[0-9]+\\] +confidence high")));
  EXPECT_TRUE(std::regex_search(
      text, std::regex("Strength of the cochlear[^\\n]* assumption +confidence low")))
      << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\\[[0-9]+\\] +Rau et al\\. 2024")));
  for (const QString& words :
       {plan[QLatin1String("program")].toString(), plan[QLatin1String("plan")].toString(),
        QStringLiteral("20.4 mN"), QStringLiteral("≥ 42.0 mN"), QStringLiteral("≥ 122.0 mN"),
        QStringLiteral("9.20 ± 0.20 mm"), QStringLiteral("6.80 ± 0.39 mm"),
        QStringLiteral("4.00 ± 0.59 mm"), QStringLiteral("Signature"), QStringLiteral("P-17"),
        QStringLiteral("right ear"), QStringLiteral("Page 1 of 3"),
        QStringLiteral(
            "Arrays in this cochlea: median (5 to 95 % of 59 simulations at friction 0.12)"),
        QStringLiteral("numbered from the tip: median (band)"),
        QStringLiteral("share of simulations, %"), QStringLiteral("10 of 59")})
    EXPECT_THAT(text, HasSubstr(words.toStdString()));
}

TEST_F(PlanReportPdf, StatesForcesAtTheEndAndAtRestAndSharesOfFewSimulationsAsCounts)
{
  store(syntheticPlan(16));
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  const std::string text = textOf(pdf());
  EXPECT_THAT(text, HasSubstr("median (lowest to highest of 16 simulations at friction 0.12)"));
  EXPECT_THAT(text, HasSubstr("number of simulations"));
  // all contacts inside in every second, stopped at every fourth, buckled, folded, ruptured at every tenth
  EXPECT_TRUE(
      std::regex_search(text, std::regex("FLEX24 .*8 of 16 +4 of 16 +0 of 16 +0 of 16 +1 of 16")))
      << text;
  // half and a quarter of 1 to 16 mN, and nothing computed after 10 s
  EXPECT_TRUE(std::regex_search(text, std::regex("FLEX24 +4\\.3 \\(0\\.5–8\\.0\\) +2\\.1 "
                                                 "\\(0\\.3–4\\.0\\) +–")))
      << text;
  EXPECT_THAT(text, HasSubstr("at the stop, by the line through"));
  // as a version wrote it that knew no force at rest
  planning::Plan former = syntheticPlan(16);
  for (planning::ArrayPlan& each : former.arrays) each.after1s_mN = {};
  store(former);
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_THAT(textOf(pdf()), HasSubstr("of 2 s of rest"));
  // a report of two simulations has curves to their ends
  store(syntheticPlan(2));
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_THAT(textOf(pdf()), HasSubstr("2 of 2"));
}

TEST_F(PlanReportPdf, WarnsThatOtherMeasuresAreInUseNow)
{
  const DataFolder data;
  anatomy::Patient patient = measuredPatient();
  ASSERT_TRUE(gui::savePatientInLibrary(patient));
  store(syntheticPlan(40));
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_EQ(textOf(pdf()).find("in use"), std::string::npos);
  patient.basalTurn->a = millimeters(9.3);
  ASSERT_TRUE(gui::savePatientInLibrary(patient, gui::libraryFileOf(patient)));
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  EXPECT_NE(textOf(pdf()).find("This plan is of A 9.20 mm; the measures in use are A 9.30 mm."),
            std::string::npos)
      << textOf(pdf());
}

TEST_F(PlanReportPdf, NamesEverySourceAndHasNoFirstResistanceThatIsNotFelt)
{
  store(syntheticPlan(8));  // of at most 8 mN
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  const std::string text = textOf(pdf());
  EXPECT_TRUE(std::regex_search(text, std::regex("FLEX24 +– +0 of 8")));
  EXPECT_THAT(text, HasSubstr("Soft lining of the wall"));
  EXPECT_THAT(text, Not(HasSubstr("Default filters: lining")));
}

TEST_F(PlanReportPdf, StatesNoLabelThatMayBeAName)
{
  planning::Plan plan = syntheticPlan(8);
  plan.request.patient.label = "Doe, Jane";
  store(plan);
  ASSERT_EQ(report(folder_ / "plan.json", pdf()).status, 0);
  EXPECT_THAT(textOf(pdf()), Not(HasSubstr("Doe")));
  EXPECT_THAT(run({"strings", {pdf().string()}, {}, {}}).out, Not(HasSubstr("Jane")));
}

TEST_F(PlanReportPdf, HasOnePageForTheRecordWithThirtyTwoArrays)
{
  planning::Plan plan = syntheticPlan(8);
  while (plan.arrays.size() < planning::maxStoredArrays) plan.arrays.push_back(plan.arrays[0]);
  store(plan);
  ASSERT_EQ(report(folder_.path(), pdf()).status, 0);
  const std::string first =
      run({"pdftotext", {"-layout", "-l", "1", pdf().string(), "-"}, {}, {}}).out;
  EXPECT_TRUE(std::regex_search(first, std::regex("32 +FLEX24 +30")));
  EXPECT_THAT(first, HasSubstr("Signature"));
  EXPECT_THAT(first, HasSubstr("Ends are those of the model"));
  // all curves on one page of the appendix
  const std::string second =
      run({"pdftotext", {"-layout", "-f", "2", "-l", "2", pdf().string(), "-"}, {}, {}}).out;
  EXPECT_THAT(second, HasSubstr("Insertion force of all arrays"));
  for (std::size_t i = 1; i <= planning::maxStoredArrays; ++i)
    EXPECT_TRUE(std::regex_search(second, std::regex("\\b" + std::to_string(i) + " +FLEX2[48]")))
        << i;
}

TEST_F(PlanReportPdf, CarriesInstitutionAndLogoOfTheSettings)
{
  store(syntheticPlan(8));
  auto stored = planning::readPlan(folder_.path());
  ASSERT_TRUE(stored);
  const auto content = gui::planReportContent(*stored);
  ASSERT_TRUE(content) << content.error().message;
  ASSERT_TRUE(gui::writePlanReport(*content, pdf()));
  const std::size_t before = countImages(pdf());

  const fs::path logo = folder_ / "logo.png";
  QImage drawn(200, 50, QImage::Format_RGB32);
  drawn.fill(Qt::darkBlue);
  ASSERT_TRUE(drawn.save(QString::fromStdString(logo.string())));
  gui::UserSettings().setValue(QStringLiteral("report/institution"), "ENT Clinic, Booth 7");
  gui::UserSettings().setValue(QStringLiteral("report/logo"),
                               QString::fromStdString(logo.string()));
  ASSERT_TRUE(gui::writePlanReport(*content, pdf()));
  EXPECT_THAT(textOf(pdf()), HasSubstr("ENT Clinic, Booth 7"));
  EXPECT_EQ(countImages(pdf()), before + 1);

  std::ofstream(logo) << "no picture";
  EXPECT_FALSE(gui::readLogo(QString::fromStdString(logo.string())));
  EXPECT_TRUE(gui::writePlanReport(*content, pdf()));  // without the logo
  EXPECT_EQ(countImages(pdf()), before);
}

TEST_F(PlanReportPdf, RefusesInOneLineWhatItCannotReport)
{
  store(syntheticPlan(8));
  const std::pair<fs::path, const char*> plans[] = {{folder_ / "absent", "absent"},
                                                    {"/etc/passwd", "is not a plan"}};
  for (const auto& [plan, reason] : plans) {
    const auto outcome = report(plan, pdf());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(reason));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(pdf()));
  }
  EXPECT_EQ(report(folder_.path(), "/no/such/folder/plan.pdf").status, 1);
  EXPECT_EQ(report(folder_.path(), folder_ / "plan.doc").status, 2);
}

}  // namespace
}  // namespace perilymph::test

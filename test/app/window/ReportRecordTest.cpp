// SPDX-License-Identifier: BSD-3-Clause

// What the record of an insertion says of its setup, and where its pages are full.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <ctime>
#include <regex>
#include <set>

#include "OwnFolders.h"
#include "PdfReportRig.h"
#include "gui/report/ReportIssuer.h"
#include "gui/report/ReportSetup.h"
#include "gui/setup/KeyImage.h"
#include "gui/setup/PatientLibrary.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A patient who was measured in a CT.
anatomy::Patient patientFromCt()
{
  anatomy::Patient patient;
  patient.label = "P-200";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.0), millimeters(6.7), millimeters(4.0)};
  patient.origin.software = "Perilymph";
  patient.origin.seriesKey = std::string(64, 'a');
  patient.origin.landmarksProposed = "RW, OW, B1, B2, H, A, C";
  return patient;
}

/// A picture like that of a CT: three squares.
void keepPictureOf(const anatomy::Patient& patient)
{
  QImage picture(1536, 512, QImage::Format_RGB32);
  picture.fill(QColor(40, 90, 40));
  fs::create_directories(gui::keyImageFile(patient).parent_path());
  ASSERT_TRUE(picture.save(QString::fromStdString(gui::keyImageFile(patient).string())));
}

class RecordOfAnInsertion : public PdfReport {
protected:
  /// The content of the report of an insertion into a saved patient's cochlea.
  gui::ReportContent contentOf(const anatomy::Patient& patient)
  {
    const auto file = gui::savePatientInLibrary(patient);
    EXPECT_TRUE(file) << file.error().message;
    auto content = gui::gatherReport(
        recordingOf("surgery-flex28", {{"patient", file->string()}, {"stop_travel_mm", "4.0"}}),
        {});
    EXPECT_TRUE(content) << content.error().message;
    return *std::move(content);
  }

  DataFolder data_;
  StateFolder state_;
};

TEST_F(RecordOfAnInsertion, SaysHowItsLandmarksCameAndShowsTheCtWithAAndB)
{
  anatomy::Patient patient = patientFromCt();
  keepPictureOf(patient);
  const gui::ReportContent content = contentOf(patient);
  EXPECT_EQ(gui::landmarksText(content), "automatic");
  EXPECT_EQ(content.identity().seriesKey, patient.origin.seriesKey);
  EXPECT_EQ(content.identity().code, "P-200");
  ASSERT_TRUE(gui::writeReport(content, pdf()));
  EXPECT_THAT(text(1, 1), HasSubstr("CT, cochlear view"));
  EXPECT_THAT(text(1, 1), HasSubstr("Cochlea, CT measurements"));
  EXPECT_TRUE(std::regex_search(text(1, 1), std::regex("Landmarks +automatic")));

  gui::ReportContent moved = content;
  moved.measured->origin.landmarksByHand = "RW, OW";
  EXPECT_EQ(gui::landmarksText(moved), "moved by hand: RW, LW");
  moved.measured.reset();
  EXPECT_EQ(gui::landmarksText(moved), "not known") << "no saved patient has these measures";
  EXPECT_EQ(moved.identity().seriesKey, "");
}

TEST_F(RecordOfAnInsertion, HasNoCtOfOtherMeasuresOfThePatient)
{
  anatomy::Patient patient = patientFromCt();
  const fs::path recording = contentOf(patient).file;
  const auto saved = gui::findSavedPatient(patient.label, patient.side);
  ASSERT_TRUE(saved);
  patient.basalTurn->a = millimeters(9.4);
  ASSERT_TRUE(gui::savePatientInLibrary(patient, saved->file));
  const auto content = gui::gatherReport(recording, {});
  ASSERT_TRUE(content) << content.error().message;
  EXPECT_FALSE(content->measured);
}

TEST_F(RecordOfAnInsertion, StatesFrictionWithItsIntervalAndOrigin)
{
  gui::References references;
  const auto plans = session::loadScenario("surgery-flex28");
  ASSERT_TRUE(plans);
  // 0.165 times and by exp(1.96 * 0.346), the spread of 0.20, 0.20 and 0.20
  EXPECT_EQ(gui::frictionText(*plans, references).toStdString(),
            "0.165; Estimate from pig tissue [1]");
  EXPECT_EQ(gui::frictionInEars(*plans).toStdString(), "0.08 to 0.33 (95 %)");
  const auto soap = session::loadScenario("mean-flex28", {{"friction_static", "0.09"}});
  ASSERT_TRUE(soap);
  EXPECT_EQ(gui::frictionText(*soap, references).left(5), "0.090");
}

TEST_F(RecordOfAnInsertion, SaysWhereAHandThatStopsWouldHaveEndedAndThatItsArrayIsNotValidated)
{
  const session::Overrides coarse = {
      {"nodes", "30"}, {"dt_ms", "10.0"}, {"stop_travel_mm", "26.0"}, {"speed_mm_s", "2.0"}};
  session::Overrides limited = coarse;
  limited.emplace_back("stop_force_N", "0.1");
  auto whole = gui::gatherReport(recordingOf("surgery-flex28", coarse), {});
  ASSERT_TRUE(whole) << whole.error().message;
  const auto stopped = gui::gatherReport(recordingOf("surgery-flex28", limited), {});
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_FALSE(stopped->passedStop);  // it has the limit
  ASSERT_TRUE(whole->passedStop);
  EXPECT_EQ(whole->passedStop->depth.si(), stopped->insertion.profile.finalDepth);

  for (const char* language : {"de", "en"}) {
    gui::useLanguage(*QCoreApplication::instance(), QString::fromLatin1(language));
    ASSERT_TRUE(gui::writeReport(*whole, pdf()));
    EXPECT_THAT(text(1, 1), Not(HasSubstr("…"))) << text(1, 1);
  }
  EXPECT_THAT(text(1, 1), HasSubstr("A hand that stops at 100 mN would have ended at "));
  EXPECT_THAT(text(1, 1), HasSubstr("FLEX28, not validated"));
  EXPECT_THAT(text(1, 1), HasSubstr("0.08 to 0.33 (95 %)"));
  ASSERT_TRUE(gui::writeReport(*stopped, pdf()));
  EXPECT_THAT(text(1, 1), Not(HasSubstr("would have ended")));
}

TEST_F(RecordOfAnInsertion, HasTheBandOfItsPlanInTheCurve)
{
  gui::ReportContent content = contentOf(patientFromCt());
  content.plan.emplace();
  content.plan->name = "plan of 2026-11-27";
  content.plan->number = "0123456789abcdef";
  content.plan->hold = "90 % over friction 0.08 to 0.33";
  for (const double depth_mm : {1.0, 8.0, 16.0})
    content.plan->points.push_back({depth_mm, depth_mm, 2.0 * depth_mm, 3.0 * depth_mm});
  ASSERT_TRUE(gui::writeReport(content, pdf()));
  const std::string record = text(1, 1);
  EXPECT_THAT(record, HasSubstr("gray: median and band of the plan"));
  EXPECT_THAT(
      record,
      HasSubstr("plan of 2026-11-27, number 0123456789abcdef: 90 % over friction 0.08 to 0.33"));
  EXPECT_THAT(record, HasSubstr("peaks in patients 45–102 mN"));
  for (planning::Band* band : {&content.plan->peak_mN, &content.plan->end_mN}) {
    band->low = 119.0;
    band->median = 172.0;
    band->high = 200.0;
  }
  for (const char* language : {"en", "de"}) {  // nothing is cut
    gui::useLanguage(*QCoreApplication::instance(), QString::fromLatin1(language));
    ASSERT_TRUE(gui::writeReport(content, pdf()));
    EXPECT_THAT(text(1, 1), HasSubstr("172 (119–200) mN"));
    EXPECT_THAT(text(1, 1), Not(HasSubstr("…"))) << text(1, 1);
  }
  // the axis holds the plan, 48 mN at 16 mm
  EXPECT_TRUE(std::regex_search(record, std::regex("\\b16\\b|\\b20\\b")));
}

/// Sizes of the type on a page [points].
std::set<double> typeSizes(const fs::path& pdf, int page)
{
  const std::string number = std::to_string(page);
  const std::string html =
      run({"pdftotext", {"-bbox", "-f", number, "-l", number, pdf.string(), "-"}, {}, {}}).out;
  const std::regex word("yMin=\"([0-9.]+)\" xMax=\"[0-9.]+\" yMax=\"([0-9.]+)\"");
  std::set<double> sizes;
  for (std::sregex_iterator each(html.begin(), html.end(), word), end; each != end; ++each)
    sizes.insert(std::stod((*each)[2]) - std::stod((*each)[1]));
  return sizes;
}

TEST_F(RecordOfAnInsertion, HasNoTypeBelowEightPointsAndNoWhiteQuarter)
{
  for (const char* language : {"en", "de"}) {
    gui::useLanguage(*QCoreApplication::instance(), QString::fromLatin1(language));
    anatomy::Patient patient = patientFromCt();
    patient.label = std::string("P-20") + (language[0] == 'e' ? "1" : "2");
    keepPictureOf(patient);
    ASSERT_TRUE(gui::writeReport(contentOf(patient), pdf()));
    const auto sizes = typeSizes(pdf(), 1);
    ASSERT_FALSE(sizes.empty());
    // a line of Inter is 1.21 times its size high
    EXPECT_GE(*sizes.begin(), 1.2 * 8.0) << language;

    run({"pdftoppm",
         {"-r", "36", "-png", "-singlefile", "-l", "1", pdf().string(),
          (folder() / "page").string()},
         {},
         {}});
    const QImage page(QString::fromStdString((folder() / "page.png").string()));
    ASSERT_FALSE(page.isNull());
    int white = 0, longest = 0;
    for (int y = 0; y < page.height(); ++y) {
      bool isWhite = true;
      for (int x = 0; x < page.width() && isWhite; ++x) isWhite = qGray(page.pixel(x, y)) > 250;
      white = isWhite ? white + 1 : 0;
      longest = std::max(longest, white);
    }
    EXPECT_LT(longest, page.height() / 10) << language;
  }
}

TEST(TimeOfAReport, IsLocalWithItsZone)
{
  const QByteArray before = qgetenv("TZ");
  qputenv("TZ", "Europe/Berlin");
  tzset();
  EXPECT_THAT(gui::localTimeOf("2026-07-01T10:05:00Z").toStdString(),
              HasSubstr("12:05 (UTC+02:00)"));
  EXPECT_THAT(gui::localTimeOf("2026-12-01T10:05:00Z").toStdString(),
              HasSubstr("11:05 (UTC+01:00)"));
  before.isNull() ? qunsetenv("TZ") : qputenv("TZ", before);
  tzset();
}

}  // namespace
}  // namespace perilymph::test

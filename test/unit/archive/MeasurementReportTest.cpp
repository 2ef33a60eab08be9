// SPDX-License-Identifier: BSD-3-Clause

// A structured report, read again by three other programs: dciodvfy, DCMTK's dsrdump and pydicom.

#include "perilymph/archive/MeasurementReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "SmallStudy.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/Send.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomServers.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class StructuredReport : public testing::Test {
protected:
  void SetUp() override
  {
    test::writeDicomFiles(smallStudy(), images());
    test::writeDicomFiles(smallStudy(4, "1.2.840.99.17.2"), images() / "other");
    std::ofstream(ct() / "README.txt") << "no DICOM";
  }

  fs::path ct() const { return folder_ / "ct"; }
  fs::path images() const { return ct() / "images"; }
  fs::path file() const { return folder_ / "report.dcm"; }

  MeasurementReport report() const
  {
    MeasurementReport made;
    made.measures = {{Quantity::a, 9.004, 0.31},
                     {Quantity::b, 6.76, 0.28},
                     {Quantity::h, 3.53, 0.0},
                     {Quantity::ductLength, 33.0, 1.2}};
    made.isRight = true;
    made.software = "0.3.0+test";
    const auto list = imaging::findSeries(ct());
    for (const imaging::CtSeries& series : list->series)
      if (series.uid == ctSeries) made.seriesKey = series.key;
    return made;
  }

  void write(const MeasurementReport& what)
  {
    const auto written = writeMeasurementReport(what, ct(), file());
    ASSERT_TRUE(written) << written.error().message;
  }

  /// What a program prints of the file; empty if it is not installed.
  std::string printed(const std::string& program, const std::vector<std::string>& arguments)
  {
    const auto place = test::programOf(program);
    if (!place) return {};
    std::vector<std::string> all = arguments;
    all.push_back(file());
    const auto outcome = test::run({*place, all, {}, {}});
    return outcome.out + outcome.err;
  }

  test::TemporaryFolder folder_;
};

TEST_F(StructuredReport, HasTheMeasuresWithTheirErrors)
{
  write(report());
  const std::string text = printed("dsrdump", {"--print-all-codes"});
  if (text.empty()) GTEST_SKIP() << "Install the package dcmtk.";
  for (const char* part :
       {"Imaging Measurement Report", "(80169004,SCT,\"Cochlea\")", "(24028007,SCT,\"Right\")",
        "\"Right cochlea\"", "(A,99PERILYMPH,", "\"9.00\" (mm,UCUM,",
        "(371884006,SCT,\"+/-, range of measurement uncertainty\")", "\"0.31\" (mm,UCUM,",
        "(B,99PERILYMPH,", "\"6.76\"", "(H,99PERILYMPH,", "\"3.53\"", "(CDL-OC,99PERILYMPH,",
        "\"33.00\"", "\"1.20\"", "(FIT,99PERILYMPH,\"Fit of the bony lumen in CT\")"})
    EXPECT_THAT(text, HasSubstr(part));
  // three errors of four measures, for the height has none
  std::size_t errors = 0;
  for (std::size_t at = 0; (at = text.find("371884006", at)) != std::string::npos; ++at) ++errors;
  EXPECT_EQ(errors, 3u);
}

TEST_F(StructuredReport, IsValidForDciodvfy)
{
  write(report());
  const std::string said = printed("dciodvfy", {});
  if (said.empty()) GTEST_SKIP() << "Install the package dicom3tools.";
  EXPECT_THAT(said, HasSubstr("EnhancedSR"));
  EXPECT_THAT(said, Not(HasSubstr("Error")));
}

TEST_F(StructuredReport, NamesThePatientTheStudyAndEveryImageOfTheSeries)
{
  write(report());
  const fs::path script = folder_ / "read.py";
  std::ofstream(script) << R"(
import sys
import pydicom
data = pydicom.dcmread(sys.argv[1])
print(data.PatientID, data.PatientBirthDate, data.StudyInstanceUID, data.StudyDate, data.Modality, sep="|")
print(str(data.PatientName) == "M\u00fcller^Jane")
series = data.CurrentRequestedProcedureEvidenceSequence[0].ReferencedSeriesSequence
print(len(series), series[0].SeriesInstanceUID, len(series[0].ReferencedSOPSequence))
def images(item):
    return (item.ValueType == "IMAGE") + sum(images(one) for one in item.get("ContentSequence", []))
print(images(data))
)";
  const auto read = test::run({"/usr/bin/python3", {script, file()}, {}, {}});
  if (read.err.find("No module named") != std::string::npos)
    GTEST_SKIP() << "Install the package python3-pydicom.";
  EXPECT_EQ(read.out, std::string("MRN-4711|19700102|") + ctStudy + "|20250102|SR\nTrue\n1 " +
                          ctSeries + " 12\n12\n")
      << read.err;
}

TEST_F(StructuredReport, TracksOneCochleaUnderOneUid)
{
  const auto tracked = [this](const MeasurementReport& what) {
    write(what);
    const std::string text = printed("dsrdump", {});
    const auto at = text.find("2.25.");
    return at == std::string::npos ? std::string() : text.substr(at, text.find('"', at) - at);
  };
  if (!test::programOf("dsrdump")) GTEST_SKIP() << "Install the package dcmtk.";
  MeasurementReport first = report();
  const std::string uid = tracked(first);
  EXPECT_THAT(uid, testing::MatchesRegex("2[.]25[.][1-9][0-9]{30,38}"));
  first.measures[0].value_mm = 8.0;
  EXPECT_EQ(tracked(first), uid);
  first.isRight = false;
  EXPECT_NE(tracked(first), uid);
}

TEST_F(StructuredReport, IsRefusedForAnotherCt)
{
  MeasurementReport other = report();
  other.seriesKey[0] = other.seriesKey[0] == '0' ? '1' : '0';
  const auto written = writeMeasurementReport(other, ct(), file());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("no file of the series that was measured"));
  MeasurementReport none = report();
  none.measures.clear();
  EXPECT_FALSE(writeMeasurementReport(none, ct(), file()));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(StructuredReport, IsSentToTheStudyOfTheCt)
{
  if (!test::networkObstacle().empty()) GTEST_SKIP() << test::networkObstacle();
  for (const auto kind : {test::DicomServer::Kind::orthanc, test::DicomServer::Kind::dcmqrscp}) {
    if (!test::missingProgram(kind).empty()) GTEST_SKIP() << test::missingProgram(kind);
    const test::DicomServer server(kind);
    ASSERT_EQ(server.store(images()), "");
    write(report());
    const auto sent = sendObject(server.entry(), file());
    ASSERT_TRUE(sent) << sent.error().message;
    const auto series = findSeries(server.entry(), ctStudy);
    ASSERT_TRUE(series) << series.error().message;
    EXPECT_EQ(series->rows.size(), 3u);
  }
}

}  // namespace
}  // namespace perilymph::archive

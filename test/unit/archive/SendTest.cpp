// SPDX-License-Identifier: BSD-3-Clause

// A report into the study of the CT it was made of, and into no other.

#include "perilymph/archive/Send.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SmallStudy.h"
#include "perilymph/archive/Query.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/EncapsulatedPdf.h"
#include "perilymph/test/DicomServers.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using test::DicomServer;
using test::missingProgram;
using test::networkObstacle;
using testing::HasSubstr;
using Kind = DicomServer::Kind;

class SendTo : public testing::TestWithParam<Kind> {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    const std::string missing = missingProgram(GetParam());
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
    running_ = std::make_unique<DicomServer>(GetParam());
    auto files = smallStudy();
    for (test::DicomData& file : files) file.setText(0x00200011, "IS", "1");
    test::writeDicomFiles(files, folder_ / "ct");
    ASSERT_EQ(running_->store(folder_ / "ct"), "");
  }

  /// A report of a CT as a DICOM object.
  fs::path report(const std::string& name, const fs::path& ct)
  {
    const auto list = imaging::findSeries(ct);
    EXPECT_TRUE(list) << list.error().message;
    imaging::PdfDocument document{"%PDF-1.4 a report", "Insertion plan", "P-17", "test",
                                  list->series.at(0).key};
    const auto written = imaging::writeEncapsulatedPdf(document, ct, folder_ / name);
    EXPECT_TRUE(written) << written.error().message;
    return folder_ / name;
  }

  std::string send(const fs::path& file)
  {
    const auto sent = sendObject(running_->entry(), file);
    return sent ? "sent as series " + sent->seriesNumber : std::string(sent.error().message);
  }

  std::vector<std::string> modalities()
  {
    const auto series = findSeries(running_->entry(), ctStudy);
    EXPECT_TRUE(series) << series.error().message;
    std::vector<std::string> found;
    for (const FoundSeries& each : series->rows) found.push_back(each.number + " " + each.modality);
    std::sort(found.begin(), found.end());
    return found;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<DicomServer> running_;
};

TEST_P(SendTo, TheStudyOfTheCt)
{
  const fs::path file = report("report.dcm", folder_ / "ct");
  EXPECT_EQ(send(file), "sent as series 2");  // 1 is the CT
  EXPECT_THAT(modalities(), testing::ElementsAre("1 CT", "2 DOC"));
  EXPECT_EQ(send(file), "sent as series 2");  // the same object again
  EXPECT_THAT(modalities(), testing::ElementsAre("1 CT", "2 DOC"));
  EXPECT_EQ(send(report("second.dcm", folder_ / "ct")), "sent as series 3");
}

TEST_P(SendTo, NoOtherStudy)
{
  auto other = smallStudy();
  for (test::DicomData& file : other) file.setText(0x0020000D, "UI", "1.2.840.99.44");
  test::writeDicomFiles(other, folder_ / "other");
  EXPECT_THAT(send(report("a.dcm", folder_ / "other")), HasSubstr("has no study 1.2.840.99.44"));

  // the study's UID, but another patient
  for (test::DicomData& file : other) {
    file.setText(0x0020000D, "UI", ctStudy);
    file.setText(0x00100020, "LO", "MRN-1");
  }
  test::writeDicomFiles(other, folder_ / "stranger");
  const std::string refused = send(report("b.dcm", folder_ / "stranger"));
  EXPECT_THAT(refused, HasSubstr("under another patient number"));
  EXPECT_THAT(refused, testing::Not(HasSubstr("MRN")));
  EXPECT_THAT(modalities(), testing::ElementsAre("1 CT"));
}

TEST_P(SendTo, NothingThatThisProgramDidNotWrite)
{
  std::error_code failed;
  const fs::path slice = fs::directory_iterator(folder_ / "ct", failed)->path();
  EXPECT_THAT(send(slice), HasSubstr("is no result of this program"));
  EXPECT_THAT(send(folder_ / "absent"), HasSubstr("is no file"));
}

INSTANTIATE_TEST_SUITE_P(EachServer, SendTo, testing::Values(Kind::orthanc, Kind::dcmqrscp),
                         [](const auto& kind) {
                           return kind.param == Kind::orthanc ? "Orthanc" : "Dcmqrscp";
                         });

}  // namespace
}  // namespace perilymph::archive

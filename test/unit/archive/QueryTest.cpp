// SPDX-License-Identifier: BSD-3-Clause

// What is found in two implementations of an archive.

#include "perilymph/archive/Query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SmallStudy.h"
#include "perilymph/test/DicomServers.h"

namespace perilymph::archive {
namespace {

using test::DicomServer;
using test::missingProgram;
using test::networkObstacle;
using testing::HasSubstr;
using Kind = DicomServer::Kind;

class QueryOf : public testing::TestWithParam<Kind> {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    const std::string missing = missingProgram(GetParam());
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
    running_ = std::make_unique<DicomServer>(GetParam());
    auto other = smallStudy(3, "1.2.840.99.18.1");
    for (test::DicomData& file : other) {
      file.setText(0x0020000D, "UI", "1.2.840.99.18");
      file.setText(0x00080020, "DA", "20240607");
      file.setText(0x00100020, "LO", "MRN-9");
      file.setText(0x00100010, "PN", "Roe^Richard");
      file.setText(0x00100030, "DA", "19800203");
    }
    test::writeDicomFiles(smallStudy(), folder_ / "a");
    test::writeDicomFiles(other, folder_ / "b");
    ASSERT_EQ(running_->store(folder_.path()), "");
  }

  /// UIDs of the studies found.
  std::vector<std::string> found(const StudyQuery& query)
  {
    const auto studies = findStudies(running_->entry(), query);
    EXPECT_TRUE(studies) << studies.error().message;
    std::vector<std::string> uids;
    if (!studies) return uids;
    for (const FoundStudy& study : studies->rows) uids.push_back(study.uid);
    std::sort(uids.begin(), uids.end());
    return uids;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<DicomServer> running_;
};

StudyQuery of(std::string StudyQuery::*field, const std::string& value)
{
  StudyQuery query;
  query.*field = value;
  return query;
}

TEST_P(QueryOf, FindsStudiesAndTheirSeries)
{
  using testing::ElementsAre;
  const std::string first = ctStudy, second = "1.2.840.99.18";
  EXPECT_THAT(found(of(&StudyQuery::patientId, "MRN-4711")), ElementsAre(first));
  EXPECT_THAT(found(of(&StudyQuery::patientId, "MRN-*")), ElementsAre(first, second));
  EXPECT_THAT(found(of(&StudyQuery::patientName, "Roe*")), ElementsAre(second));
  EXPECT_THAT(found(of(&StudyQuery::birthDate, "19700102")), ElementsAre(first));
  EXPECT_THAT(found(of(&StudyQuery::from, "20250101")), ElementsAre(first));
  EXPECT_THAT(found(of(&StudyQuery::until, "20241231")), ElementsAre(second));
  EXPECT_THAT(found(of(&StudyQuery::modality, "CT")), ElementsAre(first, second));
  const bool knowsModalities = GetParam() == Kind::orthanc;  // an optional key, PS3.4
  EXPECT_EQ(found(of(&StudyQuery::modality, "MR")).empty(), knowsModalities);

  const auto studies = findStudies(running_->entry(), of(&StudyQuery::patientId, "MRN-4711"));
  ASSERT_TRUE(studies);
  ASSERT_EQ(studies->rows.size(), 1u);
  const FoundStudy& study = studies->rows[0];
  EXPECT_EQ(study.patientName, "M\xc3\xbcller^Jane");  // UTF-8
  EXPECT_EQ(study.patientId, "MRN-4711");
  EXPECT_EQ(study.birthDate, "19700102");
  EXPECT_EQ(study.date, "20250102");
  EXPECT_EQ(study.description, "Temporal bone");
  EXPECT_EQ(study.modalities, knowsModalities ? "CT" : "");
  EXPECT_FALSE(studies->isCut);

  const auto series = findSeries(running_->entry(), study.uid);
  ASSERT_TRUE(series) << series.error().message;
  ASSERT_EQ(series->rows.size(), 1u);
  EXPECT_EQ(series->rows[0].uid, ctSeries);
  EXPECT_EQ(series->rows[0].modality, "CT");
  EXPECT_EQ(series->rows[0].number, "3");
  EXPECT_EQ(series->rows[0].description, GetParam() == Kind::orthanc ? "0.3 mm" : "");
  EXPECT_EQ(series->rows[0].images.value_or(12u), 12u);  // Orthanc of Debian 12 does not count
}

INSTANTIATE_TEST_SUITE_P(EachServer, QueryOf, testing::Values(Kind::orthanc, Kind::dcmqrscp),
                         [](const auto& kind) {
                           return kind.param == Kind::orthanc ? "Orthanc" : "Dcmqrscp";
                         });

std::string refusalOf(const StudyQuery& query)
{
  Server nobody;
  nobody.name = "nobody";
  nobody.aeTitle = "X";
  nobody.host = "127.0.0.1";
  nobody.port = 1;
  const auto found = findStudies(nobody, query);
  return found ? "" : std::string(found.error().message);
}

TEST(QueryText, IsCheckedBeforeItIsSent)
{
  EXPECT_THAT(refusalOf({}), HasSubstr("no condition"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::birthDate, "19700230")), HasSubstr("YYYYMMDD"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::from, "1 Jan 70")), HasSubstr("YYYYMMDD"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::patientId, "1\\2")), HasSubstr("patient number"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::patientName, std::string(65, 'a'))),
              HasSubstr("patient name"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::patientName, "\xff")), HasSubstr("patient name"));
  EXPECT_THAT(refusalOf(of(&StudyQuery::modality, "ct*")), HasSubstr("is no modality"));
  StudyQuery turned;
  turned.from = "20250102";
  turned.until = "20250101";
  EXPECT_THAT(refusalOf(turned), HasSubstr("end before they begin"));
  // and no refusal repeats what may be a name
  EXPECT_THAT(refusalOf(of(&StudyQuery::patientName, "Doe\nJane")), testing::Not(HasSubstr("Doe")));
}

}  // namespace
}  // namespace perilymph::archive

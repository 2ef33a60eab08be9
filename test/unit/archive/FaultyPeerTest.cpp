// SPDX-License-Identifier: BSD-3-Clause

// What servers do by mistake or on purpose, and none of it stays in a folder.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stop_token>

#include "FaultyPeer.h"
#include "SmallStudy.h"
#include "perilymph/archive/Echo.h"
#include "perilymph/archive/Fetch.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/Send.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/EncapsulatedPdf.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int images = 3;

std::string uidOf(int i) { return std::string(ctSeries) + "." + std::to_string(i + 1); }

void set(DcmDataset& data, const DcmTagKey& tag, const std::string& text)
{
  data.putAndInsertString(tag, text.c_str());
}

void listed(DcmDataset& row, int i) { set(row, DCM_SOPInstanceUID, uidOf(i)); }

/// A slice as it should be.
void slice(DcmDataset& object, int i)
{
  set(object, DCM_SOPClassUID, UID_CTImageStorage);
  set(object, DCM_SOPInstanceUID, uidOf(i));
  set(object, DCM_StudyInstanceUID, ctStudy);
  set(object, DCM_SeriesInstanceUID, ctSeries);
  set(object, DCM_PatientName, "Doe^Jane");
  set(object, DCM_PatientID, "MRN-4711");
  set(object, DCM_PatientBirthDate, "19700102");
}

class FaultyArchive : public testing::TestWithParam<Retrieval> {
protected:
  void SetUp() override
  {
    if (!test::networkObstacle().empty()) GTEST_SKIP() << test::networkObstacle();
  }

  /// The answer to a fetch from a peer whose objects are changed by `change`.
  std::string fetch(const std::function<void(DcmDataset&, int)>& change, Faults faults = {})
  {
    faults.rows = images;
    faults.row = listed;
    if (faults.objects == 0) faults.objects = images;
    faults.object = [change](DcmDataset& object, int i) {
      slice(object, i);
      change(object, i);
    };
    FaultyPeer peer(std::move(faults));
    Server server = peer.entry();
    server.retrieval = GetParam();
    const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "ct");
    return fetched ? std::to_string(fetched->images) + " images"
                   : std::string(fetched.error().message);
  }

  std::size_t filesInPart() const
  {
    std::error_code none;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "ct.partial", none))
      count += entry.is_regular_file() ? 1 : 0;
    return count;
  }

  test::TemporaryFolder folder_;
};

void nothing(DcmDataset&, int) {}

TEST_P(FaultyArchive, IsNoneWithoutAFault) { EXPECT_EQ(fetch(nothing), "3 images"); }

TEST_P(FaultyArchive, MayNotSendAnotherSeries)
{
  const auto answer = fetch([](DcmDataset& object, int i) {
    if (i == 1) set(object, DCM_SeriesInstanceUID, "1.2.840.99.99");
  });
  EXPECT_THAT(answer, HasSubstr("an object of another series"));
  EXPECT_THAT(answer, HasSubstr("1 of 3 images are in"));
  EXPECT_EQ(filesInPart(), 1u);
}

TEST_P(FaultyArchive, MayNotSendAnotherStudy)
{
  const auto answer =
      fetch([](DcmDataset& object, int) { set(object, DCM_StudyInstanceUID, "1.2.840.99.99"); });
  EXPECT_THAT(answer, HasSubstr("an object of another series"));
  EXPECT_FALSE(fs::exists(folder_ / "ct.partial"));
}

TEST_P(FaultyArchive, MayNotSendAnotherPatient)
{
  const auto answer = fetch([](DcmDataset& object, int i) {
    if (i == 2) set(object, DCM_PatientID, "MRN-9");
  });
  EXPECT_THAT(answer, HasSubstr("objects of several patients"));
  EXPECT_THAT(answer, testing::Not(HasSubstr("MRN")));
  EXPECT_EQ(filesInPart(), 2u);
}

TEST_P(FaultyArchive, MayNotSendWhatItDidNotList)
{
  Faults faults;
  faults.objects = images + 1;
  EXPECT_THAT(fetch(nothing, faults), HasSubstr("had not listed"));
  EXPECT_EQ(filesInPart(), 3u);
  EXPECT_FALSE(fs::exists(folder_ / "ct"));
}

TEST_P(FaultyArchive, MayNotSendWhatIsNoDicom)
{
  for (const std::string& raw :
       {std::string("GIF89a no data set at all!"), std::string(12'000, '\xff'),
        std::string("\x08\x00\x18\x00UI\xf0\xff"
                    "1.2\0",
                    12)}) {
    Faults faults;
    faults.raw = raw;
    const auto answer = fetch(nothing, faults);
    EXPECT_THAT(answer, testing::AnyOf(HasSubstr("an object that is no DICOM"),
                                       HasSubstr("an object of another series")));
    EXPECT_THAT(answer, HasSubstr("1 of 3 images are in"));
    EXPECT_EQ(filesInPart(), 1u);
    fs::remove_all(folder_ / "ct.partial");
  }
}

TEST_P(FaultyArchive, MaySendAnImageTwice)
{
  Faults faults;
  faults.objects = images + 1;
  EXPECT_EQ(fetch(
                [](DcmDataset& object, int i) {
                  if (i == images) set(object, DCM_SOPInstanceUID, uidOf(0));
                },
                faults),
            "3 images");
}

TEST_P(FaultyArchive, IsNamedIfItSendsAPart)
{
  Faults faults;
  faults.objects = images - 1;
  const auto answer = fetch(nothing, faults);
  EXPECT_THAT(answer, HasSubstr("did not send 1 of the images that it lists"));
  EXPECT_THAT(answer, HasSubstr("2 of 3 images are in"));
  EXPECT_FALSE(fs::exists(folder_ / "ct"));
  EXPECT_EQ(filesInPart(), 2u);
}

TEST_P(FaultyArchive, MayHaveTenThousandImages)
{
  constexpr int many = 10'000;
  Faults faults;
  faults.rows = faults.objects = many;
  faults.row = listed;
  faults.object = slice;
  FaultyPeer peer(faults);
  Server server = peer.entry();
  server.retrieval = GetParam();
  const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "ct");
  ASSERT_TRUE(fetched) << fetched.error().message;
  EXPECT_EQ(fetched->images, std::size_t{many});
}

INSTANTIATE_TEST_SUITE_P(EachWay, FaultyArchive, testing::Values(Retrieval::get, Retrieval::move),
                         [](const auto& way) {
                           return way.param == Retrieval::get ? "Get" : "Move";
                         });

class FaultyServer : public testing::Test {
protected:
  void SetUp() override
  {
    if (!test::networkObstacle().empty()) GTEST_SKIP() << test::networkObstacle();
  }
  test::TemporaryFolder folder_;
};

TEST_F(FaultyServer, IsHeardDuringAMoveUnderItsOwnNameOnly)
{
  Faults faults;
  faults.rows = images;
  faults.row = listed;
  faults.objects = images;
  faults.object = slice;
  faults.movesAs = "SOMEBODY";
  FaultyPeer peer(faults);
  Server server = peer.entry();
  server.retrieval = Retrieval::move;
  const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "ct");
  ASSERT_FALSE(fetched);
  EXPECT_THAT(fetched.error().message, HasSubstr("another machine or another AE title"));
  EXPECT_FALSE(fs::exists(folder_ / "ct.partial"));
}

TEST_F(FaultyServer, IsQuotedIfItRefuses)
{
  Faults faults;
  faults.finalStatus = STATUS_FIND_Refused_OutOfResources;
  FaultyPeer peer(faults);
  const auto found = findSeries(peer.entry(), ctStudy);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("(status A700)"));

  FaultyPeer rejecting({.rejection = ASC_REASON_SU_NOREASON});
  const auto asked = echo(rejecting.entry());
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message, HasSubstr("refused the association without a reason"));
}

TEST_F(FaultyServer, MayNotKnowThisWorkstation)
{
  FaultyPeer peer({.rejection = ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED});
  const auto asked = echo(peer.entry());
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message,
              testing::AllOf(HasSubstr("does not know this workstation as PERILYMPH"),
                             HasSubstr("administrator")));
  const auto fetched = fetchSeries(peer.entry(), {ctStudy, ctSeries}, folder_ / "ct");
  ASSERT_FALSE(fetched);
  EXPECT_THAT(fetched.error().message, HasSubstr("does not know this workstation"));
  EXPECT_FALSE(fs::exists(folder_ / "ct.partial"));
}

TEST_F(FaultyServer, MayHaveAFormOfImagesThatIsNotRead)
{
  Faults faults;
  faults.rows = images;
  faults.row = listed;
  faults.objects = images;
  faults.object = slice;
  faults.finalStatus = STATUS_MOVE_Warning_SubOperationsCompleteOneOrMoreFailures;
  faults.moveSyntax = UID_MPEG2MainProfileAtMainLevelTransferSyntax;
  FaultyPeer peer(faults);
  Server server = peer.entry();
  server.retrieval = Retrieval::move;
  const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "ct");
  ASSERT_FALSE(fetched);
  EXPECT_THAT(fetched.error().message, HasSubstr("did not send 3 of the images that it lists"));
  EXPECT_FALSE(fs::exists(folder_ / "ct"));
}

TEST_F(FaultyServer, IsReadUpToAMaximumOfRows)
{
  Faults faults;
  faults.rows = 100'000;
  faults.row = [](DcmDataset& row, int i) {
    set(row, DCM_StudyInstanceUID, "1.2.840." + std::to_string(i));
  };
  FaultyPeer peer(faults);
  StudyQuery query;
  query.modality = "CT";
  const auto found = findStudies(peer.entry(), query);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->rows.size(), maxFoundRows);
  EXPECT_TRUE(found->isCut);
}

TEST_F(FaultyServer, IsGivenUpIfItIsTooSlow)
{
  const DribblingPeer peer;
  Exchange exchange;
  exchange.limits.connection = std::chrono::hours(1);
  exchange.limits.stall = std::chrono::seconds(1);
  const auto asked = echo(peer.entry(), exchange);
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message, HasSubstr("sent less than 64 KiB in 1 s"));
}

TEST_F(FaultyServer, MayHaveWhatWasOnItsWayAtACancellation)
{
  const test::TemporaryFolder folder;
  test::writeDicomFiles(smallStudy(), folder / "ct");
  const auto list = imaging::findSeries(folder / "ct");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_TRUE(imaging::writeEncapsulatedPdf(
      {"%PDF-1.4 a report", "Insertion plan", "P-17", "test", list->series.at(0).key},
      folder / "ct", folder / "report.dcm"));
  std::stop_source source;
  Faults canceled;
  canceled.rows = 1;
  canceled.row = [](DcmDataset& row, int) {
    row.putAndInsertString(DCM_StudyInstanceUID, ctStudy);
    row.putAndInsertString(DCM_SeriesInstanceUID, ctSeries);
    row.putAndInsertString(DCM_PatientID, "MRN-4711");
    row.putAndInsertString(DCM_PatientBirthDate, "19700102");
    row.putAndInsertString(DCM_SeriesNumber, "3");
  };
  std::atomic<bool> goesOn = false;
  canceled.offered = [&] {
    source.request_stop();
    EXPECT_TRUE(test::waitUntil([&goesOn] { return goesOn.load(); }));
  };
  const FaultyPeer peer(canceled);
  Exchange exchange;
  exchange.stop = source.get_token();
  int given = 0;
  exchange.onStore = [&given] { ++given; };
  const auto sent = sendObject(peer.entry(), folder / "report.dcm", exchange);
  goesOn = true;
  ASSERT_FALSE(sent);
  EXPECT_THAT(sent.error().message, HasSubstr("it may have stored it"));
  EXPECT_EQ(given, 1);

  // before anything is given to it, it has nothing
  given = 0;
  const auto before = sendObject(peer.entry(), folder / "report.dcm", exchange);
  ASSERT_FALSE(before);
  EXPECT_THAT(before.error().message, HasSubstr("was canceled"));
  EXPECT_EQ(given, 0);
}

TEST_F(FaultyServer, IsLeftAtACancellationInTheMiddleOfAnAnswer)
{
  const DribblingPeer peer;
  std::stop_source source;
  Exchange exchange;
  exchange.stop = source.get_token();
  exchange.limits.connection = exchange.limits.stall = std::chrono::hours(1);
  int looks = 0;
  exchange.onWait = [&] {
    if (++looks == 10) source.request_stop();
  };
  const auto asked = echo(peer.entry(), exchange);
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message, HasSubstr("was canceled"));
}

}  // namespace
}  // namespace perilymph::archive

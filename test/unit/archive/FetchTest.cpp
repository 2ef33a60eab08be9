// SPDX-License-Identifier: BSD-3-Clause

// A series from two implementations of an archive, by both ways.

#include "perilymph/archive/Fetch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <set>

#include "SmallStudy.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/InetSockets.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using test::DicomServer;
using test::missingProgram;
using test::networkObstacle;
using testing::HasSubstr;
using Kind = DicomServer::Kind;

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The data sets of the files of a folder, without their file headers.
std::multiset<std::string> dataSetsIn(const fs::path& folder)
{
  std::multiset<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = contentOf(entry.path());
    // preamble, DICM, then the length of the header, which stands in its first element: PS3.10
    constexpr std::size_t lengthAt = 128 + 4 + 8;
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length |= static_cast<std::size_t>(static_cast<unsigned char>(file.at(lengthAt + i)))
                << 8 * i;
    all.insert(file.substr(lengthAt + 4 + length));
  }
  return all;
}

struct Way {
  Kind kind;
  Retrieval retrieval;
};

class FetchBy : public testing::TestWithParam<Way> {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    const std::string missing = missingProgram(GetParam().kind);
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
    running_ = std::make_unique<DicomServer>(GetParam().kind);
    server_ = running_->entry();
    server_.retrieval = GetParam().retrieval;
    test::writeDicomFiles(smallStudy(), folder_ / "sent");
    ASSERT_EQ(running_->store(folder_.path()), "");
  }

  fs::path target() const { return folder_ / "fetched"; }
  fs::path partial() const { return folder_ / "fetched.partial"; }

  std::string fetch(const Exchange& exchange = {}, const FetchLimits& limits = {})
  {
    const auto fetched = fetchSeries(server_, {ctStudy, ctSeries}, target(), exchange, limits);
    if (!fetched) return fetched.error().message;
    return std::to_string(fetched->images) + " images, " + std::to_string(fetched->resumed) +
           " resumed";
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<DicomServer> running_;
  Server server_;
};

TEST_P(FetchBy, BringsTheSameBytesAndCanBeResumed)
{
  // canceled in the middle
  std::stop_source source;
  Exchange exchange;
  exchange.stop = source.get_token();
  exchange.onProgress = [&source](double fraction) {
    if (fraction > 0.3) source.request_stop();
  };
  EXPECT_THAT(fetch(exchange), HasSubstr("was canceled. 4 of 12 images are in"));
  EXPECT_FALSE(fs::exists(target()));
  EXPECT_EQ(dataSetsIn(partial()).size(), 4u);
  struct stat of = {};
  ASSERT_EQ(::stat(partial().c_str(), &of), 0);
  EXPECT_EQ(of.st_mode & 0777u, 0700u);

  // then only the rest is requested
  std::vector<double> fractions;
  exchange = {};
  exchange.onProgress = [&fractions](double fraction) { fractions.push_back(fraction); };
  EXPECT_EQ(fetch(exchange), "12 images, 4 resumed");
  EXPECT_EQ(fractions.size(), 8u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_FALSE(fs::exists(partial()));
  EXPECT_EQ(dataSetsIn(target()), dataSetsIn(folder_ / "sent"));
  for (const auto& entry : fs::directory_iterator(target())) {
    ASSERT_EQ(::stat(entry.path().c_str(), &of), 0);
    EXPECT_EQ(of.st_mode & 0777u, 0600u);
    EXPECT_THAT(entry.path().filename().string(), testing::MatchesRegex("[0-9a-f]{24}[.]dcm"));
  }
  // and it opens as any other folder
  const auto ct = imaging::readCt(target());
  ASSERT_TRUE(ct) << ct.error().message;
  EXPECT_EQ(ct->series.uid, ctSeries);
  EXPECT_EQ(ct->series.size[2], 12);

  EXPECT_THAT(fetch(), HasSubstr("exists already"));
  EXPECT_TRUE(test::inetSocketsOf(::getpid()).empty());  // nothing listens any more
}

TEST_P(FetchBy, RefusesWhatIsBeyondTheLimits)
{
  FetchLimits limits;
  limits.images = 11;
  EXPECT_THAT(fetch({}, limits), HasSubstr("more than 11 images"));
  limits = {};
  limits.bytes = 4000;  // of 12 images with 512 bytes of voxels and a header each
  EXPECT_THAT(fetch({}, limits), HasSubstr("sent more bytes"));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_P(FetchBy, NamesASeriesThatIsNotThere)
{
  const auto none = fetchSeries(server_, {ctStudy, "1.2.840.1"}, target());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("has no series 1.2.840.1"));
  EXPECT_FALSE(fs::exists(partial()));
  EXPECT_FALSE(fetchSeries(server_, {ctStudy, "Doe*"}, target()));
}

TEST_P(FetchBy, SaysWhenTheServerEndsInTheMiddle)
{
  Exchange exchange;
  exchange.onProgress = [this](double) { running_->stop(); };
  EXPECT_THAT(fetch(exchange), testing::AllOf(HasSubstr("images are in"), HasSubstr("of 12")));
  EXPECT_TRUE(fs::exists(partial()));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_P(FetchBy, TakesAwayWhatAKilledFetchLeft)
{
  fs::create_directories(partial());
  // as unfinishedPath() names it, of a process that has ended: the highest number that Linux gives
  char machine[256] = {};
  ASSERT_EQ(::gethostname(machine, sizeof machine), 0);
  const fs::path left = partial() / (".object." + std::string(machine) + "-4194303.1.part.dcm");
  std::ofstream(left) << "half an object";
  EXPECT_EQ(fetch(), "12 images, 0 resumed");
  EXPECT_EQ(dataSetsIn(target()).size(), 12u);
}

TEST_P(FetchBy, LetsOneOfTwoIntoAFolder)
{
  std::string second;
  Exchange exchange;
  exchange.onProgress = [&](double) {
    if (second.empty()) second = fetch();
  };
  EXPECT_EQ(fetch(exchange), "12 images, 0 resumed");
  EXPECT_THAT(second, HasSubstr("fetched"));
  EXPECT_THAT(second, testing::Not(HasSubstr("images,")));
}

TEST_P(FetchBy, LetsOneOfTwoMovesListenAtAPort)
{
  if (GetParam().kind == Kind::dcmqrscp) return;  // it answers one request at a time
  std::string second;
  Exchange exchange;
  exchange.onProgress = [&](double) {
    if (!second.empty()) return;
    const auto other = fetchSeries(server_, {ctStudy, ctSeries}, folder_ / "second");
    second = other ? std::to_string(other->images) + " images" : std::string(other.error().message);
  };
  EXPECT_EQ(fetch(exchange), "12 images, 0 resumed");
  if (server_.retrieval == Retrieval::get)
    EXPECT_EQ(second, "12 images");
  else
    EXPECT_THAT(second, HasSubstr("cannot be listened at"));
}

TEST_P(FetchBy, SaysWhenItsPortIsTaken)
{
  if (server_.retrieval == Retrieval::get) {
    const test::TakenPort taken;
    server_.ownPort = taken.number();
    EXPECT_EQ(fetch(), "12 images, 0 resumed");  // it listens at none
    return;
  }
  const test::TakenPort taken;
  server_.ownPort = taken.number();
  EXPECT_THAT(fetch(), HasSubstr("cannot be listened at"));
}

TEST_P(FetchBy, SaysWhenTheServerDoesNotKnowWhereToSend)
{
  server_.ownAeTitle = "UNKNOWN";
  if (server_.retrieval == Retrieval::get) return;
  const auto fetched = fetchSeries(server_, {ctStudy, ctSeries}, target());
  ASSERT_FALSE(fetched);
  EXPECT_THAT(fetched.error().message, HasSubstr("with the address of this machine and port " +
                                                 std::to_string(server_.ownPort)));
  EXPECT_FALSE(fs::exists(partial()));
}

std::string nameOf(const testing::TestParamInfo<Way>& way)
{
  return way.param.retrieval == Retrieval::get ? "Get" : "Move";
}

INSTANTIATE_TEST_SUITE_P(Orthanc, FetchBy,
                         testing::Values(Way{Kind::orthanc, Retrieval::get},
                                         Way{Kind::orthanc, Retrieval::move}),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Dcmqrscp, FetchBy,
                         testing::Values(Way{Kind::dcmqrscp, Retrieval::get},
                                         Way{Kind::dcmqrscp, Retrieval::move}),
                         nameOf);

class FetchFromOrthanc : public testing::TestWithParam<Retrieval> {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    const std::string missing = missingProgram(Kind::orthanc);
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
    test::writeDicomFiles(smallStudy(), folder_ / "sent");
  }
  test::TemporaryFolder folder_;
};

TEST_P(FetchFromOrthanc, IsEncryptedIfAskedFor)
{
  fs::create_directories(folder_ / "tls");
  const test::TestCertificates certificates(folder_ / "tls");
  const DicomServer running(Kind::orthanc, &certificates);
  ASSERT_EQ(
      running.store(folder_ / "sent", {"--enable-tls", certificates.key, certificates.certificate,
                                       "--add-cert-file", certificates.authority}),
      "");
  Server server = running.entry();
  server.retrieval = GetParam();
  const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "fetched");
  ASSERT_TRUE(fetched) << fetched.error().message;
  EXPECT_EQ(dataSetsIn(folder_ / "fetched"), dataSetsIn(folder_ / "sent"));
}

TEST_P(FetchFromOrthanc, LeavesImagesCompressedAsTheyAre)
{
  const auto compress = test::programOf("dcmcjpls");
  if (!compress) GTEST_SKIP() << "Install the package dcmtk.";
  fs::create_directories(folder_ / "packed");
  for (const auto& file : fs::directory_iterator(folder_ / "sent"))
    ASSERT_EQ(
        test::run({*compress, {file.path(), folder_ / "packed" / file.path().filename()}, {}, {}})
            .status,
        0);
  const DicomServer running(Kind::orthanc);
  ASSERT_EQ(running.store(folder_ / "packed", {"--propose-jls-lossless"}), "");
  Server server = running.entry();
  server.retrieval = GetParam();
  const auto fetched = fetchSeries(server, {ctStudy, ctSeries}, folder_ / "fetched");
  ASSERT_TRUE(fetched) << fetched.error().message;
  EXPECT_EQ(dataSetsIn(folder_ / "fetched"), dataSetsIn(folder_ / "packed"));
  const auto ct = imaging::readCt(folder_ / "fetched");
  ASSERT_TRUE(ct) << ct.error().message;
  EXPECT_EQ(ct->series.size[2], 12);
}

INSTANTIATE_TEST_SUITE_P(EachWay, FetchFromOrthanc,
                         testing::Values(Retrieval::get, Retrieval::move), [](const auto& way) {
                           return way.param == Retrieval::get ? "Get" : "Move";
                         });

}  // namespace
}  // namespace perilymph::archive

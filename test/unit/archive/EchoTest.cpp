// SPDX-License-Identifier: BSD-3-Clause

// Whether a server answers, and what is said if not.

#include "perilymph/archive/Echo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/test/DicomServers.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::archive {
namespace {

using test::DicomServer;
using test::missingProgram;
using test::networkObstacle;
using test::TestCertificates;
using testing::HasSubstr;
using Kind = DicomServer::Kind;

std::string answerOf(const Server& server, const Exchange& exchange = {})
{
  const auto asked = echo(server, exchange);
  return asked ? "answers" : std::string(asked.error().message);
}

class EchoOf : public testing::TestWithParam<Kind> {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    const std::string missing = missingProgram(GetParam());
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
  }
};

TEST_P(EchoOf, AnswersOrSaysWhatFailed)
{
  DicomServer running(GetParam());
  EXPECT_EQ(answerOf(running.entry()), "answers");

  Server other = running.entry();
  other.aeTitle = "NOBODY";
  EXPECT_THAT(answerOf(other), HasSubstr("is not called NOBODY"));

  running.stop();
  // dcmqrscp's process of the last connection holds the port a moment longer
  EXPECT_TRUE(test::waitUntil([&running] {
    return answerOf(running.entry()).find("cannot be reached") != std::string::npos;
  }));
}

INSTANTIATE_TEST_SUITE_P(EachServer, EchoOf, testing::Values(Kind::orthanc, Kind::dcmqrscp),
                         [](const auto& kind) {
                           return kind.param == Kind::orthanc ? "Orthanc" : "Dcmqrscp";
                         });

class EchoAlone : public testing::Test {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    server_.name = "test";
    server_.aeTitle = "ANY";
    server_.host = "127.0.0.1";
  }
  Server server_;
};

TEST_F(EchoAlone, NamesAHostThatNobodyKnows)
{
  server_.host = "no-such-host.invalid";  // RFC 2606
  EXPECT_THAT(answerOf(server_), HasSubstr("no machine of this name"));
}

TEST_F(EchoAlone, GivesUpAServerThatSaysNothing)
{
  const test::TakenPort silent;
  server_.port = silent.number();
  Exchange exchange;
  exchange.limits.connection = std::chrono::seconds(1);
  EXPECT_THAT(answerOf(server_, exchange), HasSubstr("no association within 1 s"));
}

TEST_F(EchoAlone, IsCanceledWhileItWaits)
{
  const test::TakenPort silent;
  server_.port = silent.number();
  std::stop_source source;
  Exchange exchange;
  exchange.stop = source.get_token();
  exchange.limits.connection = std::chrono::hours(1);
  std::jthread canceler([&source] { source.request_stop(); });
  EXPECT_THAT(answerOf(server_, exchange), HasSubstr("was canceled"));
}

class EchoByTls : public EchoAlone {
protected:
  void SetUp() override
  {
    EchoAlone::SetUp();
    const std::string missing = missingProgram(Kind::orthanc);
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
  }
  test::TemporaryFolder folder_;
};

TEST_F(EchoByTls, NeedsTheCertificatesOfBothSides)
{
  std::filesystem::create_directories(folder_ / "own");
  std::filesystem::create_directories(folder_ / "other");
  const TestCertificates own(folder_ / "own"), other(folder_ / "other");
  DicomServer running(Kind::orthanc, &own);
  EXPECT_EQ(answerOf(running.entry()), "answers");

  Server changed = running.entry();
  changed.tls->authority = other.authority;
  EXPECT_THAT(answerOf(changed), HasSubstr("TLS failed"));

  changed = running.entry();
  changed.tls->certificate = changed.tls->key = "";
  EXPECT_NE(answerOf(changed), "answers");

  changed = running.entry();
  changed.tls->key = other.key;
  EXPECT_THAT(answerOf(changed), HasSubstr("is not that of the certificate"));

  changed = running.entry();
  changed.tls->authority = folder_ / "absent.pem";
  EXPECT_THAT(answerOf(changed), HasSubstr("cannot be used for TLS"));

  changed = running.entry();
  changed.tls.reset();
  EXPECT_THAT(answerOf(changed), HasSubstr("whether it demands TLS"));
}

}  // namespace
}  // namespace perilymph::archive

// SPDX-License-Identifier: BSD-3-Clause

// The file servers.toml.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "perilymph/archive/Servers.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ServersFile : public testing::Test {
protected:
  fs::path file() const { return folder_ / "perilymph" / "servers.toml"; }

  void write(const std::string& text)
  {
    fs::create_directories(file().parent_path());
    std::ofstream(file()) << text;
  }

  std::string content() const
  {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// Message of the refusal of a text; empty if it is read.
  std::string refusalOf(const std::string& text)
  {
    write(text);
    const auto servers = readServers(file());
    return servers ? "" : std::string(servers.error().message);
  }

  static Server server()
  {
    Server made;
    made.name = "ward \"7\"";
    made.aeTitle = "PACS 1";
    made.host = "pacs.hospital.example";
    made.port = 11113;
    made.retrieval = Retrieval::move;
    made.ownPort = 4006;
    made.tls = TlsFiles{"/etc/a.pem", "/etc/own \\ cert.pem", "/etc/own.key"};
    return made;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ServersFile, IsReadAsItWasWritten)
{
  Server second;
  second.name = "second";
  second.aeTitle = "B";
  second.host = "10.0.0.2";
  ASSERT_TRUE(writeServers({server(), second}, file()));
  const auto read = readServers(file());
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2u);
  const Server& first = read->front();
  EXPECT_EQ(first.name, "ward \"7\"");
  EXPECT_EQ(first.aeTitle, "PACS 1");
  EXPECT_EQ(first.host, "pacs.hospital.example");
  EXPECT_EQ(first.port, 11113);
  EXPECT_EQ(first.ownAeTitle, "PERILYMPH");
  EXPECT_EQ(first.retrieval, Retrieval::move);
  EXPECT_EQ(first.ownPort, 4006);
  ASSERT_TRUE(first.tls);
  EXPECT_EQ(first.tls->certificate, "/etc/own \\ cert.pem");
  EXPECT_EQ(read->back().port, 104);
  EXPECT_FALSE(read->back().tls);
  EXPECT_EQ(readServer("second", file())->host, "10.0.0.2");
}

TEST_F(ServersFile, IsForItsOwnerOnly)
{
  ASSERT_TRUE(writeServers({server()}, file()));
  struct stat of = {};
  ASSERT_EQ(::stat(file().c_str(), &of), 0);
  EXPECT_EQ(of.st_mode & 0777u, 0600u);
  ASSERT_EQ(::stat(file().parent_path().c_str(), &of), 0);
  EXPECT_EQ(of.st_mode & 0777u, 0700u);
}

TEST_F(ServersFile, IsEmptyWhereThereIsNone)
{
  const auto servers = readServers(file());
  ASSERT_TRUE(servers);
  EXPECT_TRUE(servers->empty());
  const auto none = readServer("a", file());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("There is no server 'a'"));
}

TEST_F(ServersFile, RefusesWhatNoServerHas)
{
  const std::string good = "[[server]]\nname = 'a'\nae_title = 'A'\nhost = 'h'\n";
  EXPECT_EQ(refusalOf(good), "");
  EXPECT_THAT(refusalOf(good + "port = 70000\n"), HasSubstr("port"));
  EXPECT_THAT(refusalOf(good + "retrieve = 'push'\n"), HasSubstr("push"));
  EXPECT_THAT(refusalOf(good + "colour = 'red'\n"), HasSubstr("colour"));
  EXPECT_THAT(refusalOf(good + "own_ae_title = 'SEVENTEEN LETTERS'\n"),
              HasSubstr("is no AE title"));
  EXPECT_THAT(refusalOf("[[server]]\nname = 'a'\nhost = 'h'\n"), HasSubstr("ae_title"));
  EXPECT_THAT(refusalOf("[[server]]\nname = 'a'\nae_title = 'A'\nhost = 'h:104'\n"),
              HasSubstr("'h:104' is no name or IPv4 address"));
  EXPECT_THAT(refusalOf(good + good), HasSubstr("the name of another server"));
  EXPECT_THAT(refusalOf(good + "[server.tls]\nauthority = 'ca.pem'\n"),
              HasSubstr("no absolute path"));
  EXPECT_THAT(refusalOf(good + "[server.tls]\nauthority = '/ca.pem'\nkey = '/k'\n"),
              HasSubstr("belong together"));
  EXPECT_THAT(refusalOf("server = 3\n"), HasSubstr("server"));
}

TEST_F(ServersFile, KeepsTheOldFileIfANewServerIsRefused)
{
  ASSERT_TRUE(writeServers({server()}, file()));
  const std::string before = content();
  for (const auto& change :
       {+[](Server& s) { s.port = 0; }, +[](Server& s) { s.host = "a b"; },
        +[](Server& s) { s.name = "x'\n[[server]]"; }, +[](Server& s) { s.aeTitle = ""; },
        +[](Server& s) { s.tls->key = ""; }}) {
    Server changed = server();
    change(changed);
    EXPECT_FALSE(writeServers({changed}, file()));
  }
  EXPECT_FALSE(writeServers({server(), server()}, file()));
  EXPECT_EQ(content(), before);
}

TEST(ServersFilePlace, IsInTheFolderOfSettings)
{
  ::setenv("XDG_CONFIG_HOME", "/somewhere", 1);
  EXPECT_EQ(serversFile(), "/somewhere/perilymph/servers.toml");
  ::setenv("XDG_CONFIG_HOME", "relative", 1);
  ::setenv("HOME", "/home/u", 1);
  EXPECT_EQ(serversFile(), "/home/u/.config/perilymph/servers.toml");
}

}  // namespace
}  // namespace perilymph::archive

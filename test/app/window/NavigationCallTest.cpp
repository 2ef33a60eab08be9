// SPDX-License-Identifier: BSD-3-Clause

// The program as a server for navigation programs: it has no network socket unless its option or
// its setting asks for one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <set>

#include "ownCall.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;

/// The program with a settings folder of its own.
class TheProgram : public testing::Test {
protected:
  ProgramCall call(std::vector<std::string> arguments) const
  {
    return ownCall(folder_, std::move(arguments));
  }
  void keepSetting(int port) const
  {
    const fs::path settings = folder_ / "XDG_CONFIG_HOME" / "perilymph";
    fs::create_directories(settings);
    std::ofstream(settings / "perilymph.ini")
        << "[General]\nformat=1\n\n[openigtlink]\nserver=on\nport=" << port << "\n";
  }
  /// The places of all network sockets that a program has, from its start to its screenshot.
  std::set<std::string> placesOf(std::vector<std::string> arguments) const
  {
    const fs::path picture = folder_ / "window.png";
    for (const char* more : {"--screenshot", picture.c_str(), "--after", "1"})
      arguments.push_back(more);
    ChildProcess program(call(std::move(arguments)));
    std::set<std::string> places;
    EXPECT_TRUE(waitUntil([&] {
      for (const InetSocket& socket : inetSocketsOf(program.id()))
        places.insert((socket.isListening ? "" : "connected ") + socket.place);
      return fs::exists(picture);
    }));
    EXPECT_EQ(program.wait(120s).status, 0);
    fs::remove(picture);
    return places;
  }
  /// The places while the window is used.
  std::set<std::string> placesOfDemo(std::vector<std::string> arguments) const
  {
    arguments.push_back("--demo");
    ChildProcess program(call(std::move(arguments)));
    EXPECT_TRUE(program.waitForOutput("first frame after", 120s));
    std::set<std::string> places;
    for (const InetSocket& socket : inetSocketsOf(program.id()))
      places.insert((socket.isListening ? "" : "connected ") + socket.place);
    program.send(SIGTERM);
    program.wait(120s);
    return places;
  }

  const TemporaryFolder folder_;
};

TEST_F(TheProgram, HasNoNetworkSocketUnlessItIsAskedTo)
{
  EXPECT_THAT(placesOf({}), IsEmpty());
  EXPECT_THAT(placesOfDemo({}), IsEmpty());
  EXPECT_THAT(placesOf({"--kiosk"}), IsEmpty());
}

TEST_F(TheProgram, ListensWhereItsOptionSays)
{
  const int port = freePort();
  EXPECT_THAT(placesOf({"--igtl", std::to_string(port)}), testing::ElementsAre(loopback(port)));
  EXPECT_THAT(placesOf({"--kiosk", "--igtl", std::to_string(port)}),
              testing::ElementsAre(loopback(port)));
}

TEST_F(TheProgram, ListensAsItsSettingSaysButNeverAsABooth)
{
  const int port = freePort();
  keepSetting(port);
  EXPECT_THAT(placesOfDemo({}), testing::ElementsAre(loopback(port)));
  EXPECT_THAT(placesOf({"--kiosk"}), IsEmpty());
}

TEST_F(TheProgram, RefusesAPortThatIsTakenAndAnAddressThatIsNoneInOneSentence)
{
  const TakenPort taken;
  for (const bool isBooth : {false, true}) {
    std::vector<std::string> arguments{"--igtl", std::to_string(taken.number())};
    if (isBooth) arguments.push_back("--kiosk");
    const auto refused = run(call(arguments));
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("is taken by another program"));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  const auto named = run(call({"--igtl", "localhost:18944"}));
  EXPECT_EQ(named.status, 2);
  EXPECT_THAT(named.err, HasSubstr("is not numeric"));
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// The programs use no network unless they are asked to: they work without it and contain no call that
// could open a connection to another machine. `perilymph-cli archive` and the window's archives do, through
// DCMTK's library; their tests are in test/unit/archive, test/app/archive and test/app/window/ArchiveTest.cpp. Only --igtl, a setting of the
// window and a move make one listen; for the running window see test/app/window/NavigationCallTest.cpp.

#include <csignal>
#include <sstream>

#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

/// Symbols imported by a program.
std::vector<std::string> importsOf(const std::string& program)
{
  const ProgramOutcome outcome = run({"nm", {"-D", "--undefined-only", program}, {}, {}});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::string> names;
  std::istringstream lines(outcome.out);
  for (std::string kind, name; lines >> kind >> name;)
    names.push_back(name.substr(0, name.find('@')));
  return names;
}

TEST(ProgramsAndTheNetwork, HaveNoCallThatOpensAConnection)
{
  for (const char* name :
       {"perilymph-cli", "perilymph", "perilymph-device-guard", "perilymph-plugin-host"}) {
    const std::string program = programFolder() / name;
    if (!std::filesystem::exists(program)) continue;  // not in this build
    const auto imports = importsOf(program);
    EXPECT_THAT(imports, testing::Contains("__libc_start_main")) << name;  // the list is valid
    for (const char* call :
         {"connect", "sendto", "recvfrom", "getaddrinfo", "gethostbyname", "res_query"})
      EXPECT_THAT(imports, testing::Not(testing::Contains(std::string(call)))) << name;
    // Of DICOM's associations only the programs that have `archive` know.
    const std::string is = name;
    const bool isClient =
        std::any_of(imports.begin(), imports.end(), [](const std::string& import) {
          return import.find("ASC_requestAssociation") != std::string::npos;
        });
    EXPECT_EQ(isClient, PERILYMPH_HAS_VTK && (is == "perilymph-cli" || is == "perilymph")) << name;
    // The server of --igtl is in the two programs that have the option.
    if (is == "perilymph-cli" || is == "perilymph") continue;
    for (const char* call : {"socket", "bind", "listen", "accept", "accept4"})
      EXPECT_THAT(imports, testing::Not(testing::Contains(std::string(call)))) << name;
  }
}

TEST(ProgramsAndTheNetwork, MeetOnlyWhereItIsAskedFor)
{
  const TemporaryFolder folder;
  const std::vector<std::string> simulate = {"simulate", "--scenario", "contour-published", "--csv",
                                             folder / "run.csv"};
  for (const bool isRequested : {false, true}) {
    std::vector<std::string> text = simulate;
    if (isRequested) text.insert(text.end(), {"--igtl", "[::1]:18977"});
    ChildProcess program(cliCall(text));
    // While it runs, it writes its table into an unfinished file beside the place of the whole one.
    ASSERT_TRUE(waitUntil([&] { return !std::filesystem::is_empty(folder.path()); }));
    const auto sockets = inetSocketsOf(program.id());
    ASSERT_EQ(sockets.size(), isRequested ? 1u : 0u);
    if (isRequested) {
      EXPECT_TRUE(sockets[0].isListening);
      EXPECT_EQ(sockets[0].place, "00000000000000000000000001000000:4A21");  // [::1]:18977
    }
    program.send(SIGINT);
    program.wait(std::chrono::minutes(2));
  }
}

TEST(ProgramsAndTheNetwork, DoTheirWorkWithoutOne)
{
  if (run({"unshare", {"-n", "true"}, {}, {}}).status != 0)
    GTEST_SKIP() << "Nobody but root may take the network away here.";
  const TemporaryFolder folder;
  const std::string program = cliCall({}).program;
  const std::string file = folder / "run.insertion";
  const std::vector<std::vector<std::string>> calls = {
      shortSimulation({"--record", file}),
      {"replay", file, "--verify"},
      {"anatomy", "--preset", "mean", "--json", folder / "mean.json"},
      {"devices"}};
  for (std::vector<std::string> text : calls) {
    text.insert(text.begin(), {"-n", program});
    const ProgramOutcome outcome = run({"unshare", text, {}, {}});
    EXPECT_EQ(outcome.status, 0) << text[2] << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace perilymph::test

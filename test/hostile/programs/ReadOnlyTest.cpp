// SPDX-License-Identifier: BSD-3-Clause

// Read-only folders, and files that name paths they must not access.

#include <sys/stat.h>
#include <unistd.h>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// perilymph-cli without the rights of root.
ProgramOutcome cliAsNobody(std::vector<std::string> arguments)
{
  ProgramCall call = cliCall(std::move(arguments));
  if (::geteuid() != 0) return run(call);
  call.arguments.insert(call.arguments.begin(),
                        {"--reuid=65534", "--regid=65534", "--clear-groups", call.program});
  call.program = "setpriv";
  return run(call);
}

class ReadOnlyFolder : public testing::Test {
protected:
  void SetUp() override
  {
    if (cliAsNobody({"--version"}).status != 0)
      GTEST_SKIP() << "Nobody without rights may run the program where it was built.";
    ::chmod(folder.path().c_str(), 0555);
  }
  ~ReadOnlyFolder() override { ::chmod(folder.path().c_str(), 0755); }
  const TemporaryFolder folder;
};

TEST_F(ReadOnlyFolder, IsSaidBeforeAnythingIsComputed)
{
  for (const char* option : {"--csv", "--json", "--record"}) {
    const ProgramOutcome outcome = cliAsNobody(shortSimulation({option, folder / "run.out"}));
    EXPECT_EQ(outcome.status, 1) << option;
    EXPECT_THAT(outcome.err, HasSubstr("run.out")) << option;
    EXPECT_EQ(outcome.out, "") << option;  // no summary of a run whose output failed
  }
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST_F(ReadOnlyFolder, IsSaidByValidateToo)
{
  const ProgramOutcome outcome =
      cliAsNobody({"validate", "--runs", "2", "--out", folder / "tables"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("tables"));
}

/// An untrusted scenario, in its own folder beside what it must not touch.
class ForeignScenario : public testing::Test {
protected:
  ForeignScenario()
  {
    fs::create_directories(folder / "sent");
    std::ofstream(folder / "treasure.toml") << "what nobody may lose\n";
  }

  ProgramOutcome simulate(const std::string& scenario)
  {
    std::ofstream(folder / "sent/foreign.toml") << scenario;
    ProgramCall call = cliCall({"simulate", "--scenario", "foreign.toml", "--nodes", "20", "--set",
                                "stop_travel_mm=0.2", "--record", "run.insertion"});
    call.folder = folder / "sent";
    return run(call);
  }

  void expectTreasure()
  {
    EXPECT_EQ(contentOf(folder / "treasure.toml"), "what nobody may lose\n");
    EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("sent", "treasure.toml"));
  }

  const TemporaryFolder folder;
};

TEST_F(ForeignScenario, ThatNamesFilesAboveItIsRefusedAndWritesNothing)
{
  for (const std::string key : {"patient", "array", "friction", "calibration"})
    for (const std::string name :
         {"../treasure.toml", "../../../../../../etc/passwd", "..", "/dev/full", "/dev/zero"}) {
      const ProgramOutcome outcome = simulate(key + " = \"" + name + "\"\n");
      EXPECT_EQ(outcome.status, 1) << key << ' ' << name << outcome.out;
      EXPECT_EQ(outcome.signal, 0) << key << ' ' << name;
      EXPECT_THAT(namesIn(folder / "sent"), testing::ElementsAre("foreign.toml")) << key;
    }
  expectTreasure();
}

TEST_F(ForeignScenario, ReachedThroughALinkStaysWhereItIsToldTo)
{
  fs::create_symlink(folder / "treasure.toml", folder / "sent/run.insertion");
  const ProgramOutcome outcome = simulate("array = \"contour\"\n");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("never overwritten"));
  expectTreasure();
}

TEST_F(ForeignScenario, WithWordsForATitleThatLookLikePathsWritesOnlyItsRecording)
{
  const ProgramOutcome outcome = simulate("title = \"../../treasure.toml\"\narray = \"contour\"\n");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(namesIn(folder / "sent"), testing::ElementsAre("foreign.toml", "run.insertion"));
  expectTreasure();
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// Outputs that would overwrite an input, a recording, another output or a read-only file.

#include <sys/stat.h>

#include <csignal>
#include <map>

#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* shortScenario =
    "array = \"contour\"\nanatomy = \"published\"\nnodes = 20\nstop_travel_mm = 0.2\n";

/// A folder with a recording, a scenario and a patient.
class Outputs : public testing::Test {
protected:
  Outputs()
  {
    std::ofstream(folder / "scenario.toml") << shortScenario;
    std::ofstream(folder / "with-patient.toml") << shortScenario << "patient = \"patient.toml\"\n";
    std::ofstream(folder / "patient.toml") << contentOf(patientFile());
  }

  static std::string patientFile() { return resource("resources/patients/average.toml").string(); }

  void record()
  {
    ASSERT_EQ(
        callHere({"simulate", "--scenario", "scenario.toml", "--record", "run.insertion"}).status,
        0);
  }

  ProgramOutcome callHere(std::vector<std::string> arguments) const
  {
    ProgramCall call = fewDrawsCall(std::move(arguments));
    call.folder = folder.path();
    return run(call);
  }

  /// A refused call changes no file.
  void expectNothingLost(const std::vector<std::string>& arguments, const std::string& says) const
  {
    const auto before = contents();
    const ProgramOutcome outcome = callHere(arguments);
    SCOPED_TRACE(testing::PrintToString(arguments));
    expectRefusal(outcome, says);
    EXPECT_EQ(contents(), before);
  }

  std::vector<std::pair<std::string, std::string>> contents() const
  {
    std::vector<std::pair<std::string, std::string>> all;
    for (const std::string& name : namesIn(folder.path()))
      all.emplace_back(name, contentOf(folder / name));
    return all;
  }

  const TemporaryFolder folder;
};

TEST_F(Outputs, NeverReplaceAnInputOfTheCall)
{
  record();
  const std::string says = "Give --csv another name";
  expectNothingLost({"replay", "run.insertion", "--csv", "run.insertion"}, says);
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--csv", "scenario.toml"}, says);
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--record", "scenario.toml"},
                    "Give --record another name");
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--patient", "patient.toml",
                     "--json", "patient.toml"},
                    "which --patient reads");
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--set", "patient=patient.toml",
                     "--json", "patient.toml"},
                    "which --set patient reads");
  expectNothingLost({"anatomy", "--patient", "patient.toml", "--sections", "patient.toml"},
                    "which --patient reads");
  expectNothingLost({"anatomy", "--import", "patient.toml", "--surface", "patient.toml"},
                    "which --import reads");
  expectNothingLost({"devices", "--replay", "patient.toml", "--json", "patient.toml"},
                    "which --replay reads");
  expectNothingLost({"render", "--patient", "patient.toml", "--out", "patient.toml"},
                    "which --patient reads");
}

TEST_F(Outputs, NeverReplaceAFileThatTheScenarioNames)
{
  expectNothingLost({"simulate", "--scenario", "with-patient.toml", "--json", "patient.toml"},
                    "which the scenario reads");
  expectNothingLost({"render", "--scenario", "with-patient.toml", "--out", "patient.toml"},
                    PERILYMPH_HAS_VTK ? "which the scenario reads" : "has no VTK");
}

/// Every file that a call puts into its folder is replaced by a link: none is written through.
TEST_F(Outputs, OfAFolderAreNeverWrittenThroughLinks)
{
  std::ofstream(folder / "s.toml") << "title = \"Short\"\nscenario = \"mean-flex28\"\n"
                                      "depth = \"scenario\"\n[cochleae]\nmean = true\n[vary]\n"
                                      "nodes = [20]\ndt_ms = [10.0]\nstop_travel_mm = [1.0]\n";
  record();
  ASSERT_EQ(callHere({"study", "run", "s.toml", "--out", "study"}).status, 0);
  const std::vector<std::vector<std::string>> calls = {
      {"study", "run", "s.toml", "--out", "out"},
      {"study", "merge", "out"},
      {"study", "report", "out"},
      {"compare", "run.insertion", "--out", "out"},
      {"plan", "--patient", "measured", "--arrays", "flex24", "--samples", "1", "--out", "out"}};
  for (const auto& call : calls) {
    SCOPED_TRACE(testing::PrintToString(call));
    const auto prepare = [&] {
      fs::remove_all(folder / "out");
      if (call[0] == "study" && call[1] != "run") fs::copy(folder / "study", folder / "out");
      if (call[1] == "merge") fs::remove(folder / "out/study.sqlite");
    };
    prepare();
    std::map<std::string, std::string> before;
    if (fs::exists(folder / "out"))
      for (const std::string& name : namesIn(folder / "out"))
        before[name] = contentOf(folder / "out" / name);
    const ProgramOutcome whole = callHere(call);
    ASSERT_EQ(whole.status, 0) << whole.err;
    for (const std::string& name : namesIn(folder / "out")) {
      const auto old = before.find(name);
      if (old != before.end() && old->second == contentOf(folder / "out" / name)) continue;
      prepare();
      fs::create_directories(folder / "out");
      fs::remove(folder / "out" / name);
      std::ofstream(folder / "thesis") << "three years";
      fs::create_symlink("../thesis", folder / "out" / name);
      const ProgramOutcome outcome = callHere(call);
      EXPECT_NE(outcome.status, 0) << name;
      EXPECT_EQ(contentOf(folder / "thesis"), "three years") << name;
      EXPECT_TRUE(fs::is_symlink(folder / "out" / name)) << name;
    }
  }
}

/// A folder that the user made, with a file of a name that the command uses.
TEST_F(Outputs, OfAFolderNeverReplaceFilesOfTheUser)
{
  std::ofstream(folder / "s.toml") << "title = \"Short\"\nscenario = \"mean-flex28\"\n"
                                      "depth = \"scenario\"\n[cochleae]\nmean = true\n[vary]\n"
                                      "nodes = [20]\ndt_ms = [10.0]\nstop_travel_mm = [1.0]\n";
  const std::vector<std::string> plan = {"plan",   "--patient", "measured", "--arrays",
                                         "flex24", "--samples", "1",        "--out"},
                                 study = {"study", "run", "s.toml", "--out"},
                                 shard = {"study", "shard", "s.toml", "--index",
                                          "1",     "--of",  "1",      "--out"};
  for (const auto& [command, name] : {std::pair{plan, "plan.json"},
                                      {plan, "arrays.csv"},
                                      {plan, "shapes.csv"},
                                      {plan, "force-1.svg"},
                                      {study, "study.sqlite"},
                                      {study, "insertions.csv"},
                                      {shard, "insertions.csv"}}) {
    std::vector<std::string> call = command;
    call.emplace_back("own");
    fs::remove_all(folder / "own");
    fs::create_directory(folder / "own");
    std::ofstream(folder / "own" / name) << "three years";
    expectRefusal(callHere(call), std::string("has a file ") + name + " that this command did not");
    EXPECT_EQ(contentOf(folder / "own" / name), "three years");
    EXPECT_EQ(namesIn(folder / "own").size(), 1u) << "nothing is begun there";
  }
  for (const auto& command : {plan, study}) {  // its own folder, again, with another file in it
    std::vector<std::string> call = command;
    call.push_back(command[0]);
    fs::create_directory(folder / command[0]);
    std::ofstream(folder / command[0] / "thesis.txt") << "three years";
    for (int i = 0; i < 2; ++i) {
      const auto outcome = callHere(call);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
    }
    EXPECT_EQ(contentOf(folder / command[0] / "thesis.txt"), "three years");
  }
}

/// The file of the draws lies elsewhere, with a link to it in the folder.
TEST_F(Outputs, InSqliteAreNeverWrittenThroughLinks)
{
  std::ofstream(folder / "s.toml") << "title = \"Short\"\nscenario = \"mean-flex28\"\n"
                                      "depth = \"scenario\"\n[cochleae]\nmean = true\n[vary]\n"
                                      "nodes = [20]\ndt_ms = [10.0]\nstop_travel_mm = [1.0]\n";
  for (const auto& [call, name] :
       {std::pair<std::vector<std::string>, const char*>{
            {"plan", "--patient", "measured", "--arrays", "flex24", "--samples", "1", "--out",
             "linked"},
            "draws.sqlite"},
        {{"study", "run", "s.toml", "--out", "linked"}, "shard-1-of-1.sqlite"}}) {
    fs::remove_all(folder / "linked");
    ASSERT_EQ(callHere(call).status, 0);
    fs::rename(folder / "linked" / name, folder / name);
    const std::string before = contentOf(folder / name);
    for (const char* target : {name, "nothing"}) {
      fs::remove(folder / "linked" / name);
      fs::create_symlink(folder / target, folder / "linked" / name);
      expectRefusal(callHere(call), "it is a link, which may lead out of its folder");
      EXPECT_EQ(contentOf(folder / name), before);
      EXPECT_FALSE(fs::exists(folder / "nothing"));
    }
  }
}

/// A call is killed while it writes, and repeated.
TEST_F(Outputs, OfKilledCallsAreRemovedByTheNextOne)
{
  const auto isUnfinished = [this] {
    for (const std::string& name : namesIn(folder.path()))
      if (name.find(".part") != std::string::npos) return true;
    return false;
  };
  ProgramCall call = cliCall(
      {"simulate", "--scenario", "scenario.toml", "--set", "speed_mm_s=0.01", "--csv", "a.csv"});
  call.folder = folder.path();
  {
    ChildProcess killed(call);
    ASSERT_TRUE(waitUntil(isUnfinished));
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait(std::chrono::seconds(20)).signal, SIGKILL);
  }
  EXPECT_TRUE(isUnfinished());
  ASSERT_EQ(callHere({"simulate", "--scenario", "scenario.toml", "--csv", "a.csv"}).status, 0);
  EXPECT_FALSE(isUnfinished());
}

TEST_F(Outputs, NeverReplaceAnInputByAnotherNameOfIt)
{
  fs::create_symlink("scenario.toml", folder / "link.csv");
  fs::create_symlink("link.csv", folder / "second-link.csv");
  fs::create_hard_link(folder / "scenario.toml", folder / "hard.csv");
  fs::create_directory_symlink(".", folder / "here");
  const std::vector<std::string> names = {"./scenario.toml",    "link.csv",
                                          "second-link.csv",    "hard.csv",
                                          "here/scenario.toml", folder / "scenario.toml"};
  for (const std::string& name : names) {
    const ProgramOutcome outcome =
        callHere({"simulate", "--scenario", "scenario.toml", "--csv", name});
    expectRefusal(outcome, "which --scenario reads");
    EXPECT_EQ(contentOf(folder / "scenario.toml"), shortScenario) << name;
  }
}

TEST_F(Outputs, OfEveryCommandNeverReplaceARecording)
{
  record();
  fs::copy(folder / "run.insertion", folder / "renamed.db");
  for (const std::string recording : {"run.insertion", "renamed.db"}) {
    const std::vector<std::vector<std::string>> calls = {
        {"simulate", "--scenario", "scenario.toml", "--csv", recording},
        {"simulate", "--scenario", "scenario.toml", "--json", recording},
        {"anatomy", "--preset", "published", "--json", recording},
        {"anatomy", "--preset", "published", "--sections", recording},
        {"anatomy", "--preset", "published", "--surface", recording},
        {"anatomy", "--preset", "published", "--haptic-surface", recording},
        {"render", "--preset", "published", "--out", recording},
        {"devices", "--json", recording},
        {"devices", "--test", "4095", "--capture", recording}};
    for (const auto& call : calls) expectNothingLost(call, "belongs to a recording");
  }
}

TEST_F(Outputs, NeverReplaceTheLogOfARecording)
{
  record();
  std::ofstream(folder / "run.insertion-wal") << "ticks that are not folded in yet";
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--csv", "run.insertion-wal"},
                    "belongs to a recording");
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--record", "new.insertion",
                     "--csv", "new.insertion-wal"},
                    "would both write");
}

TEST_F(Outputs, HaveAFileEach)
{
  const std::vector<std::string> simulate = {"simulate", "--scenario", "scenario.toml"};
  fs::create_symlink("b", folder / "link-to-b");
  for (const auto& [one, other] :
       {std::pair{"a", "a"}, {"a", "./a"}, {"b", "link-to-b"}, {"link-to-b", "b"}}) {
    for (const auto& [first, second] :
         {std::pair{"--csv", "--json"}, {"--csv", "--record"}, {"--json", "--record"}}) {
      std::vector<std::string> call = simulate;
      for (const std::string word : {first, one, second, other}) call.push_back(word);
      expectNothingLost(call, "would both write");
    }
  }
  expectNothingLost({"anatomy", "--preset", "published", "--json", "a", "--sections", "a"},
                    "--json and --sections would both write");
}

TEST_F(Outputs, LeaveAReadOnlyFile)
{
  std::ofstream(folder / "old.csv") << "kept\n";
  ::chmod((folder / "old.csv").c_str(), 0444);
  expectNothingLost({"simulate", "--scenario", "scenario.toml", "--csv", "old.csv"}, "read-only");
  expectNothingLost({"devices", "--json", "old.csv"}, "read-only");
  fs::create_directory(folder / "out");
  fs::rename(folder / "old.csv", folder / "out/curves.csv");
  record();
  expectRefusal(callHere({"compare", "run.insertion", "--out", "out"}), "read-only");
  EXPECT_EQ(contentOf(folder / "out/curves.csv"), "kept\n");
}

TEST_F(Outputs, OfAFolderNeverReplaceAnInputOrARecording)
{
  record();
  fs::create_directory(folder / "out");
  fs::copy(folder / "run.insertion", folder / "out/curves.csv");
  expectRefusal(callHere({"compare", "run.insertion", "--out", "out"}), "belongs to a recording");
  fs::remove(folder / "out/curves.csv");
  for (const char* name : {"calibration.toml", "summary.json"})
    fs::copy(folder / "patient.toml", folder / "out" / name);
  expectRefusal(callHere({"calibrate", "--variability", "out/calibration.toml", "--out", "out"}),
                "which --variability reads");
  expectRefusal(callHere({"validate", "--set", "array='out/summary.json'", "--out", "./out"}),
                "which --set array reads");
  for (const char* name : {"calibration.toml", "summary.json"})
    EXPECT_EQ(contentOf(folder / "out" / name), contentOf(patientFile()));
}

TEST_F(Outputs, ReplaceWhatAnEarlierCallWrote)
{
  for (int i = 0; i < 2; ++i) {
    const ProgramOutcome outcome = callHere(
        {"simulate", "--scenario", "scenario.toml", "--csv", "run.csv", "--json", "run.json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  EXPECT_THAT(contentOf(folder / "run.csv"), testing::StartsWith("time_s"));
}

TEST_F(Outputs, MayShareAStreamThatStoresNothing)
{
  const ProgramOutcome outcome = callHere(
      {"simulate", "--scenario", "scenario.toml", "--csv", "/dev/null", "--json", "/dev/null"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

}  // namespace
}  // namespace perilymph::test

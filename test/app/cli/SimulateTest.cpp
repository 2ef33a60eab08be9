// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

TEST(Simulate, WritesRowsResultsAndARecording)
{
  const TemporaryFolder folder;
  const auto outcome = cli(shortSimulation({"--csv", folder / "a.csv", "--json", folder / "a.json",
                                            "--record", folder / "a.insertion", "--seed", "5"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("peak force"));
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"a.csv", "a.insertion", "a.json"}));

  const auto rows = linesOf(folder / "a.csv");
  EXPECT_EQ(rows.front().substr(0, 27), "time_s,travel_mm,depth_mm,s");
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  const auto recorded = session::RecordedInsertion::open(folder / "a.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(rows.size() - 1, recorded->ticks());  // one row per tick
  EXPECT_EQ(json["ticks"], recorded->ticks());
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["overruns"], 0);
  EXPECT_EQ(json["scenario"]["nodes"], 30);
  EXPECT_EQ(json["scenario"]["stop_travel_mm"], 0.5);
  EXPECT_EQ(json["scenario"]["patient_numbers"]["st_length_mm"], 35.58);
  for (const char* key :
       {"version", "peak_force_N", "peak_depth_mm", "work_J", "final_depth_mm", "final_angle_deg"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_NEAR(json["final_depth_mm"].get<double>(), 2.0 + 0.5, 0.01);
}

TEST(Simulate, NamesAnEarlyEndInWordsJsonAndRecording)
{
  const TemporaryFolder folder;
  // a carrier that keeps a tenth of its curvature bows in front of the opening
  const auto outcome = cli({"simulate", "--scenario", "contour-published", "--set", "nodes=50",
                            "--set", "start_inside_mm=1", "--set", "approach_turn_deg=-5", "--set",
                            "residual_curvature_fraction=0.1", "--json", folder / "a.json",
                            "--record", folder / "a.insertion"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("out_of_opening     the array bowed in front of the opening"));
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  EXPECT_EQ(json["end"], "out_of_opening");
  EXPECT_LT(json["final_travel_mm"].get<double>(), 16.5);
  const auto replayed = cli({"replay", folder / "a.insertion", "--verify"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
}

TEST(Simulate, FailsIfTheTipNeverEntersAndSaysWhatToDo)
{
  const TemporaryFolder folder;
  const auto outcome = cli({"simulate", "--scenario", "contour-published", "--set", "nodes=50",
                            "--set", "start_inside_mm=0", "--set", "residual_curvature_fraction=1",
                            "--json", folder / "a.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("did not enter the opening"));
  EXPECT_THAT(outcome.err, HasSubstr("start_inside_mm"));
  EXPECT_TRUE(namesIn(folder.path()).empty());
}

TEST(Simulate, KeepsARowEverySoManyMilliseconds)
{
  const TemporaryFolder folder;
  const auto outcome = cli(shortSimulation({"--csv", folder / "a.csv", "--every-ms", "50"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto rows = linesOf(folder / "a.csv");
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_NEAR(std::stod(rows[i]), 0.05 * static_cast<double>(i - 1), 1e-9);
  EXPECT_GE(rows.size(), 6u);  // 0.5 mm at 2 mm/s: 0 to 250 ms
}

TEST(Simulate, WritesTheSameBytesEveryTimeInAnyLocale)
{
  const TemporaryFolder folder;
  ASSERT_EQ(cli(shortSimulation({"--csv", folder / "a.csv", "--json", folder / "a.json"})).status,
            0);
  ProgramCall call =
      cliCall(shortSimulation({"--csv", folder / "b.csv", "--json", folder / "b.json"}));
  call.environment = {{"LC_ALL", "de_DE.UTF-8"}};
  ASSERT_EQ(run(call).status, 0);
  EXPECT_EQ(contentOf(folder / "a.csv"), contentOf(folder / "b.csv"));
  EXPECT_EQ(contentOf(folder / "a.json"), contentOf(folder / "b.json"));
}

TEST(Simulate, SaysWhatIsWrongWithTheScenario)
{
  expectRefusal(cli({"simulate", "--scenario", "nowhere"}), "contour-published");
  expectRefusal(cli(shortSimulation({"--set", "speed_mm_s=-3"})), "between 0.01 and 200");
  expectRefusal(cli(shortSimulation({"--set", "speed=3"})), "speed_mm_s");
  expectRefusal(cli(shortSimulation({"--set", "friction=ice"})), "paper");
  expectRefusal(cli(shortSimulation({"--set", "nodes=3"})), "between 8 and 1024");
  expectRefusal(cli(shortSimulation({"--model", "jelly"})), "'rod' or 'points'");
  expectRefusal(cli(shortSimulation({"--patient", "nobody"})), "average");
  expectRefusal(cli(shortSimulation({"--array", "spaghetti"})), "contour");
  const TemporaryFolder folder;
  expectRefusal(cli({"simulate", "--scenario", folder.path()}), "folder");
  std::ofstream(folder / "broken.toml") << "nodes = = 3\n";
  expectRefusal(cli({"simulate", "--scenario", folder / "broken.toml"}), "broken.toml:1");
}

TEST(Simulate, SaysWhereItCannotWriteBeforeItRuns)
{
  const TemporaryFolder folder;
  expectRefusal(cli(shortSimulation({"--csv", folder / "no" / "a.csv"})), "does not exist");
  expectRefusal(cli(shortSimulation({"--json", folder.path()})), "is a folder");
  expectRefusal(cli(shortSimulation({"--record", folder / "no" / "a.insertion"})),
                "does not exist");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

TEST(Simulate, LeavesNothingHalfWrittenWhereNothingMayBeWritten)
{
  // /proc refuses every new file, even for root.
  expectRefusal(cli(shortSimulation({"--csv", "/proc/a.csv"})), "/proc");
  expectRefusal(cli(shortSimulation({"--record", "/proc/a.insertion"})), "/proc/a.insertion");
}

TEST(Simulate, NeverOverwritesARecording)
{
  const TemporaryFolder folder;
  ASSERT_EQ(cli(shortSimulation({"--record", folder / "a.insertion"})).status, 0);
  const std::string before = contentOf(folder / "a.insertion");
  expectRefusal(cli(shortSimulation({"--record", folder / "a.insertion"})), "never overwritten");
  EXPECT_EQ(contentOf(folder / "a.insertion"), before);
}

TEST(InterruptedSimulation, LeavesNothingButAReadableRecording)
{
  const TemporaryFolder folder;
  // slow enough to be interrupted halfway
  ChildProcess child(
      cliCall({"simulate", "--scenario", "contour-published", "--set", "speed_mm_s=0.05", "--csv",
               folder / "a.csv", "--json", folder / "a.json", "--record", folder / "a.insertion"}));
  ASSERT_TRUE(waitUntil([&] { return namesIn(folder.path()).size() >= 2; }));
  child.send(SIGINT);
  const auto outcome = child.wait(std::chrono::minutes(1));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("Interrupted"));
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a.insertion"});
  const auto recorded = session::RecordedInsertion::open(folder / "a.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_TRUE(recorded->wasClosed());
}

// The model of points where it is allowed: no force beyond a hand's 2 N, no energy from nothing, and
// one peak in the output and in the recording.
TEST(Simulate, TheModelOfPointsWithinItsLimits)
{
  const std::vector<std::vector<std::string>> settings = {
      {"coupling=spring", "dt_ms=1", "nodes=17", "speed_mm_s=18"},
      {"coupling=spring", "dt_ms=0.5", "nodes=7", "start_inside_mm=3", "speed_mm_s=9"},
      {"coupling=rigid", "dt_ms=10", "nodes=11", "speed_mm_s=5"}};
  for (const auto& values : settings) {
    SCOPED_TRACE(testing::PrintToString(values));
    const TemporaryFolder folder;
    std::vector<std::string> call = {
        "simulate",        "--scenario", "mean-contour",        "--model",
        "points",          "--set",      "stop_travel_mm=13",   "--json",
        folder / "a.json", "--record",   folder / "a.insertion"};
    for (const std::string& value : values) call.insert(call.end(), {"--set", value});
    const auto outcome = cli(call);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
    EXPECT_EQ(json["end"], "finished");
    EXPECT_LT(json["peak_force_N"].get<double>(), 2.0);
    EXPECT_GT(json["peak_force_N"].get<double>(), 0.05);
    EXPECT_GT(json["work_J"].get<double>(), 0.0);
    const auto recorded = session::summarize(std::filesystem::path(folder / "a.insertion"));
    EXPECT_EQ(recorded.highlights.peakForce, json["peak_force_N"].get<double>());
  }
}

}  // namespace
}  // namespace perilymph::test

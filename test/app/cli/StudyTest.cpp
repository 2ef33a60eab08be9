// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <future>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* study = R"(title = "Short"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
mean = true
virtual = 1
[vary]
nodes = [20]
dt_ms = [10.0]
stop_travel_mm = [1.0]
speed_mm_s = [4.0, 5.0]
)";

class Studies : public testing::Test {
protected:
  void SetUp() override { std::ofstream(folder_ / "s.toml") << study; }

  std::string file() const { return folder_ / "s.toml"; }
  std::string out(const std::string& name) const { return folder_ / name; }

private:
  TemporaryFolder folder_;
};

TEST_F(Studies, AreCheckedBeforeTheyRun)
{
  const auto outcome = cli({"study", "check", file()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("Short: 4 insertions, 2 cochleae with 2 each\n"));
  EXPECT_THAT(outcome.out, testing::HasSubstr("on disk"));
  std::ofstream(file(), std::ios::app) << "frictoin = [\"tissue\"]\n";
  expectRefusal(cli({"study", "check", file()}), "frictoin");
  expectRefusal(cli({"study", "check", out("none.toml")}), "none.toml");
}

TEST_F(Studies, AreCountedWholeWhicheverPartsAreThere)
{
  const auto shard = [this](const char* index, const char* count) {
    const auto outcome =
        cli({"study", "shard", file(), "--index", index, "--of", count, "--out", out("parts")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  };
  const auto status = [this] { return cli({"study", "status", out("parts")}).out; };
  shard("2", "4");
  EXPECT_THAT(status(), testing::HasSubstr("\n1 part, 1 of 4 insertions of the study\n"));
  shard("1", "2");  // of another division, with the insertion of the first
  EXPECT_THAT(status(), testing::HasSubstr("\n2 parts, 2 of 4 insertions of the study\n"));
  shard("4", "4");
  EXPECT_THAT(status(), testing::HasSubstr("\n3 parts, 3 of 4 insertions of the study\n"));
  std::string other(study);
  std::ofstream(file()) << other.replace(other.find("5.0"), 3, "6.0");
  shard("3", "4");
  EXPECT_THAT(status(), testing::HasSubstr("shard-3-of-4.sqlite is of another study than "));
  EXPECT_THAT(status(), testing::HasSubstr("\n3 parts, 3 of 4 insertions of the study\n"));
}

TEST_F(Studies, GiveTheSameFilesAsAWholeAndInParts)
{
  ASSERT_EQ(cli({"study", "run", file(), "--out", out("whole"), "--jobs", "2"}).status, 0);
  for (const char* index : {"2", "1", "3"}) {
    const auto outcome =
        cli({"study", "shard", file(), "--index", index, "--of", "3", "--out", out("parts")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  const auto status = cli({"study", "status", out("parts")});
  EXPECT_THAT(status.out, testing::HasSubstr("shard-3-of-3.sqlite: 2 of 2\n"));
  EXPECT_THAT(status.out, testing::HasSubstr("3 parts, 4 of 4 insertions of the study\n"));
  const auto merged = cli({"study", "merge", out("parts")});
  ASSERT_EQ(merged.status, 0) << merged.err;
  EXPECT_THAT(merged.out, testing::HasSubstr("4 insertions\n"));
  for (const char* name : {"study.sqlite", "insertions.csv"})
    EXPECT_TRUE(contentOf(fs::path(out("whole")) / name) ==
                contentOf(fs::path(out("parts")) / name))
        << name;
  const auto table = linesOf(fs::path(out("parts")) / "insertions.csv");
  ASSERT_EQ(table.size(), 5u);
  EXPECT_EQ(table[0].substr(0, 27), "number,cochlea,A_mm,B_mm,st");
}

TEST_F(Studies, StartTogetherInAFolderThatDoesNotExist)
{
  for (const std::string round : {"a", "b", "c", "d"}) {
    std::vector<std::future<ProgramOutcome>> parts;
    for (const std::string index : {"1", "2", "3", "4"})
      parts.push_back(std::async(std::launch::async, [&, index] {
        return cli({"study", "shard", file(), "--index", index, "--of", "4", "--out", out(round)});
      }));
    for (auto& part : parts) {
      const ProgramOutcome outcome = part.get();
      EXPECT_EQ(outcome.status, 0) << outcome.err;
    }
  }
}

TEST_F(Studies, AreReportedWithFigures)
{
  ASSERT_EQ(cli({"study", "run", file(), "--out", out("whole")}).status, 0);
  const auto outcome = cli({"study", "report", out("whole")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = contentOf(fs::path(out("whole")) / "report.md");
  EXPECT_THAT(text, testing::HasSubstr("# Short\n\n4 insertions: 4 finished."));
  EXPECT_THAT(text, testing::HasSubstr("| speed_mm_s = 4 | 2 | 2 of 2 (34 to 100) | 0 | 0 |"));
  for (const char* name : {"angle.svg", "peak-force.svg"})
    EXPECT_THAT(contentOf(fs::path(out("whole")) / name), testing::HasSubstr("<svg"));
  expectRefusal(cli({"study", "report", out("none")}), "study.sqlite");
}

TEST_F(Studies, OfMeasuresThatWereChangedByHandSaySoInEveryCommandAndEveryRow)
{
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.2), millimeters(6.8), std::nullopt};
  patient.origin = {"perilymph 0.3.0", std::string(64, 'a'), "", "RW"};
  const fs::path measures = out("p.toml");
  ASSERT_TRUE(anatomy::savePatient(patient, measures));
  std::string text(study);
  text.replace(text.find("virtual = 1"), 11, "patients = [\"p.toml\"]");
  std::ofstream(file()) << text;
  const auto intact = cli({"study", "run", file(), "--out", out("intact")});
  ASSERT_EQ(intact.status, 0) << intact.err;
  EXPECT_EQ(intact.err, "");
  EXPECT_THAT(contentOf(out("intact/insertions.csv")), testing::HasSubstr("\n3,p.toml,"));

  std::string changed = contentOf(measures);
  changed.replace(changed.find("9.2"), 3, "9.6");
  std::ofstream(measures) << changed;
  const char* sentence =
      "The measures of P-017 were changed by hand after the program wrote them. Do not use them as "
      "measured in a CT.\n";
  const std::string folder = out("changed");
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"study", "check", file()},
        {"study", "submit", file(), "--shards", "2", "--out", folder, "--dry-run"},
        {"study", "shard", file(), "--index", "1", "--of", "2", "--out", folder},
        {"study", "shard", file(), "--index", "2", "--of", "2", "--out", folder},
        {"study", "status", folder},
        {"study", "merge", folder},
        {"study", "report", folder},
        {"study", "run", file(), "--out", out("whole")}}) {
    const auto outcome = cli(call);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, sentence) << call[1];
  }
  EXPECT_THAT(contentOf(folder + "/report.md"), testing::HasSubstr(sentence));
  const auto rows = linesOf(folder + "/insertions.csv");
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[2].substr(0, 7), "1,mean,");
  for (const std::size_t row : {3, 4})
    EXPECT_THAT(rows[row], testing::HasSubstr(",p.toml (measures changed by hand),"));
}

TEST_F(Studies, SayWhatIsWrongWithTheCall)
{
  expectRefusal(cli({"study", "shard", file(), "--index", "4", "--of", "3", "--out", out("parts")}),
                "above --of 3");
  expectRefusal(cli({"study", "merge", out("none")}), "cannot be read");
  expectUsageError(cli({"study", "run", file()}), "--out");
  expectUsageError(cli({"study"}), "subcommand");
}

TEST_F(Studies, AreSubmittedToSlurmByScriptsThatCanBeReadBefore)
{
  const auto outcome = cli({"study", "submit", file(), "--shards", "7", "--out", out("jobs"),
                            "--partition", "short", "--sbatch-option=--mem=2G", "--dry-run"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* line : {"#SBATCH --array=1-7\n", "#SBATCH --partition=short\n",
                           "#SBATCH --mem=2G\n", "study shard", "study merge"})
    EXPECT_THAT(outcome.out, testing::HasSubstr(line));
  EXPECT_FALSE(fs::exists(out("jobs")));
}

/// Programs in place of Slurm's, which answer as a site's might.
class Submitting : public Studies {
protected:
  void SetUp() override
  {
    Studies::SetUp();
    fs::create_directory(out("bin"));
    answerOf("scontrol", "echo 'MaxArraySize            = 4'; echo 'MaxJobCount = 100'");
  }

  void answerOf(const std::string& program, const std::string& commands)
  {
    const std::string file = out("bin/" + program);
    std::ofstream(file) << "#!/bin/sh\necho \"$@\" >> '" << out(program + ".calls") << "'\n"
                        << commands << "\n";
    fs::permissions(file, fs::perms::owner_all);
  }

  ProgramOutcome submit(const std::string& shards = "3", const std::vector<std::string>& more = {})
  {
    ProgramCall call =
        cliCall({"study", "submit", file(), "--shards", shards, "--out", out("jobs")});
    call.arguments.insert(call.arguments.end(), more.begin(), more.end());
    call.environment = {{"PATH", out("bin") + ":" + std::getenv("PATH")}};
    return run(call);
  }
};

TEST_F(Submitting, ListensToStandardOutputOnly)
{
  answerOf("sbatch", "echo 'sbatch: lua: welcome `touch X`' >&2; echo 1234");
  const auto outcome = submit();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("job 1234: 3 parts of 4 insertions\n"));
  EXPECT_THAT(outcome.err, testing::HasSubstr("sbatch: lua: welcome `touch X`\n"));
  const auto calls = linesOf(out("sbatch.calls"));
  ASSERT_EQ(calls.size(), 2u);
  EXPECT_EQ(calls[0], "--parsable " + out("jobs/shards.sh"));
  EXPECT_EQ(calls[1], "--parsable --dependency=afterok:1234 " + out("jobs/merge.sh"));
}

TEST_F(Submitting, ReplacesItsOwnScriptsAlone)
{
  answerOf("sbatch", "echo 77");
  for (const char* name : {"shards.sh", "merge.sh", "insertions.csv"}) {
    fs::remove_all(out("jobs"));
    fs::create_directory(out("jobs"));
    std::ofstream(out("jobs/") + name) << "#!/bin/sh\necho mine\n";
    expectRefusal(submit(), std::string("has a file ") + name + " that this command did not");
    EXPECT_EQ(contentOf(out("jobs/") + name), "#!/bin/sh\necho mine\n");
  }
  EXPECT_FALSE(fs::exists(out("sbatch.calls")));
  fs::remove_all(out("jobs"));
  EXPECT_EQ(submit().status, 0);
  EXPECT_EQ(submit("2").status, 0) << "the same folder again";
}

TEST_F(Submitting, TakesNoAnswerThatIsNoNumber)
{
  for (const std::string answer : {"`touch X`", "$(touch X)", "welcome\n1234", "1234;touch X"}) {
    answerOf("sbatch", "printf '" + answer + "\\n'");
    expectRefusal(submit(), "which is no number of a job");
  }
  EXPECT_THAT(linesOf(out("sbatch.calls")), testing::Each(testing::HasSubstr("shards.sh")));
  EXPECT_FALSE(fs::exists("X"));
}

TEST_F(Submitting, ShowsTheLinesOfAnErrorAsOne)
{
  answerOf("sbatch",
           "printf 'sbatch: error: no partition\\nsbatch: error: goodbye\\n' >&2; exit 1");
  expectRefusal(submit(), "sbatch: error: no partition; sbatch: error: goodbye");
}

TEST_F(Submitting, NamesTheJobsThatRunWhereTheMergeIsRefused)
{
  answerOf("sbatch", "case \"$*\" in *merge.sh) echo no >&2; exit 1;; *) echo 77;; esac");
  expectRefusal(submit(), "Submitted before and not withdrawn: job 77");
}

TEST_F(Submitting, DividesWhatMaxArraySizeForbids)
{
  answerOf("sbatch",
           "case \"$*\" in *-2.sh) echo 78;; *merge.sh) echo 80;; *-3.sh) echo 79;; "
           "*) echo 77;; esac");
  const auto outcome = submit("7");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("3 arrays for MaxArraySize=4"));
  EXPECT_THAT(linesOf(out("sbatch.calls")).back(),
              testing::HasSubstr("--dependency=afterok:77:78:79 "));
  EXPECT_THAT(contentOf(out("jobs/shards-3.sh")), testing::HasSubstr("--array=1-1\n"));
  expectRefusal(submit("100"), "MaxJobCount=100");
}

TEST_F(Submitting, RefusesLineBreaksBeforeAnythingIsWritten)
{
  answerOf("sbatch", "echo 1");
  for (const char* option : {"--partition", "--time", "--sbatch-option"})
    expectRefusal(submit("3", {std::string(option) + "=-a\ntouch X"}), option);
  EXPECT_FALSE(fs::exists(out("jobs")));
  EXPECT_FALSE(fs::exists(out("sbatch.calls")));
}

}  // namespace
}  // namespace perilymph::test

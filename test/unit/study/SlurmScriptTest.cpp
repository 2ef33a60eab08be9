// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/SlurmScript.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace perilymph::study {
namespace {

using testing::HasSubstr;
using testing::Not;

SlurmRequest request()
{
  SlurmRequest wanted;
  wanted.program = "/opt/perilymph/bin/perilymph-cli";
  wanted.study = "/data/length's study.toml";
  wanted.folder = "/data/out";
  wanted.shards = 16;
  return wanted;
}

SlurmJobs jobsOf(const SlurmRequest& wanted, const SlurmLimits& limits = {})
{
  const auto jobs = slurmJobs(wanted, limits);
  EXPECT_TRUE(jobs) << jobs.error().message;
  return jobs ? *jobs : SlurmJobs{};
}

TEST(SlurmScript, RunsOneShardPerTask)
{
  const SlurmJobs jobs = jobsOf(request());
  ASSERT_EQ(jobs.arrays.size(), 1u);
  EXPECT_EQ(jobs.arrays[0].name, "shards.sh");
  const std::string& script = jobs.arrays[0].text;
  EXPECT_THAT(script, HasSubstr("#SBATCH --array=1-16\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --requeue\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --output=\"/data/out/shard-%a.log\"\n"));
  EXPECT_THAT(script,
              HasSubstr("exec '/opt/perilymph/bin/perilymph-cli' study shard "
                        "'/data/length'\\''s study.toml' --index \"$((SLURM_ARRAY_TASK_ID + 0))\" "
                        "--of 16 --jobs 1 --out '/data/out'\n"));
}

TEST(SlurmScript, HasThePartitionTheTimeAndFurtherOptionsOnlyIfGiven)
{
  EXPECT_THAT(jobsOf(request()).arrays[0].text, Not(HasSubstr("--partition")));
  SlurmRequest wanted = request();
  wanted.partition = "short";
  wanted.time = "02:00:00";
  wanted.options = {"--mem=2G"};
  const SlurmJobs jobs = jobsOf(wanted);
  for (const std::string& script : {jobs.arrays[0].text, jobs.merge.text}) {
    EXPECT_THAT(script, HasSubstr("#SBATCH --partition=short\n"));
    EXPECT_THAT(script, HasSubstr("#SBATCH --time=02:00:00\n"));
    EXPECT_THAT(script, HasSubstr("#SBATCH --mem=2G\n"));
  }
}

TEST(SlurmScript, MergesTheSameFolder)
{
  const SlurmJobs jobs = jobsOf(request());
  EXPECT_EQ(jobs.merge.name, "merge.sh");
  EXPECT_THAT(jobs.merge.text, HasSubstr("study merge '/data/out'\n"));
  EXPECT_THAT(jobs.merge.text, Not(HasSubstr("--array")));
}

// Every shard is run by one task, and no task has a number that Slurm refuses.
TEST(SlurmScript, DealsTheShardsOutToArraysThatSlurmTakes)
{
  for (const std::size_t size : {2u, 3u, 17u, 18u, 1001u}) {
    for (const std::size_t shards : {1u, 2u, 16u, 17u, 100u}) {
      SlurmRequest wanted = request();
      wanted.shards = shards;
      std::size_t next = 1;
      std::set<std::string> names, logs;
      for (const SlurmScript& script : jobsOf(wanted, {size, 10000}).arrays) {
        EXPECT_TRUE(names.insert(script.name).second) << script.name;
        std::size_t tasks = 0, offset = 0;
        const std::size_t array = script.text.find("--array=1-");
        const std::size_t index = script.text.find("TASK_ID + ");
        const std::size_t log = script.text.find("--output=");
        ASSERT_NE(array, std::string::npos);
        ASSERT_NE(index, std::string::npos);
        EXPECT_TRUE(logs.insert(script.text.substr(log, script.text.find('\n', log) - log)).second);
        tasks = std::stoul(script.text.substr(array + 10));
        offset = std::stoul(script.text.substr(index + 10));
        EXPECT_LT(tasks, size);  // numbers of tasks end below MaxArraySize
        EXPECT_EQ(offset + 1, next);
        next += tasks;
      }
      EXPECT_EQ(next, shards + 1);
    }
  }
}

TEST(SlurmScript, NamesTheLimitThatIsExceeded)
{
  SlurmRequest wanted = request();
  wanted.shards = 100;
  EXPECT_TRUE(slurmJobs(wanted, {1001, 101}));
  const auto many = slurmJobs(wanted, {1001, 100});
  ASSERT_FALSE(many);
  EXPECT_THAT(many.error().message, HasSubstr("MaxJobCount=100"));
  for (const std::size_t none : {0u, 1u}) {
    const auto without = slurmJobs(wanted, {none, 10000});
    ASSERT_FALSE(without);
    EXPECT_THAT(without.error().message, HasSubstr("MaxArraySize"));
  }
}

TEST(SlurmScript, RefusesWhatWouldAddALine)
{
  const std::vector<std::string> breaks = {"\n", "\r", "\t", "\x1b[2J", "\x7f", "\xc2\x85", "\xff"};
  for (const std::string& control : breaks) {
    const std::string bad = "a" + control + "touch X";
    std::vector<SlurmRequest> requests(6, request());
    requests[0].program = bad;
    requests[1].study = bad;
    requests[2].folder = bad;
    requests[3].partition = bad;
    requests[4].time = bad;
    requests[5].options = {"--mem=2G", "--" + bad};
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const auto jobs = slurmJobs(requests[i], {});
      ASSERT_FALSE(jobs) << i;
      EXPECT_EQ(jobs.error().message.find_first_of("\n\r\t\x1b\x7f"), std::string::npos) << i;
    }
  }
}

TEST(SlurmScript, RefusesWordsThatWouldBeOtherOptions)
{
  for (const char* partition : {"a b", "a\"", "a --wrap=id", "a#b", "$(id)", "`id`", "a\\b"}) {
    SlurmRequest wanted = request();
    wanted.partition = partition;
    EXPECT_FALSE(slurmJobs(wanted, {})) << partition;
  }
  for (const char* time : {"1 h", "soon", "02:00:00 --wrap=id", "%j"}) {
    SlurmRequest wanted = request();
    wanted.time = time;
    EXPECT_FALSE(slurmJobs(wanted, {})) << time;
  }
  SlurmRequest wanted = request();
  wanted.options = {"merge.sh"};
  EXPECT_FALSE(slurmJobs(wanted, {}));
  wanted = request();
  wanted.folder = "/data/a\\b";
  EXPECT_FALSE(slurmJobs(wanted, {}));
}

TEST(SlurmScript, KeepsAFolderNameAsItIs)
{
  SlurmRequest wanted = request();
  wanted.folder = "/data/100%j \"wide\"";
  EXPECT_THAT(jobsOf(wanted).arrays[0].text,
              HasSubstr("#SBATCH --output=\"/data/100%%j \\\"wide\\\"/shard-%a.log\"\n"));
}

TEST(SlurmAnswers, AreTheNumberOfAJobAndNothingElse)
{
  for (const char* answer : {"1234\n", "1234", "1234;cluster-1\n"}) {
    const auto number = readJobNumber(answer);
    ASSERT_TRUE(number) << answer;
    EXPECT_EQ(*number, "1234");
  }
  for (const std::string& answer :
       {std::string(), std::string("\n"), std::string("sbatch: lua: welcome\n1234\n"),
        std::string("`touch X`"), std::string("1234;`touch X`"), std::string("1234; cluster"),
        std::string("1234\n1235\n"), std::string(" 1234"), std::string("-1"),
        std::string("12345678901"), std::string("1234;") + std::string(1000, 'c'),
        std::string("1234\n\n"), std::string("Submitted batch job 1234\n"),
        std::string("1234\0", 5)}) {
    const auto number = readJobNumber(answer);
    ASSERT_FALSE(number) << answer;
    EXPECT_EQ(number.error().message.find('\n'), std::string::npos);
  }
}

TEST(SlurmAnswers, NameTheLimits)
{
  const auto limits = readLimits(
      "Configuration data as of 2026-11-26T09:00:00\nMaxArraySize            = 1001\n"
      "MaxBatchRequeue         = 5\nMaxJobCount             = 10000\nMaxJobId = 67043328\n");
  ASSERT_TRUE(limits) << limits.error().message;
  EXPECT_EQ(limits->maxArraySize, 1001u);
  EXPECT_EQ(limits->maxJobCount, 10000u);
  for (const char* answer : {"", "MaxArraySize = 1001\n", "MaxJobCount = 10\nMaxArraySize = many\n",
                             "MaxJobCount = 10\nNoMaxArraySize = 3\n"}) {
    const auto none = readLimits(answer);
    ASSERT_FALSE(none) << answer;
    EXPECT_THAT(none.error().message, HasSubstr("scontrol show config"));
  }
}

}  // namespace
}  // namespace perilymph::study

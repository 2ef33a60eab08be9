// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/SlurmScript.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(SlurmScript, RunsOneShardPerTask)
{
  const std::string script = shardScript(request());
  EXPECT_THAT(script, HasSubstr("#SBATCH --array=1-16\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --requeue\n"));
  EXPECT_THAT(script,
              HasSubstr("exec '/opt/perilymph/bin/perilymph-cli' study shard "
                        "'/data/length'\\''s study.toml' --index \"$SLURM_ARRAY_TASK_ID\" --of 16 "
                        "--jobs 1 --out '/data/out'\n"));
}

TEST(SlurmScript, HasThePartitionTheTimeAndFurtherOptionsOnlyIfGiven)
{
  EXPECT_THAT(shardScript(request()), Not(HasSubstr("--partition")));
  SlurmRequest wanted = request();
  wanted.partition = "short";
  wanted.time = "02:00:00";
  wanted.options = {"--mem=2G"};
  for (const std::string& script : {shardScript(wanted), mergeScript(wanted)}) {
    EXPECT_THAT(script, HasSubstr("#SBATCH --partition=short\n"));
    EXPECT_THAT(script, HasSubstr("#SBATCH --time=02:00:00\n"));
    EXPECT_THAT(script, HasSubstr("#SBATCH --mem=2G\n"));
  }
}

TEST(SlurmScript, MergesTheSameFolder)
{
  EXPECT_THAT(mergeScript(request()), HasSubstr("study merge '/data/out'\n"));
  EXPECT_THAT(mergeScript(request()), Not(HasSubstr("--array")));
}

}  // namespace
}  // namespace perilymph::study

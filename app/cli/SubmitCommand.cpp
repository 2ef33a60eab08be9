// SPDX-License-Identifier: BSD-3-Clause

// `study submit`: a job array under Slurm, and a merge that waits for it.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "Commands.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/study/SlurmScript.h"
#include "perilymph/study/Study.h"

namespace perilymph::cli {

namespace {

namespace fs = std::filesystem;

/// Submits a script. @return the number of its job.
Result<std::string> submit(const std::string& options, const fs::path& script)
{
  const std::string command =
      "sbatch --parsable " + options + study::shellQuoted(script.string()) + " 2>&1";
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return Error{"sbatch cannot be started."};
  std::string said;
  std::array<char, 256> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) said += buffer.data();
  const int status = ::pclose(pipe);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return Error{"sbatch refused " + script.string() + ": " + said +
                 ". Is Slurm installed, and is the partition right? --dry-run prints the scripts."};
  // "1234" or "1234;cluster"
  return said.substr(0, said.find(';'));
}

}  // namespace

Result<Done> submitStudy(const StudyOptions& options)
{
  const auto study = study::loadStudy(options.file);
  if (!study) return study.error();
  study::SlurmRequest request;
  std::error_code problem;
  request.program = fs::read_symlink("/proc/self/exe", problem);
  if (problem) request.program = "perilymph-cli";
  request.study = fs::absolute(options.file);
  request.folder = fs::absolute(options.folder);
  request.shards = options.shards;
  request.partition = options.partition;
  request.time = options.time;
  request.options = options.sbatchOptions;
  const std::string shards = study::shardScript(request), merge = study::mergeScript(request);
  if (options.isDryRun) {
    printText(shards + "\n" + merge);
    return Done{};
  }

  fs::create_directories(request.folder, problem);
  if (problem)
    return Error{request.folder.string() + " cannot be created: " + problem.message() +
                 ". Give another folder."};
  for (const auto& [name, text] : {std::pair("shards.sh", &shards), std::pair("merge.sh", &merge)})
    if (const auto done = writeWhole(request.folder / name, *text); !done) return done;
  const auto array = submit("", request.folder / "shards.sh");
  if (!array) return array.error();
  const auto after = submit("--dependency=afterok:" + *array + " ", request.folder / "merge.sh");
  if (!after) return after.error();
  print("job {}: {} parts of {} insertions\njob {}: merge, after it\n", *array, options.shards,
        study->size(), *after);
  return Done{};
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause

// `study submit`: a job array under Slurm, and a merge that waits for it.

#include <chrono>
#include <filesystem>

#include "Commands.h"
#include "OutputFolder.h"
#include "StudyOptions.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Program.h"
#include "perilymph/study/SlurmScript.h"
#include "perilymph/study/Study.h"

namespace perilymph::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes longestAnswer{2};  // of a controller under load

/// What a program of Slurm answers; its own sentences go to standard error.
Result<std::string> ask(const std::string& program, const std::vector<std::string>& arguments)
{
  const auto answer = runProgram(program, arguments, longestAnswer);
  if (!answer)
    return Error{program + " cannot be used: " + answer.error().message +
                 ". Is Slurm installed? --dry-run prints the scripts."};
  const std::string said = linesTogether(answer->errors);
  if (answer->status != 0)
    return Error{program + " refused: " + (said.empty() ? "it gives no reason" : said) +
                 ". Is the partition right? --dry-run prints the scripts."};
  if (!said.empty()) printError("{}\n", said);
  return answer->output;
}

/// Submits a script. @return the number of its job.
Result<std::string> submit(const std::vector<std::string>& options, const fs::path& script)
{
  std::vector<std::string> arguments = {"--parsable"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.push_back(script.string());
  const auto answer = ask("sbatch", arguments);
  return answer ? study::readJobNumber(*answer) : answer;
}

Result<study::SlurmLimits> askLimits()
{
  const auto answer = ask("scontrol", {"show", "config"});
  if (!answer) return answer.error();
  return study::readLimits(*answer);
}

/// Why a job could not be submitted, and what became of those before it.
Error after(const std::vector<std::string>& jobs, const Error& error)
{
  if (jobs.empty()) return error;
  std::string numbers;
  for (const std::string& job : jobs) numbers += " " + job;
  return Error{error.message + " Submitted before and not withdrawn: job" + numbers +
               ". When they have ended, submit again or use `study merge`; `scancel" + numbers +
               "` withdraws them."};
}

}  // namespace

Result<void> submitStudy(const StudyOptions& options)
{
  const auto study = readStudy(options);
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
  auto limits = askLimits();
  // The scripts can be read on a machine without Slurm.
  if (!limits && options.isDryRun) limits = study::SlurmLimits{};
  if (!limits) return limits.error();
  const auto jobs = study::slurmJobs(request, *limits);
  if (!jobs) return jobs.error();
  if (options.isDryRun) {
    for (const study::SlurmScript& script : jobs->arrays) printText(script.text + "\n");
    printText(jobs->merge.text);
    return {};
  }

  if (const auto done = checkStudyFolder(request.folder.string()); !done) return done;
  std::vector<std::string> foreign;
  for (const study::SlurmScript& script : jobs->arrays)
    if (!study::isSlurmScript(request.folder / script.name)) foreign.push_back(script.name);
  if (!study::isSlurmScript(request.folder / jobs->merge.name)) foreign.push_back(jobs->merge.name);
  if (const auto done = checkReplaced(request.folder, foreign, false); !done) return done;
  fs::create_directories(request.folder, problem);
  if (problem)
    return Error{request.folder.string() + " cannot be created: " + problem.message() +
                 ". Give another folder."};
  for (const study::SlurmScript& script : jobs->arrays)
    if (const auto done = writeWhole(request.folder / script.name, script.text, {Links::refused});
        !done)
      return done;
  if (const auto done =
          writeWhole(request.folder / jobs->merge.name, jobs->merge.text, {Links::refused});
      !done)
    return done;
  std::vector<std::string> submitted;
  std::string dependency = "--dependency=afterok";
  for (const study::SlurmScript& script : jobs->arrays) {
    const auto array = submit({}, request.folder / script.name);
    if (!array) return after(submitted, array.error());
    submitted.push_back(*array);
    dependency += ":" + *array;
  }
  const auto merge = submit({dependency}, request.folder / jobs->merge.name);
  if (!merge) return after(submitted, merge.error());
  if (submitted.size() == 1)
    print("job {}: {} parts of {} insertions\n", submitted[0], options.shards, study->size());
  else
    print("jobs {} to {}: {} parts of {} insertions, {} arrays for MaxArraySize={}\n",
          submitted.front(), submitted.back(), options.shards, study->size(), submitted.size(),
          limits->maxArraySize);
  print("job {}: merge, after {}\n", *merge, submitted.size() == 1 ? "it" : "them");
  return {};
}

}  // namespace perilymph::cli

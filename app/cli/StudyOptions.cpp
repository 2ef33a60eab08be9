// SPDX-License-Identifier: BSD-3-Clause
#include "StudyOptions.h"

#include <CLI/CLI.hpp>

#include "Commands.h"
#include "FileOptions.h"
#include "NumberOptions.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::cli {

namespace {

constexpr std::size_t maxShards = 1'000'000;

void addFile(CLI::App& command, FileOptions& files, StudyOptions& options)
{
  files.reads(command.add_option("study", options.file, "Study (.toml)")->required());
}

void addFolder(CLI::App& command, FileOptions& files, StudyOptions& options,
               const std::vector<std::string>& names)
{
  files.writesInto(
      command.add_option("--out", options.folder, "Output folder; continues what is there")
          ->required(),
      names);
}

void addShard(CLI::App& study, FileOptions& files, StudyOptions& options)
{
  CLI::App& command = *study.add_subcommand("shard", "Run one part of a study");
  addFile(command, files, options);
  command.add_option("--index", options.index, "Number of the part, from 1")
      ->required()
      ->check(wholeNumber(1, maxShards));
  command.add_option("--of", options.shards, "Number of parts")
      ->required()
      ->check(wholeNumber(1, maxShards));
  addFolder(command, files, options, {});
  addJobs(command, options.jobs);
}

void addSubmit(CLI::App& study, FileOptions& files, StudyOptions& options)
{
  CLI::App& command =
      *study.add_subcommand("submit", "Run the parts of a study and their merge under Slurm");
  addFile(command, files, options);
  addFolder(command, files, options, {"shards.sh", "merge.sh"});
  command.add_option("--shards", options.shards, "Number of parts, one task each")
      ->required()
      ->check(wholeNumber(1, maxShards));
  command.add_option("--partition", options.partition, "Slurm partition (default: Slurm's)");
  command.add_option("--time", options.time, "Time limit of a task, such as 02:00:00");
  command
      .add_option("--sbatch-option", options.sbatchOptions,
                  "Further option of sbatch, such as --sbatch-option=--mem=2G; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--dry-run", options.isDryRun, "Print the batch scripts only");
}

}  // namespace

void addStudy(CLI::App& app, FileOptions& files, StudyOptions& options)
{
  CLI::App& study =
      *app.add_subcommand("study", "Run many insertions: arrays, cochleae and techniques");
  study.require_subcommand(1);
  addFile(*study.add_subcommand("check", "Check a study; print its size and duration"), files,
          options);
  CLI::App& run = *study.add_subcommand("run", "Run a study and write its results");
  addFile(run, files, options);
  addFolder(run, files, options, {study::mergedFile, study::mergedTable});
  addJobs(run, options.jobs);
  addShard(study, files, options);
  CLI::App& merge = *study.add_subcommand("merge", "Merge the parts of a study in a folder");
  files.writesInto(merge.add_option("folder", options.folder, "Folder of the parts")->required(),
                   {study::mergedFile, study::mergedTable});
  CLI::App& status = *study.add_subcommand("status", "List the parts of a study in a folder");
  status.add_option("folder", options.folder, "Folder of the parts")->required();
  CLI::App& report = *study.add_subcommand("report", "Report on a merged study in its folder");
  std::vector<std::string> names = {"report.md"};
  for (const char* figure : {"angle", "peak-force"})
    for (const std::string& name : figureNames(figure)) names.push_back(name);
  names.insert(names.end(), study::summaryTables.begin(), study::summaryTables.end());
  files.writesInto(report.add_option("folder", options.folder, "Folder of the study")->required(),
                   names);
  report.add_option("--group", options.group,
                    "Also write tables of the groups of this setting, such as array");
  addSubmit(study, files, options);
}

Result<void> runStudy(const CLI::App& study, const CommandFiles& files, const StudyOptions& options)
{
  if (study.got_subcommand("check")) return checkStudy(options);
  if (study.got_subcommand("run")) return runWholeStudy(options);
  if (study.got_subcommand("shard")) return runStudyShard(options);
  if (study.got_subcommand("merge")) return mergeStudy(options);
  if (study.got_subcommand("report")) return reportStudy(options, files);
  if (study.got_subcommand("status")) return showStudyStatus(options);
  return submitStudy(options);
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Batch scripts that run a study's shards and their merge under Slurm, and what Slurm answers.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::study {

/// What the jobs of a study need.
struct SlurmRequest {
  std::filesystem::path program;  ///< perilymph-cli, as it is found on the nodes.
  std::filesystem::path study;    ///< The study's file, absolute.
  std::filesystem::path folder;   ///< Folder of the shards, absolute, the same on all nodes.
  std::size_t shards = 1;
  std::string partition;             ///< Slurm's default if empty.
  std::string time;                  ///< Limit of a task, as Slurm writes it; default if empty.
  std::vector<std::string> options;  ///< Further options of sbatch, such as "--mem=2G".
};

/// Limits of a Slurm installation; the values here are Slurm's defaults (slurm.conf(5)).
struct SlurmLimits {
  std::size_t maxArraySize = 1001;  ///< The greatest number of an array's task is one less.
  std::size_t maxJobCount = 10000;  ///< Jobs at a time; each task of an array is one.
};

/// A script for the folder of the shards.
struct SlurmScript {
  std::string name, text;
};

/// The jobs of a study: arrays whose tasks each run one shard, and their merge. A task that was
/// killed or requeued continues where it ended.
struct SlurmJobs {
  std::vector<SlurmScript> arrays;
  SlurmScript merge;
};

/// Writes the scripts, as many arrays as the limits need. Refuses what a script cannot hold as it
/// is: control characters anywhere, a backslash in the folder's name, anything but a name in the
/// partition and the time; and more jobs than Slurm keeps.
Result<SlurmJobs> slurmJobs(const SlurmRequest& request, const SlurmLimits& limits);

/// Whether a file is a script that slurmJobs() wrote.
bool isSlurmScript(const std::filesystem::path& file);

/// Limits in the answer of `scontrol show config`.
Result<SlurmLimits> readLimits(const std::string& answer);

/// Number of the job in the answer of `sbatch --parsable`: "1234", or "1234;cluster".
Result<std::string> readJobNumber(const std::string& answer);

}  // namespace perilymph::study

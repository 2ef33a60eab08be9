// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Batch scripts that run a study's shards and their merge under Slurm.

#include <filesystem>
#include <string>
#include <vector>

namespace perilymph::study {

/// What a job array for a study needs.
struct SlurmRequest {
  std::filesystem::path program;  ///< perilymph-cli, as it is found on the nodes.
  std::filesystem::path study;    ///< The study's file, absolute.
  std::filesystem::path folder;   ///< Folder of the shards, absolute, the same on all nodes.
  std::size_t shards = 1;
  std::string partition;             ///< Slurm's default if empty.
  std::string time;                  ///< Limit of a task, as Slurm writes it; default if empty.
  std::vector<std::string> options;  ///< Further options of sbatch, such as "--mem=2G".
};

/// A script whose task i runs shard i. A task that was killed or requeued goes on where it ended.
std::string shardScript(const SlurmRequest& request);
/// A script that merges the shards.
std::string mergeScript(const SlurmRequest& request);

/// A word of a shell command, in single quotation marks.
std::string shellQuoted(const std::string& word);

}  // namespace perilymph::study

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/SlurmScript.h"

namespace perilymph::study {

namespace {

/// The lines that both scripts begin with.
std::string head(const SlurmRequest& request, const std::string& name, const std::string& log)
{
  std::string text = "#!/bin/sh\n#SBATCH --job-name=" + name + "\n#SBATCH --ntasks=1\n" +
                     "#SBATCH --cpus-per-task=1\n#SBATCH --requeue\n#SBATCH --open-mode=append\n";
  // Slurm reads the rest of the line; spaces need quotation marks.
  text += "#SBATCH --output=\"" + (request.folder / log).string() + "\"\n";
  if (!request.partition.empty()) text += "#SBATCH --partition=" + request.partition + "\n";
  if (!request.time.empty()) text += "#SBATCH --time=" + request.time + "\n";
  for (const std::string& option : request.options) text += "#SBATCH " + option + "\n";
  return text;
}

}  // namespace

std::string shellQuoted(const std::string& word)
{
  std::string quoted = "'";
  for (const char letter : word)
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string shardScript(const SlurmRequest& request)
{
  const std::string count = std::to_string(request.shards);
  return head(request, "perilymph-study", "shard-%a.log") + "#SBATCH --array=1-" + count +
         "\nexec " + shellQuoted(request.program.string()) + " study shard " +
         shellQuoted(request.study.string()) + " --index \"$SLURM_ARRAY_TASK_ID\" --of " + count +
         " --jobs 1 --out " + shellQuoted(request.folder.string()) + "\n";
}

std::string mergeScript(const SlurmRequest& request)
{
  return head(request, "perilymph-merge", "merge.log") + "exec " +
         shellQuoted(request.program.string()) + " study merge " +
         shellQuoted(request.folder.string()) + "\n";
}

}  // namespace perilymph::study

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/SlurmScript.h"

#include <algorithm>
#include <charconv>
#include <regex>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Program.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::study {

namespace {

/// What every script begins with, before the rest of its name.
const std::string firstLines = "#!/bin/sh\n#SBATCH --job-name=perilymph-";

/// A word of a shell command, in single quotation marks.
std::string shellQuoted(const std::string& word)
{
  std::string quoted = "'";
  for (const char letter : word)
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// The name of a log in the folder, as an option in a script. Slurm replaces %a by the number of the
/// task and %% by a percent sign, and a backslash quotes the next character of the option.
std::string logOption(const SlurmRequest& request, const std::string& log)
{
  std::string option = "#SBATCH --output=\"";
  for (const char letter : (request.folder / "").string()) {
    if (letter == '%') option += '%';
    if (letter == '"') option += '\\';
    option += letter;
  }
  return option + log + "\"\n";
}

/// The lines that all scripts begin with.
std::string head(const SlurmRequest& request, const std::string& name, const std::string& log)
{
  std::string text = firstLines + name + "\n#SBATCH --ntasks=1\n" +
                     "#SBATCH --cpus-per-task=1\n#SBATCH --requeue\n#SBATCH --open-mode=append\n" +
                     logOption(request, log);
  if (!request.partition.empty()) text += "#SBATCH --partition=" + request.partition + "\n";
  if (!request.time.empty()) text += "#SBATCH --time=" + request.time + "\n";
  for (const std::string& option : request.options) text += "#SBATCH " + option + "\n";
  return text;
}

/// The array whose task i runs shard `before` + i.
std::string arrayScript(const SlurmRequest& request, std::size_t before, std::size_t tasks)
{
  const std::string offset = std::to_string(before);
  const std::string log = before == 0 ? "shard-%a.log" : "shard-" + offset + "+%a.log";
  return head(request, "study", log) + "#SBATCH --array=1-" + std::to_string(tasks) + "\nexec " +
         shellQuoted(request.program.string()) + " study shard " +
         shellQuoted(request.study.string()) + " --index \"$((SLURM_ARRAY_TASK_ID + " + offset +
         "))\" --of " + std::to_string(request.shards) + " --jobs 1 --out " +
         shellQuoted(request.folder.string()) + "\n";
}

Result<void> checkRequest(const SlurmRequest& request)
{
  std::vector<std::pair<std::string, std::string>> texts = {
      {"The path of the program", request.program.string()},
      {"The path of the study", request.study.string()},
      {"--out", request.folder.string()},
      {"--partition", request.partition},
      {"--time", request.time}};
  for (const std::string& option : request.options) texts.emplace_back("--sbatch-option", option);
  for (const auto& [name, text] : texts)
    if (onOneLine(text) != text)
      return Error{
          "%1 is \"%2\", with a line break, another control character or a byte that is not UTF-8, "
          "which a batch script cannot hold. Rename it.",
          name, onOneLine(text)};
  if (request.folder.string().find('\\') != std::string::npos)
    return Error{
        "--out is \"%1\", whose backslash Slurm does not take in the name of a log. Rename the "
        "folder.",
        request.folder};
  static const std::regex names("[A-Za-z0-9_.,+-]*"), times("[0-9:-]*|UNLIMITED|INFINITE");
  if (!std::regex_match(request.partition, names))
    return Error{
        "--partition is \"%1\"; it has letters, digits and _ . , + - only. sinfo lists partitions.",
        request.partition};
  if (!std::regex_match(request.time, times))
    return Error{
        "--time is \"%1\"; Slurm writes it as 30 (minutes), 02:00:00 or 1-12:00:00. Correct it.",
        request.time};
  for (const std::string& option : request.options)
    if (option.empty() || option.front() != '-')
      return Error{
          "--sbatch-option is \"%1\"; it begins with a hyphen, such as --sbatch-option=--mem=2G.",
          option};
  return {};
}

Result<void> checkLimits(const SlurmRequest& request, const SlurmLimits& limits)
{
  if (limits.maxArraySize < 2)
    return Error{
        "This Slurm takes no job arrays (MaxArraySize=%1). Ask its administrator, or run the parts "
        "by `study shard`.",
        limits.maxArraySize};
  if (request.shards + 1 > limits.maxJobCount)
    return Error{
        "--shards is %1, which with the merge are more jobs than this Slurm keeps at a time "
        "(MaxJobCount=%2). Give fewer parts.",
        request.shards, limits.maxJobCount};
  return {};
}

}  // namespace

Result<SlurmJobs> slurmJobs(const SlurmRequest& request, const SlurmLimits& limits)
{
  if (const auto possible = checkRequest(request); !possible) return possible.error();
  if (const auto possible = checkLimits(request, limits); !possible) return possible.error();
  SlurmJobs jobs;
  for (std::size_t before = 0; before < request.shards; before += limits.maxArraySize - 1) {
    const std::size_t tasks = std::min(request.shards - before, limits.maxArraySize - 1);
    const std::string number = before == 0 ? "" : "-" + std::to_string(jobs.arrays.size() + 1);
    jobs.arrays.push_back({"shards" + number + ".sh", arrayScript(request, before, tasks)});
  }
  jobs.merge = {"merge.sh", head(request, "merge", "merge.log") + "exec " +
                                shellQuoted(request.program.string()) + " study merge " +
                                shellQuoted(request.folder.string()) + "\n"};
  return jobs;
}

bool isSlurmScript(const std::filesystem::path& file)
{
  const auto text = readWhole(file);
  return text && text->starts_with(firstLines);
}

Result<SlurmLimits> readLimits(const std::string& answer)
{
  const auto value = [&answer](const std::string& name, std::size_t& number) {
    // "MaxArraySize            = 1001"
    const std::regex line("(?:^|\n)" + name + " *= *([0-9]{1,9}) *(?:\n|$)");
    std::smatch found;
    if (!std::regex_search(answer, found, line)) return false;
    const std::string digits = found[1];
    return std::from_chars(digits.data(), digits.data() + digits.size(), number).ec == std::errc();
  };
  SlurmLimits limits;
  for (const auto& [name, number] : {std::pair("MaxArraySize", &limits.maxArraySize),
                                     std::pair("MaxJobCount", &limits.maxJobCount)})
    if (!value(name, *number))
      return Error{
          "`scontrol show config` names no %1, so that the parts cannot be dealt out. Is it "
          "Slurm's? --dry-run prints the scripts.",
          std::string(name)};
  return limits;
}

Result<std::string> readJobNumber(const std::string& answer)
{
  static const std::regex form("([0-9]{1,10})(;[A-Za-z0-9_-]+)?\n?");
  std::smatch found;
  if (answer.size() < 256 && std::regex_match(answer, found, form)) return found[1].str();
  return Error{
      "sbatch answered \"%1\", which is no number of a job. `squeue --me` lists whether it made "
      "one.",
      linesTogether(answer.substr(0, 256))};
}

}  // namespace perilymph::study

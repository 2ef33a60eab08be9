// SPDX-License-Identifier: BSD-3-Clause
#include "PredictOptions.h"

#include <CLI/CLI.hpp>

#include "Commands.h"
#include "FileOptions.h"
#include "NumberOptions.h"

namespace perilymph::cli {

void addPredict(CLI::App& app, FileOptions& files, PredictOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("predict", "Simulate arrays in anatomies not used for calibration");
  CLI::Option* arrays = command.add_option("--array", options.arrays,
                                           "Electrode arrays: shipped names or TOML files");
  files.reads(arrays, "plugins/electrodes");
  CLI::Option* all = command.add_flag(
      "--all", options.isAll,
      "Clinical table: arrays with published depths, by hand, with hits and misses");
  arrays->excludes(all);
  files.reads(command
                  .add_option("--friction", options.friction,
                              "Friction of the clinical table: shipped name or TOML file")
                  ->capture_default_str()
                  ->needs(all),
              "resources/friction");
  command
      .add_option("--patients", options.patients,
                  "Number of virtual patients in addition to the average cochlea; with --all for "
                  "each seed")
      ->default_str("50, with --all 12")
      ->check(wholeNumber(0, 10'000));
  addSeeds(command, options.seeds, "Random seed of the virtual patients; with --all one or more");
  addJobs(command, options.jobs);
  files.writesInto(command.add_option("--out", options.out, "Output folder for tables")->required(),
                   {"prediction.csv", "prediction.json", "clinical-table.csv",
                    "clinical-insertions.csv", "clinical-table.json"});
  command.parse_complete_callback([&options] {
    if (options.arrays.empty() && !options.isAll) throw CLI::RequiredError("--array or --all");
    if (!options.isAll && options.seeds.size() > 1)
      throw CLI::ValidationError("--seed", "takes one value with --array");
  });
}

}  // namespace perilymph::cli

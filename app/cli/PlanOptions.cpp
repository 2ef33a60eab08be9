// SPDX-License-Identifier: BSD-3-Clause
#include "PlanOptions.h"

#include <CLI/CLI.hpp>

#include "Commands.h"
#include "FileOptions.h"
#include "NumberOptions.h"
#include "perilymph/planning/PlanFolder.h"

namespace perilymph::cli {

std::vector<std::string> planFiles()
{
  std::vector<std::string> names = {planning::planPatientFile,
                                    planning::planRequestFile,
                                    planning::planJsonFile,
                                    "arrays.csv",
                                    "contacts.csv",
                                    "contacts-dictionary.csv",
                                    "differences.csv",
                                    "shapes.csv"};
  const auto add = [&names](const std::string& figure) {
    for (const std::string& name : figureNames(figure)) names.push_back(name);
  };
  add("angle");
  for (std::size_t i = 1; i <= maxPlanArrays; ++i) {
    add("force-" + std::to_string(i));
    add("influence-" + std::to_string(i));
  }
  return names;
}

void addPlan(CLI::App& app, FileOptions& files, PlanOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("plan", "Compare arrays in a patient's cochlea, with bands");
  files.reads(
      command
          .add_option("--patient", options.patient,
                      "Patient with A and B: shipped name or TOML file, as 'ct measure' writes it")
          ->required(),
      "resources/patients");
  files.reads(
      command
          .add_option("--arrays", options.arrays,
                      "Electrode arrays: shipped names or TOML files; 'all': the shipped ones")
          ->default_str("all"),
      "plugins/electrodes");
  files.reads(
      command
          .add_option("--friction", options.friction,
                      "Friction: shipped name or TOML file; 'tissue' was measured on a simulant, "
                      "'endosteum' is recalled")
          ->default_str("estimate-from-pig-tissue"),
      "resources/friction");
  files.reads(command.add_option("--clinic-resistance", options.clinicResistance,
                                 "Also give depths with the resistance of a clinic, a file of "
                                 "'outcomes --resistance' (JSON)"));
  command
      .add_option("--samples", options.samples,
                  "Simulations of each array at most, 16 to 4096: draws of measures, shape, "
                  "hand, friction, approach, stiffness and wires; fewer if the bands stand after "
                  "64, 128, ...")
      ->default_str(std::to_string(planning::usualDraws(false)) + "; with --clinic-resistance " +
                    std::to_string(planning::usualDraws(true)))
      ->check(wholeNumber(0, 1'000'000));
  command.add_flag("--all-samples", options.runsAll, "Run all simulations");
  addSeed(command, options.seed, "Random seed of the draws");
  addJobs(command, options.jobs);
  files.writesInto(command
                       .add_option("--out", options.out,
                                   "Output folder; the same command continues what is there")
                       ->required(),
                   planFiles());
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause

// The options of all commands, and which of them name files.

#include "CommandOptions.h"

#include <CLI/CLI.hpp>

#include "CtOptions.h"
#include "EmptyValues.h"
#include "FileOptions.h"
#include "perilymph/anatomy/AnatomySource.h"

namespace perilymph::cli {

namespace {

constexpr const char* scenarioFolder = "resources/scenarios";
constexpr const char* patientsFolder = "resources/patients";
constexpr const char* arrayFolder = "plugins/electrodes";
constexpr const char* variabilityFolder = "resources/validation";

/// Names of tables and of the files of figures.
std::vector<std::string> withFigures(std::vector<std::string> names,
                                     const std::vector<std::string>& figures)
{
  for (const std::string& figure : figures)
    for (const std::string& name : figureNames(figure)) names.push_back(name);
  return names;
}

/// An option that sets the corresponding key of a scenario.
CLI::Option* overrideOption(CLI::App& command, const std::string& option, const std::string& key,
                            session::Overrides& overrides, const std::string& help)
{
  return command.add_option_function<std::string>(
      option, [&overrides, key](const std::string& value) { overrides.emplace_back(key, value); },
      help);
}

void setOption(CLI::App& command, FileOptions& files, session::Overrides& overrides)
{
  CLI::Option* set =
      command
          .add_option_function<std::vector<std::string>>(
              "--set",
              [&overrides](const std::vector<std::string>& settings) {
                for (const std::string& setting : settings) {
                  const std::size_t equals = setting.find('=');
                  if (equals == std::string::npos || equals == 0)
                    throw CLI::ValidationError("--set", "'" + setting + "' is not key=value");
                  overrides.emplace_back(setting.substr(0, equals),
                                         settingValue("--set", setting, equals));
                }
              },
              "Changes a scenario's key: --set speed_mm_s=1.0; may be repeated")
          ->take_all()
          ->allow_extra_args(false);
  files.readsSettings(set);
}

void addSimulate(CLI::App& app, FileOptions& files, SimulateOptions& options)
{
  CLI::App& command = *app.add_subcommand("simulate", "Runs an insertion in virtual time");
  files.reads(
      command.add_option("--scenario", options.scenario, "A scenario's file or shipped name")
          ->required(),
      scenarioFolder);
  files.reads(overrideOption(command, "--patient", "patient", options.overrides,
                             "A patient's file or shipped name"),
              patientsFolder);
  files.reads(overrideOption(command, "--array", "array", options.overrides, "An electrode array"),
              arrayFolder);
  overrideOption(command, "--model", "model", options.overrides, "rod or points");
  overrideOption(command, "--nodes", "nodes", options.overrides,
                 "Nodes of the rod, or sample points");
  overrideOption(command, "--seed", "seed", options.overrides, "Seed of random numbers");
  setOption(command, files, options.overrides);
  CLI::Option* csv = command.add_option("--csv", options.csv, "Writes one row per tick");
  command.add_option("--every-ms", options.every_ms, "Interval of rows in the CSV file")
      ->check(CLI::Range(0.0, 1e6))
      ->needs(csv);
  files.writes(csv);
  files.writes(command.add_option("--json", options.json, "Writes scenario and results"));
  files.records(
      command.add_option("--record", options.record, "Records the session in an .insertion file"));
}

/// The option that selects an anatomy without a patient.
CLI::Option* addPreset(CLI::App& command, std::string& preset)
{
  const std::vector<std::string> names = anatomy::anatomySourceNames();
  std::string listed;
  for (std::size_t i = 0; i < names.size(); ++i)
    listed += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return command.add_option("--preset", preset, listed)->check(CLI::IsMember(names));
}

void addAnatomy(CLI::App& app, FileOptions& files, AnatomyOptions& options)
{
  CLI::App& command = *app.add_subcommand("anatomy", "Measures a cochlea and writes its surface");
  CLI::Option_group& source = *command.add_option_group("anatomy");
  addPreset(source, options.preset);
  files.reads(source.add_option("--patient", options.patient, "A patient's file or shipped name"),
              patientsFolder);
  CLI::Option* length =
      source.add_option("--st-length-mm", options.stLength_mm, "Length of the organ-of-Corti path");
  CLI::Option* a =
      source.add_option("--a-mm", options.a_mm, "A: through round window and modiolus");
  files.reads(
      source.add_option("--import", options.import, "A segmented surface in mm: .stl .ply .vtp"));
  source.add_option("--sample", options.sample, "A virtual patient, drawn with this seed");
  source.require_option(1);

  CLI::Option* width = command.add_option("--rw-width-mm", options.rwWidth_mm,
                                          "Width of the section at the round window");
  CLI::Option* height =
      command.add_option("--rw-height-mm", options.rwHeight_mm, "Height of the same section");
  length->needs(width)->needs(height);
  width->needs(length);
  height->needs(length);
  CLI::Option* b = command.add_option("--b-mm", options.b_mm, "B: across A through the modiolus");
  a->needs(b);
  b->needs(a);
  command.add_option("--h-mm", options.h_mm, "H: along the modiolus, base to apex")->needs(a);
  files.writes(
      command.add_option("--json", options.json, "Writes the measures, formulas and sources"));
  files.writes(command.add_option("--sections", options.sections, "Writes the sections as CSV"));
  CLI::Option* surface = command.add_option("--surface", options.surface,
                                            "Writes the surface: .stl .vtp .ply .obj .wrl");
  files.writes(surface);
  files.writes(command.add_option("--haptic-surface", options.hapticSurface,
                                  "Writes the haptic surface: no apex, 95 % fewer triangles"));
  command.add_option("--part", options.part, "scala, membrane or vestibuli")
      ->check(CLI::IsMember({"scala", "membrane", "vestibuli"}))
      ->needs(surface);
}

void addReplay(CLI::App& app, FileOptions& files, ReplayOptions& options)
{
  CLI::App& command = *app.add_subcommand("replay", "Reads a recorded session");
  files.reads(command.add_option("file", options.file, "The .insertion file")->required());
  command.add_flag("--verify", options.verifies, "Replays it and compares every bit");
  files.writes(command.add_option("--csv", options.csv, "Writes one row per tick"));
}

void addValidate(CLI::App& app, FileOptions& files, ValidateOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("validate", "Repeats the published experiment, with its statistics");
  command.add_option("--runs", options.runs, "Insertions")->check(CLI::Range(2, 100'000));
  command.add_option("--seed", options.seed, "Seed of everything that varies between insertions")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Parallel insertions; by default one per processor")
      ->check(CLI::Range(1u, 256u));
  overrideOption(command, "--model", "model", options.overrides, "rod or points");
  setOption(command, files, options.overrides);
  files.reads(command.add_option("--variability", options.variability,
                                 "Variability: a file or a shipped name"),
              variabilityFolder);
  files.writesInto(
      command.add_option("--out", options.out, "The folder for tables and figures")->required(),
      withFigures({"profile.csv", "difference.csv", "summary.json"},
                  {"experiment", "simulation", "difference"}));
}

void addCalibrate(CLI::App& app, FileOptions& files, CalibrateOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("calibrate", "Fits two parameters of the array to two printed forces");
  command.add_option("--runs", options.runs, "Insertions per trial")->check(CLI::Range(2, 10'000));
  command.add_option("--seed", options.seed, "Seed of everything that varies between insertions")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Parallel insertions; by default one per processor")
      ->check(CLI::Range(1u, 256u));
  setOption(command, files, options.overrides);
  files.reads(command.add_option("--variability", options.variability,
                                 "Variability: a file or a shipped name"),
              variabilityFolder);
  files.writesInto(
      command.add_option("--out", options.out, "The folder for the calibration")->required(),
      withFigures({"calibration.toml", "profile.csv", "difference.csv"}, {"calibration"}));
}

void addPredict(CLI::App& app, FileOptions& files, PredictOptions& options)
{
  CLI::App& command = *app.add_subcommand("predict", "Predicts insertions without fitting");
  files.reads(command.add_option("--array", options.arrays, "Electrode arrays, by name or file")
                  ->required(),
              arrayFolder);
  command.add_option("--patients", options.patients, "Virtual patients beside the mean cochlea")
      ->check(CLI::Range(0, 10'000));
  command.add_option("--seed", options.seed, "Seed of the virtual patients")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Parallel cochleae; by default one per processor")
      ->check(CLI::Range(1u, 256u));
  files.writesInto(
      command.add_option("--out", options.out, "The folder for the tables")->required(),
      {"prediction.csv", "prediction.json"});
}

void addCompare(CLI::App& app, FileOptions& files, CompareOptions& options)
{
  CLI::App& command = *app.add_subcommand("compare", "Compares recorded insertions");
  files.reads(command.add_option("files", options.files, "The .insertion files")->required());
  files.writesInto(
      command.add_option("--out", options.out, "The folder for tables and curves")->required(),
      withFigures({"comparison.csv", "curves.csv"}, {"curves"}));
}

void addRender(CLI::App& app, FileOptions& files, RenderOptions& options)
{
  CLI::App& command = *app.add_subcommand("render", "Draws a picture without a window");
  CLI::Option* scenario =
      command.add_option("--scenario", options.scenario, "A scenario's file or shipped name");
  CLI::Option* patient =
      command.add_option("--patient", options.patient, "A patient's file or shipped name");
  CLI::Option* preset = addPreset(command, options.preset);
  preset->excludes(scenario)->excludes(patient);
  files.reads(scenario, scenarioFolder);
  files.reads(patient, patientsFolder);
  files.reads(command.add_option("--array", options.array, "An electrode array")->needs(scenario),
              arrayFolder);
  command.add_option("--at-mm", options.at_mm, "Travel of the array in the picture")
      ->needs(scenario);
  command.add_option("--view", options.view, "surgeon, microscope, overview, section or unrolled")
      ->check(CLI::IsMember({"surgeon", "microscope", "overview", "section", "unrolled"}));
  files.writes(command.add_option("--out", options.out, "The picture, .png")->required());
  command.callback([&options] {
    if (options.scenario.empty() && options.patient.empty() && options.preset.empty())
      throw CLI::RequiredError("--scenario, --patient or --preset");
  });
}

void addDevices(CLI::App& app, FileOptions& files, DevicesOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("devices", "Lists HID devices and their usability, and tests one");
  files.writes(
      command.add_option("--json", options.json, "Writes the list and the test's results"));
  CLI::Option* test =
      command
          .add_option(
              "--test", options.test,
              "Measures reports, then renders small forces: number of the node, 3 for hidraw3")
          ->check(CLI::Range(0, 4095));
  files.writes(command
                   .add_option("--capture", options.capture,
                               "Records every report of the test with its time")
                   ->needs(test));
  files.reads(
      command
          .add_option("--replay", options.replay,
                      "Evaluates a captured file, also of hid-recorder, instead of a device")
          ->excludes(test));
  files.reads(command
                  .add_option("--plugin", options.plugin,
                              "Loads a device plug-in (FILE.so) and tests it like --test; it runs "
                              "with your rights")
                  ->excludes(test)
                  ->excludes("--replay"));
}

}  // namespace

void addCommands(CLI::App& app, FileOptions& files, CommandOptions& options)
{
  addSimulate(app, files, options.simulate);
  addAnatomy(app, files, options.anatomy);
  addReplay(app, files, options.replay);
  addRender(app, files, options.render);
  addValidate(app, files, options.validate);
  addCalibrate(app, files, options.calibrate);
  addPredict(app, files, options.predict);
  addCompare(app, files, options.compare);
  addDevices(app, files, options.devices);
  addCt(app, files, options);
  refuseEmptyValues(app);
}

Result<Done> runCommand(const CLI::App& app, const CallFiles& files, const CommandOptions& options)
{
  if (app.got_subcommand("simulate")) return simulate(options.simulate, files);
  if (app.got_subcommand("anatomy")) return describeAnatomy(options.anatomy);
  if (app.got_subcommand("replay")) return replay(options.replay);
  if (app.got_subcommand("validate")) return validate(options.validate, files);
  if (app.got_subcommand("calibrate")) return calibrate(options.calibrate, files);
  if (app.got_subcommand("predict")) return predict(options.predict, files);
  if (app.got_subcommand("compare")) return compare(options.compare, files);
  if (app.got_subcommand("devices")) return devices(options.devices);
  if (app.got_subcommand("ct"))
    return app.get_subcommand("ct")->got_subcommand("info") ? ctInfo(options.ctInfo)
                                                            : ctMeasure(options.ctMeasure);
  return render(options.render, files);
}

}  // namespace perilymph::cli

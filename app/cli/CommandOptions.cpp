// SPDX-License-Identifier: BSD-3-Clause

// The options of all commands, and which of them name files.

#include "CommandOptions.h"

#include <sys/stat.h>

#include <CLI/CLI.hpp>

#include "ArchiveOptions.h"
#include "CtOptions.h"
#include "EmptyValues.h"
#include "FileOptions.h"
#include "NumberOptions.h"
#include "PlanOptions.h"
#include "PredictOptions.h"
#include "StudyOptions.h"
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
                                         options::settingValue("--set", setting, equals));
                }
              },
              "Override scenario keys, e.g. --set speed_mm_s=1.0 nodes=40; repeatable")
          ->type_name("KEY=VALUE")
          ->take_all();
  files.readsSettings(set);
}

void addSimulate(CLI::App& app, FileOptions& files, SimulateOptions& options)
{
  CLI::App& command = *app.add_subcommand(
      "simulate",
      "Simulate an insertion. It ends as finished, stopped_by_resistance (at stop_force_N), "
      "buckled, "
      "out_of_opening, folded_tip or jammed; exit status 1 if the tip never enters");
  files.reads(
      command.add_option("--scenario", options.scenario, "Scenario: shipped name or TOML file")
          ->required(),
      scenarioFolder);
  files.reads(overrideOption(command, "--patient", "patient", options.overrides,
                             "Patient: shipped name or TOML file"),
              patientsFolder);
  files.reads(overrideOption(command, "--array", "array", options.overrides,
                             "Electrode array: shipped name or TOML file"),
              arrayFolder);
  overrideOption(command, "--model", "model", options.overrides,
                 "Array model: rod (elastic rod) or points (published point set); default: as in "
                 "the scenario");
  overrideOption(command, "--nodes", "nodes", options.overrides,
                 "Number of rod nodes or sample points (default: as in the scenario)");
  overrideOption(command, "--seed", "seed", options.overrides,
                 "Random seed (default: as in the scenario)");
  setOption(command, files, options.overrides);
  CLI::Option* csv = command.add_option("--csv", options.csv, "Write time series (CSV)");
  command
      .add_option("--every-ms", options.every_ms,
                  "Sampling interval of the CSV file (ms); 0: every sample (1 ms)")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6))
      ->needs(csv);
  files.writes(csv);
  files.writes(command.add_option("--json", options.json, "Write scenario and results (JSON)"));
  files.records(
      command.add_option("--record", options.record, "Record the insertion (.insertion)"));
  command
      .add_option("--igtl", options.igtl,
                  "Run in real time and send the insertion to OpenIGTLink clients, by default of "
                  "this machine")
      ->type_name("[ADDRESS:]PORT");
}

/// The option that selects an anatomy without a patient.
CLI::Option* addPreset(CLI::App& command, std::string& preset)
{
  const std::vector<std::string> names = anatomy::anatomySourceNames();
  std::string listed;
  for (std::size_t i = 0; i < names.size(); ++i)
    listed += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return command.add_option("--preset", preset, "Anatomy model: " + listed)
      ->check(CLI::IsMember(names));
}

void addAnatomy(CLI::App& app, FileOptions& files, AnatomyOptions& options)
{
  CLI::App& command = *app.add_subcommand("anatomy", "Measure a cochlea and export its surface");
  CLI::Option_group& source = *command.add_option_group("anatomy");
  addPreset(source, options.preset);
  files.reads(source.add_option("--patient", options.patient, "Patient: shipped name or TOML file"),
              patientsFolder);
  CLI::Option* length = source.add_option("--st-length-mm", options.stLength_mm,
                                          "Cochlear duct length, organ of Corti (mm)");
  CLI::Option* a = source.add_option("--a-mm", options.a_mm,
                                     "A: basal-turn diameter, round window through modiolus (mm)");
  files.reads(source.add_option("--import", options.import,
                                "Segmented scala tympani surface in mm (.stl .ply .vtp)"));
  source.add_option("--sample", options.sample, "Virtual patient: random seed");
  source.require_option(1);

  CLI::Option* width = command.add_option("--rw-width-mm", options.rwWidth_mm,
                                          "Scala tympani width at the round window (mm)");
  CLI::Option* height = command.add_option("--rw-height-mm", options.rwHeight_mm,
                                           "Scala tympani height at the round window (mm)");
  length->needs(width)->needs(height);
  width->needs(length);
  height->needs(length);
  CLI::Option* b =
      command.add_option("--b-mm", options.b_mm, "B: basal-turn width, perpendicular to A (mm)");
  a->needs(b);
  b->needs(a);
  command
      .add_option("--h-mm", options.h_mm,
                  "H: cochlear height, base to apex (mm); default: estimated from A and B")
      ->needs(a);
  files.writes(command.add_option("--json", options.json,
                                  "Write measures with formulas and sources (JSON)"));
  files.writes(command.add_option("--sections", options.sections, "Write cross-sections (CSV)"));
  CLI::Option* surface = command.add_option("--surface", options.surface,
                                            "Write the surface (.stl .vtp .ply .obj .wrl)");
  files.writes(surface);
  files.writes(
      command.add_option("--haptic-surface", options.hapticSurface,
                         "Write the decimated haptic mesh (95 % fewer triangles, apex removed)"));
  command.add_option("--part", options.part, "Part of the surface: scala, membrane or vestibuli")
      ->capture_default_str()
      ->check(CLI::IsMember({"scala", "membrane", "vestibuli"}))
      ->needs(surface);
}

void addReplay(CLI::App& app, FileOptions& files, ReplayOptions& options)
{
  CLI::App& command = *app.add_subcommand("replay", "Inspect, export or verify a recording");
  files.reads(command.add_option("file", options.file, "Recording (.insertion)")->required());
  command.add_flag("--verify", options.verifies,
                   "Replay the recording and verify that every sample is identical");
  files.writes(command.add_option("--csv", options.csv, "Write time series (CSV)"));
  files.writes(command.add_option("--sqlite", options.sqlite,
                                  "Write time series as the table tick of an SQLite file"));
  files.writes(command.add_option("--contacts", options.contacts,
                                  "Write the contacts at the maximum depth: angle, frequencies, "
                                  "default filter, mismatch (CSV)"));
  CLI::Option* thumbnail = command.add_option(
      "--thumbnail", options.thumbnail,
      "Draw force over travel with peak and depth as a small square picture (PNG)");
  files.writes(thumbnail);
  command.add_option("--size", options.size_px, "Side of the thumbnail in pixels (default: 256)")
      ->check(CLI::Range(32, 1024))
      ->needs(thumbnail);
}

void addValidate(CLI::App& app, FileOptions& files, ValidateOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("validate", "Reproduce the published experiment with its statistics");
  CLI::Option* bench = command.add_option("--bench", options.bench,
                                          "Infer the friction in an ear from curves of a bench "
                                          "instead: shipped name (slim-straight) or "
                                          "folder");
  files.readsBelow(bench);
  command.add_option("--runs", options.runs, "Number of simulated insertions")
      ->capture_default_str()
      ->check(wholeNumber(2, 100'000));
  addSeed(command, options.seed, "Random seed");
  addJobs(command, options.jobs);
  overrideOption(command, "--model", "model", options.overrides,
                 "Array model: rod (elastic rod) or points (published point set); default: as in "
                 "the scenario");
  setOption(command, files, options.overrides);
  files.reads(command
                  .add_option("--variability", options.variability,
                              "Variability between insertions: shipped name or TOML file")
                  ->capture_default_str(),
              variabilityFolder);
  CLI::Option* prior = command.add_flag("--prior-predictive", options.isPriorPredictive,
                                        "Repeat the experiment with inputs drawn from their "
                                        "declared ranges, each fitted anew");
  command.add_option("--draws", options.draws, "Repetitions that are fitted")
      ->capture_default_str()
      ->check(wholeNumber(20, 10'000))
      ->needs(prior);
  for (CLI::Option* other : command.get_options()) {
    if (other != bench && other != command.get_help_ptr()) other->excludes(bench);
    const std::string name = other->get_name();
    if (name == "--runs" || name == "--model" || name == "--set" || name == "--variability")
      other->excludes(prior);
  }
  files.writesInto(
      command.add_option("--out", options.out, "Output folder for tables and figures")->required(),
      withFigures({"profile.csv", "difference.csv", "summary.json", "friction.csv", "predicted.csv",
                   "scores.csv", "prior-predictive.csv", "prior-predictive-draws.csv",
                   "prior-predictive.json"},
                  {"experiment", "simulation", "difference", "friction"}));
}

void addCalibrate(CLI::App& app, FileOptions& files, CalibrateOptions& options)
{
  CLI::App& command = *app.add_subcommand(
      "calibrate", "Calibrate the stiffness of the array against one published force");
  command.add_option("--runs", options.runs, "Number of simulated insertions per trial")
      ->capture_default_str()
      ->check(wholeNumber(2, 10'000));
  addSeed(command, options.seed, "Random seed");
  addJobs(command, options.jobs);
  setOption(command, files, options.overrides);
  files.reads(command
                  .add_option("--variability", options.variability,
                              "Variability between insertions: shipped name or TOML file")
                  ->capture_default_str(),
              variabilityFolder);
  files.writesInto(
      command.add_option("--out", options.out, "Output folder for the calibration")->required(),
      withFigures({"calibration.toml", "profile.csv", "difference.csv"}, {"calibration"}));
}

void addCompare(CLI::App& app, FileOptions& files, CompareOptions& options)
{
  CLI::App& command = *app.add_subcommand("compare", "Compare recorded insertions");
  files.reads(command.add_option("files", options.files, "Recordings (.insertion)")->required());
  files.writesInto(
      command.add_option("--out", options.out, "Output folder for tables and curves")->required(),
      withFigures({"comparison.csv", "comparison-dictionary.csv", "curves.csv", "differences.csv",
                   "events.csv", "groups.csv"},
                  {"curves"}));
  command.add_option("--over", options.over, "Axis of the curves: travel, depth or angle")
      ->check(CLI::IsMember({"travel", "depth", "angle"}));
  command
      .add_option(
          "--group", options.groups,
          "Groups insertions by array, technique, patient, friction, speed (as set) or several "
          "of them: means, standard deviations and differences")
      ->check(CLI::IsMember({"array", "technique", "patient", "friction", "speed"}));
}

void addRender(CLI::App& app, FileOptions& files, RenderOptions& options)
{
  CLI::App& command = *app.add_subcommand("render", "Render a picture without a window");
  CLI::Option* scenario =
      command.add_option("--scenario", options.scenario, "Scenario: shipped name or TOML file");
  CLI::Option* patient =
      command.add_option("--patient", options.patient, "Patient: shipped name or TOML file");
  CLI::Option* preset = addPreset(command, options.preset);
  preset->excludes(scenario)->excludes(patient);
  files.reads(scenario, scenarioFolder);
  files.reads(patient, patientsFolder);
  files.reads(
      command.add_option("--array", options.array, "Electrode array: shipped name or TOML file")
          ->needs(scenario),
      arrayFolder);
  command
      .add_option("--at-mm", options.at_mm,
                  "Travel of the array (mm); default: where the insertion stops")
      ->needs(scenario);
  command
      .add_option("--view", options.view,
                  "View: surgeon, microscope, overview, section or unrolled")
      ->capture_default_str()
      ->check(CLI::IsMember({"surgeon", "microscope", "overview", "section", "unrolled"}));
  files.writes(command.add_option("--out", options.out, "Output picture (.png)")->required());
  command.callback([&options] {
    if (options.scenario.empty() && options.patient.empty() && options.preset.empty())
      throw CLI::RequiredError("--scenario, --patient or --preset");
  });
}

/// Names of the files that `outcomes` writes.
std::vector<std::string> outcomesFiles()
{
  std::vector<std::string> names = {"outcomes.json", "outcomes.csv", "outcomes-dictionary.csv",
                                    "outcomes.md"};
  for (const char* figure : {"depths", "percentiles"})
    for (const std::string& name : figureNames(figure)) names.push_back(name);
  return names;
}

void addPatients(CLI::App& app, FileOptions& files, PatientsOptions& options)
{
  CLI::App& command = *app.add_subcommand("patients", "List the saved patients, or write a table");
  files.writes(command.add_option(
      "--registry", options.registry,
      "Write a row per ear: measures with intervals, newest plan, newest insertion (CSV)"));
  files.writes(command.add_option("--dictionary", options.dictionary,
                                  "Write what the columns of that table are (CSV)"));
}

void addOutcomes(CLI::App& app, FileOptions& files, OutcomesOptions& options)
{
  CLI::App& command = *app.add_subcommand(
      "outcomes", "Compare the implanted arrays of all patients with their plans");
  command.add_option("--library", options.library,
                     "Folder with the folders 'patients' and 'plans'; default: your own");
  files.writesInto(command.add_option("--out", options.out, "Output folder")->required(),
                   outcomesFiles());
  files.writes(command.add_option(
      "--resistance", options.resistance,
      "Write the clinic's resistance, if it is offered, for 'plan --clinic-resistance' (JSON)"));
}

void addDevices(CLI::App& app, FileOptions& files, DevicesOptions& options)
{
  CLI::App& command = *app.add_subcommand("devices", "List devices and plug-ins, or test one");
  files.writes(
      command.add_option("--json", options.json, "Write the list and the test results (JSON)"));
  CLI::Option* test = command
                          .add_option("--test", options.test,
                                      "Test a device: measure its reports, then render small "
                                      "forces (3 for hidraw3, its name or place, or an installed "
                                      "plug-in)")
                          ->type_name("DEVICE");
  files.writes(
      command
          .add_option("--capture", options.capture, "Record every report of the test with its time")
          ->needs(test));
  files.reads(
      command
          .add_option("--replay", options.replay,
                      "Replay a captured HID log (or hid-recorder file) instead of a device")
          ->excludes(test));
  files.reads(
      command
          .add_option("--profile", options.profile,
                      "Use only this device profile: a TOML file, or the name of one without .toml")
          ->excludes("--replay"));
  files.reads(
      command
          .add_option("--plugin", options.plugin,
                      "Test a device plug-in (FILE.so) like --test; it runs with your rights")
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
  addPlan(app, files, options.plan);
  addCompare(app, files, options.compare);
  addPatients(app, files, options.patients);
  addOutcomes(app, files, options.outcomes);
  addDevices(app, files, options.devices);
  addCt(app, files, options);
  addArchive(app, files, options.archive);
  addStudy(app, files, options.study);
  options::refuseEmptyValues(app);
}

Result<void> runCommand(const CLI::App& app, const CommandFiles& files,
                        const CommandOptions& options)
{
  // What these write describes a patient: it is for the owner only.
  for (const char* command : {"plan", "ct", "archive", "patients", "outcomes"})
    if (app.got_subcommand(command)) ::umask(S_IRWXG | S_IRWXO);
  if (app.got_subcommand("simulate")) return simulate(options.simulate, files);
  if (app.got_subcommand("anatomy")) return describeAnatomy(options.anatomy);
  if (app.got_subcommand("replay")) return replay(options.replay);
  if (app.got_subcommand("validate")) return validate(options.validate, files);
  if (app.got_subcommand("calibrate")) return calibrate(options.calibrate, files);
  if (app.got_subcommand("predict")) return predict(options.predict, files);
  if (app.got_subcommand("plan")) return plan(options.plan, files);
  if (app.got_subcommand("compare")) return compare(options.compare, files);
  if (app.got_subcommand("patients")) return patients(options.patients);
  if (app.got_subcommand("outcomes")) return outcomes(options.outcomes, files);
  if (app.got_subcommand("devices")) return devices(options.devices);
  if (app.got_subcommand("study"))
    return runStudy(*app.get_subcommand("study"), files, options.study);
  if (app.got_subcommand("ct")) return runCt(*app.get_subcommand("ct"), options);
  if (app.got_subcommand("archive"))
    return runArchive(*app.get_subcommand("archive"), options.archive);
  return render(options.render, files);
}

}  // namespace perilymph::cli

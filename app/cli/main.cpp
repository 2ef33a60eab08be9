// perilymph-cli: everything without a window. Here the words of the call are read; the commands are
// in files of their own.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "Commands.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

// Exit statuses people's scripts rely on.
constexpr int done = 0;
constexpr int couldNot = 1;
constexpr int wrongWords = 2;

/// One option that sets a scenario's key of the same meaning.
void overrideOption(CLI::App& command, const std::string& option, const std::string& key,
                    session::Overrides& overrides, const std::string& help)
{
  command.add_option_function<std::string>(
      option, [&overrides, key](const std::string& value) { overrides.emplace_back(key, value); },
      help);
}

void setOption(CLI::App& command, session::Overrides& overrides)
{
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&overrides](const std::vector<std::string>& settings) {
            for (const std::string& setting : settings) {
              const std::size_t equals = setting.find('=');
              if (equals == std::string::npos || equals == 0)
                throw CLI::ValidationError("--set", "'" + setting + "' is not key=value");
              overrides.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
            }
          },
          "Changes a scenario's key: --set speed_mm_s=1.0; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
}

void addSimulate(CLI::App& app, SimulateOptions& options)
{
  CLI::App& command = *app.add_subcommand("simulate", "Runs an insertion in virtual time");
  command.add_option("--scenario", options.scenario, "A scenario's file or shipped name")
      ->required();
  overrideOption(command, "--patient", "patient", options.overrides,
                 "A patient's file or shipped name");
  overrideOption(command, "--array", "array", options.overrides, "An electrode array");
  overrideOption(command, "--model", "model", options.overrides, "rod or points");
  overrideOption(command, "--nodes", "nodes", options.overrides,
                 "Nodes of the rod, or sample points");
  overrideOption(command, "--seed", "seed", options.overrides, "Of whatever is drawn at random");
  setOption(command, options.overrides);
  CLI::Option* csv = command.add_option("--csv", options.csv, "Writes a row a tick");
  command.add_option("--every-ms", options.every_ms, "Between rows of the CSV")
      ->check(CLI::Range(0.0, 1e6))
      ->needs(csv);
  command.add_option("--json", options.json, "Writes scenario and results");
  command.add_option("--record", options.record, "Keeps the session as an .insertion file");
}

void addAnatomy(CLI::App& app, AnatomyOptions& options)
{
  CLI::App& command = *app.add_subcommand("anatomy", "Measures a cochlea and writes its shape");
  CLI::Option_group& source = *command.add_option_group("anatomy");
  source.add_option("--preset", options.preset, "published, mean or clark")
      ->check(CLI::IsMember({"published", "mean", "clark"}));
  source.add_option("--patient", options.patient, "A patient's file or shipped name");
  CLI::Option* length =
      source.add_option("--st-length-mm", options.stLength_mm, "Length of the organ-of-Corti path");
  CLI::Option* a =
      source.add_option("--a-mm", options.a_mm, "A: through round window and modiolus");
  source.add_option("--import", options.import, "A segmented surface in mm: .stl .ply .vtp");
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
  command.add_option("--json", options.json, "Writes the measures, formulas and sources");
  command.add_option("--sections", options.sections, "Writes the sections as CSV");
  CLI::Option* surface = command.add_option("--surface", options.surface,
                                            "Writes the shape: .stl .vtp .ply .obj .wrl");
  command.add_option("--haptic-surface", options.hapticSurface,
                     "Writes the shape a hand is shown: no apex, 95 % fewer triangles");
  command.add_option("--part", options.part, "scala, membrane or vestibuli")
      ->check(CLI::IsMember({"scala", "membrane", "vestibuli"}))
      ->needs(surface);
}

void addReplay(CLI::App& app, ReplayOptions& options)
{
  CLI::App& command = *app.add_subcommand("replay", "Reads a recorded session");
  command.add_option("file", options.file, "The .insertion file")->required();
  command.add_flag("--verify", options.verifies, "Runs it again and compares every bit");
  command.add_option("--csv", options.csv, "Writes a row a tick");
}

void addValidate(CLI::App& app, ValidateOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("validate", "Repeats the published experiment, with its statistics");
  command.add_option("--runs", options.runs, "Insertions")->check(CLI::Range(2, 100'000));
  command.add_option("--seed", options.seed, "Of everything that varies between insertions")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Insertions at a time; by default one a processor")
      ->check(CLI::Range(1u, 256u));
  overrideOption(command, "--model", "model", options.overrides, "rod or points");
  setOption(command, options.overrides);
  command.add_option("--variability", options.variability,
                     "What varies and how much: a file or a shipped name");
  command.add_option("--out", options.out, "The folder for tables and figures")->required();
}

void addCalibrate(CLI::App& app, CalibrateOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("calibrate", "Fits two numbers of the array to two printed forces");
  command.add_option("--runs", options.runs, "Insertions behind each trial")
      ->check(CLI::Range(2, 10'000));
  command.add_option("--seed", options.seed, "Of everything that varies between insertions")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Insertions at a time; by default one a processor")
      ->check(CLI::Range(1u, 256u));
  setOption(command, options.overrides);
  command.add_option("--variability", options.variability,
                     "What varies and how much: a file or a shipped name");
  command.add_option("--out", options.out, "The folder for the calibration")->required();
}

void addPredict(CLI::App& app, PredictOptions& options)
{
  CLI::App& command =
      *app.add_subcommand("predict", "Inserts arrays into cochleae that nothing was fitted to");
  command.add_option("--array", options.arrays, "Electrode arrays, by name or file")->required();
  command.add_option("--patients", options.patients, "Virtual patients beside the mean cochlea")
      ->check(CLI::Range(0, 10'000));
  command.add_option("--seed", options.seed, "Of the virtual patients")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--jobs", options.jobs, "Cochleae at a time; by default one a processor")
      ->check(CLI::Range(1u, 256u));
  command.add_option("--out", options.out, "The folder for the tables")->required();
}

void addCompare(CLI::App& app, CompareOptions& options)
{
  CLI::App& command = *app.add_subcommand("compare", "Sets recorded insertions side by side");
  command.add_option("files", options.files, "The .insertion files")->required();
  command.add_option("--out", options.out, "The folder for tables and curves")->required();
}

void addRender(CLI::App& app, RenderOptions& options)
{
  CLI::App& command = *app.add_subcommand("render", "Draws a picture without a window");
  CLI::Option* scenario =
      command.add_option("--scenario", options.scenario, "A scenario's file or shipped name");
  CLI::Option* patient =
      command.add_option("--patient", options.patient, "A patient's file or shipped name");
  CLI::Option* preset = command.add_option("--preset", options.preset, "published")
                            ->check(CLI::IsMember({"published", "mean", "clark"}));
  preset->excludes(scenario)->excludes(patient);
  command.add_option("--array", options.array, "An electrode array")->needs(scenario);
  command.add_option("--at-mm", options.at_mm, "Travel to draw the array at")->needs(scenario);
  command.add_option("--view", options.view, "surgeon, microscope, overview, section or unrolled")
      ->check(CLI::IsMember({"surgeon", "microscope", "overview", "section", "unrolled"}));
  command.add_option("--out", options.out, "The picture, .png")->required();
  command.callback([&options] {
    if (options.scenario.empty() && options.patient.empty() && options.preset.empty())
      throw CLI::RequiredError("--scenario, --patient or --preset");
  });
}

void addDevices(CLI::App& app, DevicesOptions& options)
{
  CLI::App& command = *app.add_subcommand(
      "devices", "Lists HID devices, whether one can be the hand, and tries one");
  command.add_option("--json", options.json, "Writes the list, and what the test measured");
  CLI::Option* test =
      command
          .add_option(
              "--test", options.test,
              "Measures reports, then shows small forces: the number of the node, 3 for hidraw3")
          ->check(CLI::Range(0, 4095));
  command.add_option("--capture", options.capture, "Keeps every report of the test, with its time")
      ->needs(test);
  command
      .add_option("--replay", options.replay,
                  "Reads a captured file (or hid-recorder's) as the device it is of")
      ->excludes(test);
  command
      .add_option("--plugin", options.plugin,
                  "Loads a device plug-in (FILE.so) and tries it as --test does; it runs with your "
                  "rights")
      ->excludes(test)
      ->excludes("--replay");
}

/// What is wrong with the words of a call.
std::string words(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv)
{
  const bool namesNothing = argc < 2 || argv[1][0] == '-' || !app.get_subcommands().empty();
  if (namesNothing) return error.what();
  return "There is no command '" + std::string(argv[1]) +
         "'; there are simulate, anatomy, validate, calibrate, predict, compare, replay, render "
         "and devices";
}

int report(const Result<Done>& result)
{
  if (result) return done;
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  return couldNot;
}

int run(int argc, char** argv)
{
  CLI::App app(
      "Perilymph, the cochlear-implant insertion workstation, without its window.\n"
      "For research and training; not a medical device.",
      "perilymph-cli");
  app.set_version_flag("--version", buildId());
  app.require_subcommand(1);
  SimulateOptions simulateOptions;
  AnatomyOptions anatomyOptions;
  ReplayOptions replayOptions;
  RenderOptions renderOptions;
  ValidateOptions validateOptions;
  CalibrateOptions calibrateOptions;
  PredictOptions predictOptions;
  CompareOptions compareOptions;
  addSimulate(app, simulateOptions);
  addAnatomy(app, anatomyOptions);
  addReplay(app, replayOptions);
  addRender(app, renderOptions);
  addValidate(app, validateOptions);
  addCalibrate(app, calibrateOptions);
  addPredict(app, predictOptions);
  addCompare(app, compareOptions);
  DevicesOptions devicesOptions;
  addDevices(app, devicesOptions);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::fprintf(stderr, "%s. See perilymph-cli --help.\n", words(error, app, argc, argv).c_str());
    return wrongWords;
  }
  if (app.got_subcommand("simulate")) return report(simulate(simulateOptions));
  if (app.got_subcommand("anatomy")) return report(describeAnatomy(anatomyOptions));
  if (app.got_subcommand("replay")) return report(replay(replayOptions));
  if (app.got_subcommand("validate")) return report(validate(validateOptions));
  if (app.got_subcommand("calibrate")) return report(calibrate(calibrateOptions));
  if (app.got_subcommand("predict")) return report(predict(predictOptions));
  if (app.got_subcommand("compare")) return report(compare(compareOptions));
  if (app.got_subcommand("devices")) return report(devices(devicesOptions));
  return report(render(renderOptions));
}

}  // namespace

}  // namespace perilymph::cli

int main(int argc, char** argv)
{
  try {
    return perilymph::cli::run(argc, argv);
  } catch (const std::exception& mistake) {
    std::fprintf(stderr, "A mistake in the program stopped it: %s.\n", mistake.what());
    return 1;
  }
}

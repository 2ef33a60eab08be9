// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/CommandLine.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string_view>

#include "EmptyValues.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

/// Error for a file to open that is not there; empty if it is.
std::string checkFile(const std::string& file)
{
  std::error_code failure;
  if (std::filesystem::exists(file, failure)) return {};
  return file + " does not exist, so it cannot be opened; check its name.";
}

/// Error for an unsupported screenshot file; empty if it is supported.
std::string checkPicture(const std::string& file)
{
  if (std::filesystem::path(file).extension() == ".png") return {};
  return file + " cannot be the name of a screenshot: it must end in .png.";
}

/// Error for an unsupported report file; empty if it is supported.
std::string checkReport(const std::string& file)
{
  const auto extension = std::filesystem::path(file).extension();
  if (extension == ".pdf" || extension == ".dcm") return {};
  return file + " cannot be the name of a report: it must end in .pdf or .dcm.";
}

/// Error for an invalid delay of the screenshot; empty if valid.
std::string checkDelay(const std::string& text)
{
  double seconds = -1.0;
  if (CLI::detail::lexical_cast(text, seconds) && seconds >= 0.0 && seconds <= 3600.0) return {};
  return "--after is " + text + "; it must be a number of seconds between 0 and 3600.";
}

/// Error for an endpoint that cannot be listened at; empty if it can be read.
std::string checkEndpoint(const std::string& text)
{
  const auto endpoint = broadcast::parseEndpoint(text);
  return endpoint ? Sentence() : endpoint.error().message;
}

}  // namespace

std::variant<CommandLine, Exit> parseCommandLine(int argc, const char* const* argv)
{
  CommandLine options;
  CLI::App app("Perilymph, the cochlear-implant insertion workstation. Not a medical device.",
               "perilymph");
  app.set_version_flag("--version", "perilymph " + buildId());

  std::string file, record, plugin, device, screenshot, study, plan, report, ct, igtl, igtlFrame,
      bone;
  app.add_option("--scenario", options.scenario,
                 "Scenario: shipped name or TOML file (default: start page)")
      ->type_name("FILE|NAME");
  auto* fileOption = app.add_option("FILE", file,
                                    "Recording (.insertion), patient (.toml), plan (its folder), "
                                    "study (.sqlite) or CT (a DICOM "
                                    "folder, a NIfTI or NRRD file) to open")
                         ->check(checkFile);
  auto* demoOption = app.add_flag("--demo", options.isDemo, "Start the insertion automatically");
  auto* recordOption =
      app.add_option("--record", record,
                     "File of the recording (default: in the folder of recordings)")
          ->type_name("FILE");
  auto* pluginOption =
      app.add_option("--device-plugin", plugin,
                     "Device plug-in used as input device; it runs with your rights")
          ->type_name("FILE.so")
          ->excludes(demoOption);
  auto* deviceOption =
      app.add_option("--device", device,
                     "Input device: its name or place, or the name of an installed plug-in, as "
                     "listed by perilymph-cli devices")
          ->type_name("DEVICE")
          ->excludes(demoOption)
          ->excludes(pluginOption);
  auto* studyOption = app.add_option("--study", study, "Open the result of a study")
                          ->type_name("FILE.sqlite")
                          ->excludes(demoOption);
  auto* planOption = app.add_option("--plan", plan, "Folder or plan.json of a plan to report")
                         ->type_name("FILE")
                         ->excludes(demoOption)
                         ->excludes(studyOption);
  auto* reportOption =
      app.add_option("--report", report, "Write the plan's report, then exit; needs no display")
          ->type_name("FILE.pdf|FILE.dcm")
          ->needs(planOption)
          ->check(checkReport);
  planOption->needs(reportOption);
  auto* ctOption =
      app.add_option(
             "--ct", ct,
             "CT of the patient: FILE.dcm becomes part of its study, with the patient's name "
             "and number (default: the code alone)")
          ->type_name("PATH")
          ->needs(reportOption);
  app.add_flag("--ct-not-compared", options.isCtNotCompared,
               "File a plan that states no CT series into the study of --ct all the same")
      ->needs(ctOption);
  auto* igtlOption =
      app.add_option("--igtl", igtl,
                     "Send the insertion to OpenIGTLink clients, such as 3D Slicer, by default of "
                     "this machine only (usual port: 18944)")
          ->type_name("[ADDRESS:]PORT")
          ->excludes(planOption)
          ->check(checkEndpoint);
  app.add_option("--igtl-frame", igtlFrame,
                 "Frame in which the insertion is sent: cochlea, or patient (RAS, while the CT of "
                 "the cochlea is open)")
      ->type_name("FRAME")
      ->needs(igtlOption)
      ->check(CLI::IsMember({"cochlea", "patient"}))
      ->default_str("cochlea");
  auto* screenshotOption =
      app.add_option("--screenshot", screenshot, "Save a screenshot of the window, then exit")
          ->type_name("FILE.png")
          ->check(checkPicture);
  app.add_option("--after", options.after_s, "Delay of the screenshot after the first frame (s)")
      ->type_name("SECONDS")
      ->needs(screenshotOption)
      ->check(checkDelay)
      ->capture_default_str();
  app.add_option("--quality", options.quality, "Rendering quality (default: as set in the window)")
      ->check(CLI::IsMember({"auto", "fast", "balanced", "full"}));
  auto* measureOption =
      app.add_flag("--measure-frames", options.measuresFrames,
                   "Run the demo, or filter the study, print frame times, then exit")
          ->excludes(screenshotOption)
          ->excludes(pluginOption)
          ->excludes(deviceOption);
  auto* boneOption =
      app.add_option("--bone", bone,
                     "With --measure-frames: open this CT and turn its bone instead of the demo")
          ->type_name("CT")
          ->check(checkFile)
          ->needs(measureOption)
          ->excludes(studyOption);
  app.add_option("--ticks", options.measuredTicks,
                 "Repeat the demo until N samples are recorded (3600000 = 1 h) and compare the "
                 "last insertion with the first (default: one insertion)")
      ->type_name("N")
      ->needs(measureOption)
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1000000000}));
  app.add_option("--language", options.language,
                 "Language and number format of this session (default: as set in the window)")
      ->type_name("en|de|system")
      ->check(CLI::IsMember({"en", "de", "system"}));
  app.add_flag("--kiosk", options.isKiosk, "Full-screen demo for visitors; Ctrl+Alt+Q ends it")
      ->excludes(demoOption)
      ->excludes(recordOption)
      ->excludes(pluginOption)
      ->excludes(deviceOption)
      ->excludes(studyOption)
      ->excludes("--measure-frames");
  for (const char* other : {"--demo", "--study", "--plan", "--kiosk", "--measure-frames"})
    fileOption->excludes(other);

  try {
    options::refuseEmptyValues(app);
    options::refuseEmptyArguments(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help and --version
    app.exit(success);
    return Exit{0};
  } catch (const CLI::ParseError& error) {
    std::cerr << error.what() << "\nperilymph --help lists the options.\n";
    return Exit{2};
  }
  if (fileOption->count() > 0) options.file = std::filesystem::absolute(file);
  if (recordOption->count() > 0) options.record = record;
  if (studyOption->count() > 0) options.study = study;
  if (boneOption->count() > 0) options.bone = bone;
  if (planOption->count() > 0) options.plan = plan;
  if (reportOption->count() > 0) options.report = report;
  if (ctOption->count() > 0) options.ct = ct;
  if (pluginOption->count() > 0) options.plugin = plugin;
  if (deviceOption->count() > 0) options.device = device;
  if (igtlOption->count() > 0) options.igtl = *broadcast::parseEndpoint(igtl);
  options.igtlCoordinates =
      valueIn(broadcast::coordinateSystems, igtlFrame).value_or(broadcast::Coordinates::cochlea);
  if (screenshotOption->count() > 0) options.screenshot = screenshot;
  return options;
}

}  // namespace perilymph::gui

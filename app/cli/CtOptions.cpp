// SPDX-License-Identifier: BSD-3-Clause
#include "CtOptions.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "CommandOptions.h"
#include "FileOptions.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::cli {

namespace {

constexpr const char* pathHelp =
    "A folder of DICOM files, a DICOMDIR, a DICOM file of many frames, a NIfTI or NRRD file";

/// Three numbers with commas between them, in millimeters.
std::array<double, 3> pointIn(const std::string& text)
{
  std::array<double, 3> point{};
  const char* place = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(place, end, point[i]);
    const bool isSeparated = i == 2 ? next == end : next != end && *next == ',';
    if (error != std::errc{} || !isSeparated || !std::isfinite(point[i]))
      throw CLI::ValidationError("--at", "'" + text + "' is not X,Y,Z in LPS millimeters");
    place = next + 1;
  }
  return point;
}

std::string flagsText()
{
  std::string text = "Flags:\n";
  for (const ct::Flag flag : ct::allFlags())
    text += std::string("  ") + ct::nameOf(flag) + "\n      " + ct::sentenceOf(flag) + "\n";
  return text;
}

void addInfo(CLI::App& ct, FileOptions& files, CtInfoOptions& options)
{
  CLI::App& command = *ct.add_subcommand(
      "info", "Lists the series of a CT, the one that suits a cochlea best first");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  files.writes(command.add_option("--json", options.json, "Writes the list; none by default"));
}

void addMeasure(CLI::App& ct, FileOptions& files, CtMeasureOptions& options)
{
  CLI::App& command =
      *ct.add_subcommand("measure", "Finds the cochlea in a CT and measures A, B and H");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  command.add_option("--series", options.series,
                     "UID of the series, as 'ct info' lists it; the best series by default");
  CLI::Option* at = command.add_option_function<std::string>(
      "--at", [&options](const std::string& text) { options.at_mm = pointIn(text); },
      "X,Y,Z: a point anywhere in the cochlea, LPS in mm; by default the volume is searched");
  files.reads(
      command
          .add_option("--landmarks", options.landmarks,
                      "Slicer markups (.mrk.json) with points RW, C, A in place of --at; none by "
                      "default")
          ->excludes(at));
  command
      .add_option("--side", options.side,
                  "left or right: the ear to look for; by default any, found by its spiral")
      ->check(CLI::IsMember({"left", "right"}));
  files.writes(command.add_option(
      "--json", options.json, "Writes the measures in mm, each with its error; none by default"));
  files.writes(command.add_option("--patient", options.patient,
                                  "Writes a patient (.toml) that other commands take; none by "
                                  "default"));
  files.writes(command.add_option("--surface", options.surface,
                                  "Writes the lumen's wall, LPS in mm: .stl .ply .vtp .obj .wrl; "
                                  "none by default"));
  command.footer(flagsText());
}

}  // namespace

void addCt(CLI::App& app, FileOptions& files, CommandOptions& options)
{
  CLI::App& ct = *app.add_subcommand("ct", "Reads a temporal-bone CT and measures the cochlea");
  ct.require_subcommand(1);
  addInfo(ct, files, options.ctInfo);
  addMeasure(ct, files, options.ctMeasure);
}

}  // namespace perilymph::cli

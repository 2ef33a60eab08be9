// SPDX-License-Identifier: BSD-3-Clause
#include "CtOptions.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "CommandOptions.h"
#include "FileOptions.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::cli {

namespace {

constexpr const char* pathHelp =
    "DICOM folder, .zip of one, DICOMDIR, multi-frame DICOM file, NIfTI, NRRD or MetaImage file";

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

/// Adds the option --at.
/// @param which  Of which CT, for its help.
CLI::Option* addPoint(CLI::App& command, std::optional<std::array<double, 3>>& at_mm,
                      const std::string& which)
{
  return command.add_option_function<std::string>(
      "--at", [&at_mm](const std::string& text) { at_mm = pointIn(text); },
      "X,Y,Z: any point in the cochlea, LPS in mm" + which + " (default: automatic search)");
}

template <class Flag>
std::string flagsText(const std::vector<Flag>& flags)
{
  std::string text = "Flags:\n";
  for (const Flag flag : flags)
    text += std::string("  ") + nameOf(flag) + "\n      " + sentenceOf(flag) + "\n";
  return text;
}

void addInfo(CLI::App& ct, FileOptions& files, CtInfoOptions& options)
{
  CLI::App& command = *ct.add_subcommand("info", "List the series of a CT, best suited first");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  files.writes(command.add_option("--json", options.json, "Write the list (JSON)"));
}

void addMeasure(CLI::App& ct, FileOptions& files, CtMeasureOptions& options)
{
  CLI::App& command =
      *ct.add_subcommand("measure", "Locate the cochlea in a CT and measure A, B and H");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  command.add_option("--series", options.series,
                     "Series UID, as listed by 'ct info' (default: best suited series)");
  CLI::Option* at = addPoint(command, options.at_mm, "");
  files.reads(
      command
          .add_option("--landmarks", options.landmarks,
                      "3D Slicer markups (.mrk.json) with points RW, C and A, instead of --at")
          ->excludes(at));
  command
      .add_option("--side", options.side,
                  "Ear: left, right or both, by the winding of the spiral (default: the best seen)")
      ->check(CLI::IsMember({"left", "right", "both"}));
  files.writes(
      command.add_option("--json", options.json, "Write measures in mm with their errors (JSON)"));
  files.writes(command.add_option("--patient", options.patient,
                                  "Write a patient file (.toml) for other commands"));
  files.writes(command.add_option("--surface", options.surface,
                                  "Write the lumen wall, LPS in mm (.stl .ply .vtp .obj .wrl)"));
  files.writes(
      command.add_option("--picture", options.picture,
                         "Write the cochlear and mid-modiolar views with the fitted wall (.png)"));
  files.writes(command.add_option(
      "--structured-report", options.structuredReport,
      "Write the measures as a DICOM structured report (TID 1500) of the CT's study (.dcm)"));
  files.writes(command.add_option(
      "--segmentation", options.segmentation,
      "Write the fitted lumen as a DICOM segmentation of the CT's series (.dcm)"));
  files.writes(command.add_option(
      "--key-image", options.keyImage,
      "Write the views of --picture as a DICOM secondary capture in the CT's study (.dcm)"));
  command.footer(flagsText(ct::allFlags()));
}

void addContacts(CLI::App& ct, FileOptions& files, CtContactsOptions& options)
{
  CLI::App& command = *ct.add_subcommand(
      "contacts", "Find the contacts of an implanted array in a CT after surgery");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  command.add_option("--series", options.series,
                     "Series UID, as listed by 'ct info' (default: best suited series)");
  files.reads(command
                  .add_option("--array", options.array,
                              "The array that was implanted: shipped name or TOML file")
                  ->required());
  files.reads(command.add_option("--patient", options.patient,
                                 "Patient whose side, A and B are compared with those of this ear: "
                                 "shipped name or TOML file"));
  files.readsBelow(command.add_option(
      "--preop", options.preop,
      "CT before surgery, in which the cochlea is measured without metal (default: in this CT)"));
  command.add_option("--preop-series", options.preopSeries,
                     "Series UID of the CT before surgery (default: best suited series)");
  addPoint(command, options.at_mm, ", of the CT in which it is measured");
  command.add_option("--side", options.side, "Ear: left or right (default: the best seen)")
      ->check(CLI::IsMember({"left", "right"}));
  files.writes(command.add_option("--json", options.json, "Write contacts and depth (JSON)"));
  files.writes(command.add_option(
      "--csv", options.csv,
      "Write a row for each contact, and what its columns mean beside it (-dictionary.csv)"));
  files.writes(command.add_option("--markups", options.markups,
                                  "Write contacts and course for 3D Slicer, LPS (.mrk.json)"));
  files.writes(command.add_option(
      "--picture", options.picture,
      "Write the cochlear and mid-modiolar views with wall and contacts (.png)"));
  command.footer(flagsText(outcome::allFlags()));
}

void addMarkups(CLI::App& ct, FileOptions& files, CtMarkupsOptions& options)
{
  CLI::App& command = *ct.add_subcommand(
      "markups",
      "Write distances, angles, notes and structures that were marked in a patient's CT");
  files.reads(
      command
          .add_option("patient", options.patient,
                      "A patient's file (.toml); what was marked is in the record beside it")
          ->required());
  command.add_option("--series", options.series,
                     "SHA-256 of the CT series or its beginning (default: the only one)");
  files.writes(command.add_option("--json", options.json,
                                  "Write points in LPS and values with their errors (JSON)"));
  files.writes(command.add_option(
      "--csv", options.csv,
      "Write a row for each point, and what its columns mean beside it (-dictionary.csv)"));
  files.writes(command.add_option("--markups", options.markups,
                                  "Write them for 3D Slicer, LPS (.mrk.json)"));
}

void addExport(CLI::App& ct, FileOptions& files, CtExportOptions& options)
{
  CLI::App& command =
      *ct.add_subcommand("export", "Write a CT without patient data (voxels and geometry only)");
  files.readsBelow(command.add_option("path", options.path, pathHelp)->required());
  command.add_option("--series", options.series,
                     "Series UID, as listed by 'ct info' (default: best suited series)");
  files.writes(
      command.add_option("--out", options.out, "File to write (.nrrd .nii .nii.gz)")->required());
}

}  // namespace

void addCt(CLI::App& app, FileOptions& files, CommandOptions& options)
{
  CLI::App& ct = *app.add_subcommand("ct", "Measure the cochlea in a temporal-bone CT");
  ct.require_subcommand(1);
  addInfo(ct, files, options.ctInfo);
  addMeasure(ct, files, options.ctMeasure);
  addContacts(ct, files, options.ctContacts);
  addMarkups(ct, files, options.ctMarkups);
  addExport(ct, files, options.ctExport);
}

Result<void> runCt(const CLI::App& ct, const CommandOptions& options)
{
  if (ct.got_subcommand("info")) return ctInfo(options.ctInfo);
  if (ct.got_subcommand("contacts")) return ctContacts(options.ctContacts);
  if (ct.got_subcommand("markups")) return ctMarkups(options.ctMarkups);
  if (ct.got_subcommand("export")) return ctExport(options.ctExport);
  return ctMeasure(options.ctMeasure);
}

}  // namespace perilymph::cli

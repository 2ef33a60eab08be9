// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <nlohmann/json.hpp>

#include "AnatomySurfaces.h"
#include "Commands.h"
#include "JsonText.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/analysis/ClinicalEstimates.h"
#include "perilymph/anatomy/ImportedScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/imaging/SurfaceReader.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

std::vector<analysis::Measure> measuresOf(const anatomy::ImportedScala& scala)
{
  const std::string own = "measured on the imported surface, about the axis found in it";
  std::vector<analysis::Measure> measures = {
      {"A_mm", inMillimeters(scala.a), "outer wall radius at 0 deg + at 180 deg", own},
      {"B_mm", inMillimeters(scala.b), "outer wall radius at 90 deg + at 270 deg", own},
      {"H_mm", inMillimeters(scala.h), "highest roof - lowest floor along the axis, from 0 deg on",
       own},
      {"turns", inDegrees(scala.lastAngle) / 360.0, "angle of the duct's end / 360 deg", own},
      analysis::ductLength("cdl_oc_mm", scala.a, scala.b),
      {"volume_mm3", 1e9 * scala.volume, "enclosed by the surface, its openings closed", own},
      {"lead_in_mm", inMillimeters(scala.leadIn),
       "straight stretch between the rim and 0 deg, left out of the other measures but the volume",
       own}};
  for (analysis::Measure& estimate : analysis::clinicalEstimates(scala.a, scala.b))
    measures.push_back(std::move(estimate));
  return measures;
}

/// Warnings of unusual shapes, as of a wrong unit or a stretched scan, and of flaws of the surface.
std::vector<std::string> warningsOf(const anatomy::ImportedScala& scala)
{
  anatomy::Patient measured;
  measured.basalTurn = anatomy::BasalTurn{scala.a, scala.b, scala.h};
  const std::vector<Sentence> unusual = anatomy::unusualMeasures(measured);
  std::vector<std::string> warnings(unusual.begin(), unusual.end());
  for (const anatomy::ImportDoubt& doubt : scala.doubts) warnings.push_back(doubt.sentence);
  return warnings;
}

std::string importJson(const std::string& label, const anatomy::ImportedScala& scala)
{
  nlohmann::ordered_json json;
  json["label"] = label;
  json["side"] = anatomy::nameOf(scala.side);
  json["anatomy"] = "imported";
  json["triangles"] = scala.wall_W.triangles.size();
  // pose of the cochlear frame in the file's frame
  const Eigen::Vector3d origin_mm = 1e3 * scala.place.origin_I;
  const Eigen::Vector3d axis = scala.place.axes_IW.col(2);
  const Eigen::Vector3d zero = scala.place.axes_IW.col(0);
  json["axis_point_mm"] = {origin_mm.x(), origin_mm.y(), origin_mm.z()};
  json["axis_toward_apex"] = {axis.x(), axis.y(), axis.z()};
  json["toward_round_window"] = {zero.x(), zero.y(), zero.z()};
  for (const analysis::Measure& measure : measuresOf(scala)) json[measure.key] = measure.value;
  for (const analysis::Measure& measure : measuresOf(scala))
    json["derived"][measure.key] = {{"formula", measure.formula}, {"source", measure.source}};
  json["flags"] = nlohmann::ordered_json::array();
  for (const anatomy::ImportDoubt& doubt : scala.doubts) json["flags"].push_back(doubt.flag);
  json["warnings"] = warningsOf(scala);
  return jsonText(json);
}

}  // namespace

Result<void> describeImport(const AnatomyOptions& options)
{
  if (!options.sections.empty() || !options.hapticSurface.empty() || options.part != "scala")
    return Error{
        "An imported surface is measured and written as it is: --sections, --haptic-surface and "
        "--part need --preset, --patient or measures. Leave them out, or leave out --import."};
  const auto surface = imaging::readSurface(options.import);
  if (!surface) return surface.error();
  const auto scala = anatomy::importScala(*surface);
  if (!scala) return Error{options.import + ": " + scala.error().message};

  const std::string label = std::filesystem::path(options.import).stem().string();
  if (!options.surface.empty())
    if (const auto done =
            writeEar(scala->wall_W, "imported scala", label, scala->side, options.surface);
        !done)
      return done.error();
  if (!options.json.empty())
    if (const auto done = writeWhole(options.json, importJson(label, *scala)); !done)
      return done.error();
  print("{}, {} ear, imported\n", label, anatomy::nameOf(scala->side));
  for (const analysis::Measure& measure : measuresOf(*scala))
    print("{:26} {}\n", measure.key, fixed(measure.value, 2));
  for (const std::string& warning : warningsOf(*scala)) print("{}\n", warning);
  return {};
}

#else

Result<void> describeImport(const AnatomyOptions&)
{
  return Error{
      "This build has no VTK, so it cannot read a surface; use --preset, --patient or measures, or "
      "a "
      "build of the preset release."};
}

#endif

}  // namespace perilymph::cli

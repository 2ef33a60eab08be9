#include <cstdio>
#include <nlohmann/json.hpp>

#include "Commands.h"
#include "OutputFile.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

namespace {

// Enough for the eye: the wall's triangles are then some 0.1 mm long.
constexpr int wallTriangles = 20'000;
constexpr int membraneTriangles = 4'000;

Result<anatomy::Patient> choosePatient(const AnatomyOptions& options)
{
  if (!options.notThereYet.empty())
    return Error{options.notThereYet +
                 " is not in this version. Use --preset published, --patient FILE or "
                 "--st-length-mm with --rw-width-mm and --rw-height-mm."};
  if (!options.preset.empty() && options.preset != "published")
    return Error{"The preset '" + options.preset +
                 "' is not in this version; use --preset published."};
  anatomy::Patient patient;
  if (!options.patient.empty()) {
    const auto file = findByName("patient", "resources/patients", options.patient);
    if (!file) return file.error();
    return anatomy::loadPatient(*file);
  }
  if (options.stLength_mm) {
    patient.label = "given lengths";
    patient.scalaTympaniLength = millimeters(*options.stLength_mm);
    patient.roundWindowWidth = millimeters(*options.rwWidth_mm);
    patient.roundWindowHeight = millimeters(*options.rwHeight_mm);
  }
  return patient;
}

std::string anatomyJson(const anatomy::Patient& patient,
                        const std::vector<analysis::Measure>& measures)
{
  nlohmann::ordered_json json;
  json["label"] = patient.label;
  json["side"] = patient.side == anatomy::Side::left ? "left" : "right";
  json["anatomy"] = "published";
  json["given"] = {{"st_length_mm", inMillimeters(patient.scalaTympaniLength)},
                   {"rw_width_mm", inMillimeters(patient.roundWindowWidth)},
                   {"rw_height_mm", inMillimeters(patient.roundWindowHeight)}};
  for (const analysis::Measure& measure : measures) json[measure.key] = measure.value;
  for (const analysis::Measure& measure : measures)
    json["derived"][measure.key] = {{"formula", measure.formula}, {"source", measure.source}};
  return json.dump(2) + '\n';
}

/// A left ear leaves the program as the mirror image of the right one inside.
void mirror(anatomy::Surface& surface)
{
  for (auto& point : surface.points) point[1] = -point[1];
  for (auto& corners : surface.triangles) std::swap(corners[1], corners[2]);
}

Result<Done> writePart(const anatomy::ScalaTympani& scala, const anatomy::Patient& patient,
                       const AnatomyOptions& options)
{
  anatomy::Surface surface = options.part == "membrane"
                                 ? anatomy::membraneSurface(scala, membraneTriangles)
                                 : anatomy::wallSurface(scala, wallTriangles);
  const bool isLeft = patient.side == anatomy::Side::left;
  if (isLeft) mirror(surface);
  const std::string title =
      "Perilymph, " + options.part + " of " + patient.label + (isLeft ? ", left" : ", right");
  return anatomy::writeSurface(surface, title, options.surface);
}

}  // namespace

Result<Done> describeAnatomy(const AnatomyOptions& options)
{
  for (const std::string& file : {options.json, options.sections, options.surface})
    if (const auto done = checkPlace(file); !done) return done.error();
  if (options.part == "vestibuli")
    return Error{"--part vestibuli is not in this version; use scala or membrane."};
  const auto patient = choosePatient(options);
  if (!patient) return patient.error();
  if (const auto done = anatomy::checkPatient(*patient); !done) return done.error();

  session::Scenario scenario;
  scenario.name = patient->label;
  scenario.patient = *patient;
  const auto scala = session::buildAnatomy(scenario);
  if (!scala) return scala.error();
  const auto measures = analysis::measure(**scala);

  // The shape first: it is the one that a wrong ending may refuse.
  if (!options.surface.empty())
    if (const auto done = writePart(**scala, *patient, options); !done) return done.error();
  if (!options.sections.empty()) {
    // a section every 5 degrees: four between those of the measured cochleae
    const auto rows = analysis::sectionRows(**scala, degrees(5));
    if (const auto done = writeWhole(options.sections, analysis::sectionsCsv(rows)); !done)
      return done.error();
  }
  if (!options.json.empty())
    if (const auto done = writeWhole(options.json, anatomyJson(*patient, measures)); !done)
      return done.error();

  std::printf("%s, %s ear, published anatomy\n", patient->label.c_str(),
              patient->side == anatomy::Side::left ? "left" : "right");
  for (const analysis::Measure& measure : measures)
    std::printf("%-26s %s\n", measure.key.c_str(), fixed(measure.value, 2).c_str());
  return Done{};
}

}  // namespace perilymph::cli

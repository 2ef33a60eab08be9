#include <cstdio>
#include <nlohmann/json.hpp>

#include "AnatomySurfaces.h"
#include "Commands.h"
#include "OutputFile.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

namespace {

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

void tell(nlohmann::ordered_json& json, const HapticSurfaceNumbers& haptic)
{
  json["haptic_surface_triangles"] = haptic.triangles;
  json["haptic_surface_visual_triangles"] = haptic.visualTriangles;
  json["haptic_surface_deviation_mean_mm"] = inMillimeters(haptic.deviation.mean);
  json["haptic_surface_deviation_p95_mm"] = inMillimeters(haptic.deviation.p95);
  json["haptic_surface_deviation_max_mm"] = inMillimeters(haptic.deviation.greatest);
}

std::string anatomyJson(const anatomy::Patient& patient,
                        const std::vector<analysis::Measure>& measures,
                        const std::optional<HapticSurfaceNumbers>& haptic)
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
  if (haptic) tell(json, *haptic);
  return json.dump(2) + '\n';
}

}  // namespace

Result<Done> describeAnatomy(const AnatomyOptions& options)
{
  for (const std::string& file :
       {options.json, options.sections, options.surface, options.hapticSurface})
    if (const auto done = checkPlace(file); !done) return done.error();
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
    if (const auto done = writePart(**scala, patient->label, patient->side, options); !done)
      return done.error();
  std::optional<HapticSurfaceNumbers> haptic;
  if (!options.hapticSurface.empty()) {
    const auto written = writeHapticSurface(**scala, patient->label, patient->side, options);
    if (!written) return written.error();
    haptic = *written;
  }
  if (!options.sections.empty()) {
    // a section every 5 degrees: four between those of the measured cochleae
    const auto rows = analysis::sectionRows(**scala, degrees(5));
    if (const auto done = writeWhole(options.sections, analysis::sectionsCsv(rows)); !done)
      return done.error();
  }
  if (!options.json.empty())
    if (const auto done = writeWhole(options.json, anatomyJson(*patient, measures, haptic)); !done)
      return done.error();

  std::printf("%s, %s ear, published anatomy\n", patient->label.c_str(),
              patient->side == anatomy::Side::left ? "left" : "right");
  for (const analysis::Measure& measure : measures)
    std::printf("%-26s %s\n", measure.key.c_str(), fixed(measure.value, 2).c_str());
  if (haptic)
    std::printf("haptic surface: %d of %d triangles, off by %s mm on average, %s mm at most\n",
                haptic->triangles, haptic->visualTriangles,
                fixed(inMillimeters(haptic->deviation.mean), 3).c_str(),
                fixed(inMillimeters(haptic->deviation.greatest), 3).c_str());
  return Done{};
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "AnatomySurfaces.h"
#include "Commands.h"
#include "JsonText.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

// Source of the sections of every anatomy; the published one uses them as percentages.
constexpr const char* sectionCredit =
    "Sections: mean of 15 scalae tympani, Froehlich et al. 2024, PLOS ONE, doi "
    "10.1371/journal.pone.0295121, CC BY 4.0, adapted.";

/// The cochlea selected by the options.
Result<anatomy::Cochlea> chooseCochlea(const AnatomyOptions& options)
{
  anatomy::Patient patient;
  if (!options.patient.empty()) {
    const auto loaded = readPatient(options.patient);
    if (!loaded) return loaded.error();
    patient = *loaded;
  }
  if (options.stLength_mm) {
    patient.label = "given lengths";
    patient.scalaTympaniLength = millimeters(*options.stLength_mm);
    patient.roundWindowWidth = millimeters(*options.rwWidth_mm);
    patient.roundWindowHeight = millimeters(*options.rwHeight_mm);
  }
  if (options.a_mm) {
    patient.label = "given diameters";
    patient.basalTurn = {millimeters(*options.a_mm), millimeters(*options.b_mm), std::nullopt};
    if (options.h_mm) patient.basalTurn->h = millimeters(*options.h_mm);
  }
  if (options.sample) {
    const auto drawn = anatomy::samplePatient(*options.sample);
    if (!drawn) return drawn.error();
    patient = *drawn;
  }
  anatomy::AnatomySource source = sourceScaledBy(measuresOf(patient));
  if (const auto preset = anatomy::anatomySourceNamed(options.preset)) {
    source = *preset;
    patient.label = options.preset;
  }
  if (const auto done = anatomy::checkPatient(patient); !done) return done.error();
  return anatomy::Cochlea{source, patient};
}

void tell(nlohmann::ordered_json& json, const HapticSurfaceNumbers& haptic)
{
  json["haptic_surface_triangles"] = haptic.triangles;
  json["haptic_surface_visual_triangles"] = haptic.visualTriangles;
  json["haptic_surface_deviation_mean_mm"] = inMillimeters(haptic.surfaceDistance.mean);
  json["haptic_surface_deviation_p95_mm"] = inMillimeters(haptic.surfaceDistance.p95);
  json["haptic_surface_deviation_max_mm"] = inMillimeters(haptic.surfaceDistance.greatest);
}

/// The numbers that the anatomy was built from; null for a measured one.
nlohmann::ordered_json givenNumbers(const anatomy::Cochlea& cochlea)
{
  const anatomy::Patient& patient = cochlea.patient;
  nlohmann::ordered_json given = nlohmann::ordered_json::object();
  if (patient.basalTurn) {
    given["a_mm"] = inMillimeters(patient.basalTurn->a);
    given["b_mm"] = inMillimeters(patient.basalTurn->b);
    if (patient.basalTurn->h) given["h_mm"] = inMillimeters(*patient.basalTurn->h);
    if (const auto& errors = patient.errors) {
      given["a_sd_mm"] = inMillimeters(errors->a);
      given["b_sd_mm"] = inMillimeters(errors->b);
      if (errors->h) given["h_sd_mm"] = inMillimeters(*errors->h);
    }
  } else if (isScaledBy(cochlea.source, patient)) {
    given["st_length_mm"] = inMillimeters(patient.scalaTympaniLength);
    given["rw_width_mm"] = inMillimeters(patient.roundWindowWidth);
    given["rw_height_mm"] = inMillimeters(patient.roundWindowHeight);
  }
  return given;
}

std::string anatomyJson(const anatomy::Cochlea& cochlea,
                        const std::vector<analysis::Measure>& measures,
                        const std::vector<double>& bands,
                        const std::optional<HapticSurfaceNumbers>& haptic)
{
  const anatomy::Patient& patient = cochlea.patient;
  nlohmann::ordered_json json;
  json["build"] = buildId();
  json["label"] = patient.label;
  json["side"] = anatomy::nameOf(patient.side);
  json["anatomy"] = nameOf(cochlea.source);
  json["credit"] = sectionCredit;
  json["given"] = givenNumbers(cochlea);
  if (!noteOn(patient).empty()) json["seal"] = nameOf(patient.seal);
  if (const auto unusual = anatomy::unusualMeasures(patient); !unusual.empty())
    json["unusual"] = unusual;
  for (const analysis::Measure& measure : measures) json[measure.key] = measure.value;
  if (!bands.empty() && !patient.errors)
    json["band_for_measuring_error_mm"] = inMillimeters(analysis::measuringError);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    auto& derived = json["derived"][measures[i].key];
    derived = {{"formula", measures[i].formula}, {"source", measures[i].source}};
    if (!bands.empty()) derived["band"] = bands[i];
  }
  if (haptic) tell(json, *haptic);
  return jsonText(json);
}

}  // namespace

Result<void> describeAnatomy(const AnatomyOptions& options)
{
  if (!options.import.empty()) return describeImport(options);
  const auto cochlea = chooseCochlea(options);
  if (!cochlea) return cochlea.error();
  const anatomy::Patient& patient = cochlea->patient;
  const auto scala = anatomy::buildAnatomy(*cochlea, patient.label);
  if (!scala) return scala.error();
  const auto measures = analysis::measure(**scala, *cochlea);
  const auto bands = analysis::errorBands(*cochlea, measures);
  if (!bands) return bands.error();

  // The surface first, because its file extension may be refused.
  if (!options.surface.empty())
    if (const auto done = writePart(**scala, patient.label, patient.side, options); !done)
      return done.error();
  std::optional<HapticSurfaceNumbers> haptic;
  if (!options.hapticSurface.empty()) {
    const auto written = writeHapticSurface(**scala, patient.label, patient.side, options);
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
    if (const auto done = writeWhole(options.json, anatomyJson(*cochlea, measures, *bands, haptic));
        !done)
      return done.error();

  print("{}, {} ear, {} anatomy\n", patient.label, anatomy::nameOf(patient.side),
        nameOf(cochlea->source));
  print("{}\n", sectionCredit);
  for (const std::string& sentence : anatomy::unusualMeasures(patient)) print("{}\n", sentence);
  for (std::size_t i = 0; i < measures.size(); ++i)
    print("{:28} {}{}\n", measures[i].key, fixed(measures[i].value, 2),
          bands->empty() ? "" : (" ± " + fixed((*bands)[i], 2)));
  if (!bands->empty())
    print(
        "± is the 95 % interval of {}, and of the duct length's formula; the error of the model is "
        "not included.\n",
        patient.errors ? "the errors of A, B and H as measured in the CT"
                       : "an error of " + fixed(inMillimeters(analysis::measuringError), 1) +
                             " mm (standard deviation) in each measurement");
  if (haptic)
    print("haptic surface: {} of {} triangles, mean deviation {} mm, maximum {} mm\n",
          haptic->triangles, haptic->visualTriangles,
          fixed(inMillimeters(haptic->surfaceDistance.mean), 3),
          fixed(inMillimeters(haptic->surfaceDistance.greatest), 3));
  return {};
}

}  // namespace perilymph::cli

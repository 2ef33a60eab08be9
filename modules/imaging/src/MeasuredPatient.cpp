// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MeasuredPatient.h"

#include <cmath>
#include <string>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::imaging {

namespace {

/// To a nanometer, so that intervals of it round to those of the measurement.
Length finely(double value_mm) { return millimeters(1e-6 * std::round(1e6 * value_mm)); }

std::string orUnknown(const std::string& text)
{
  return text.empty() ? "unknown" : onOneLine(text);
}

/// Names of landmarks, those that a person placed or the others.
std::string landmarkNames(const ct::Marks& byHand, bool isByHand)
{
  std::string names;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (byHand.points_P[k].has_value() == isByHand)
      names += (names.empty() ? "" : ", ") + std::string(nameOf(static_cast<ct::Mark>(k)));
  return names;
}

}  // namespace

anatomy::Patient measuredPatient(const ct::CochleaMeasures& measures)
{
  anatomy::Patient patient;
  patient.side = measures.side;
  patient.basalTurn = anatomy::BasalTurn{
      millimeters(measures.a.value), millimeters(measures.b.value), millimeters(measures.h.value)};
  patient.errors = anatomy::BasalTurnErrors{finely(measures.a.sd()), finely(measures.b.sd()),
                                            finely(measures.h.sd())};
  if (!anatomy::checkPatient(patient)) patient.basalTurn->h = patient.errors->h = std::nullopt;
  patient.origin = {"perilymph " + buildId(), measures.provenance.seriesKey,
                    landmarkNames(measures.marksByHand, true),
                    landmarkNames(measures.marksByHand, false)};
  return patient;
}

Result<std::string> measuredPatientText(const ct::CochleaMeasures& measures,
                                        const std::string& label)
{
  if (measures.noFullSpiral())
    return Error{
        "The scala tympani is built with 2.5 turns, which were not seen in this cochlea, so no "
        "patient file is written. Use its measures without the model."};
  anatomy::Patient patient = measuredPatient(measures);
  patient.label = onOneLine(validUtf8(label));
  if (const auto done = anatomy::checkPatient(patient); !done) return done.error();

  std::string flags;
  for (const ct::Flag flag : measures.flags)
    flags += (flags.empty() ? "" : ", ") + std::string(ct::nameOf(flag));
  std::string text =
      "# Measured in a CT, of the bony lumen's outer wall; _sd_mm: standard deviations of "
      "errors.\n";
  text += "# Scanner: " + orUnknown(measures.provenance.scanner) + "\n";
  text += "# Flags: " + (flags.empty() ? "none" : flags) + "\n";
  for (const std::string& note : measures.provenance.notes)
    text += "# Of the CT: " + onOneLine(note) + "\n";
  if (!patient.basalTurn->h)
    text += "# H is " + std::to_string(measures.h.value).substr(0, 5) +
            " mm, beyond what a patient may have.\n";
  return text + anatomy::patientText(patient);
}

Result<Done> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file)
{
  const auto text = measuredPatientText(measures, label);
  if (!text) return text.error();
  return writeWhole(file, *text, {Links::followed, Audience::owner});
}

}  // namespace perilymph::imaging

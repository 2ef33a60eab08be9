// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MeasuredPatient.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Normal.h"
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

/// The height that the patient has [mm].
std::optional<double> usedHeight(const ct::Measure& h)
{
  const anatomy::Spread limits = anatomy::limitsOfH();
  const double nearest = std::clamp(h.value, inMillimeters(limits.low), inMillimeters(limits.high));
  if (std::fabs(h.value - nearest) > halfWidth95 * h.sd()) return std::nullopt;
  return nearest;
}

}  // namespace

std::optional<Sentence> heightNote(const ct::CochleaMeasures& measures)
{
  const auto used = usedHeight(measures.h);
  if (used == measures.h.value) return std::nullopt;
  const anatomy::Spread limits = anatomy::limitsOfH();
  const std::string low = ct::millimetersOf(inMillimeters(limits.low)),
                    high = ct::millimetersOf(inMillimeters(limits.high));
  if (used)
    return Sentence{
        "H is %1 mm, which its error allows to be within %2 to %3 mm, the heights of whole "
        "cochleae: "
        "%4 mm is used.",
        ct::millimetersOf(measures.h.value), low, high, ct::millimetersOf(*used)};
  return Sentence{
      "H is %1 mm, outside %2 to %3 mm, the heights of whole cochleae: it is not used, and plans "
      "draw "
      "H from the population.",
      ct::millimetersOf(measures.h.value), low, high};
}

anatomy::Patient measuredPatient(const ct::CochleaMeasures& measures)
{
  anatomy::Patient patient;
  patient.side = measures.side;
  patient.basalTurn = anatomy::BasalTurn{millimeters(measures.a.value),
                                         millimeters(measures.b.value), std::nullopt};
  const auto height = usedHeight(measures.h);
  if (height) patient.basalTurn->h = millimeters(*height);
  patient.errors = anatomy::BasalTurnErrors{finely(measures.a.sd()), finely(measures.b.sd()),
                                            finely(measures.h.sd())};
  if (!height || !anatomy::checkPatient(patient))
    patient.basalTurn->h = patient.errors->h = std::nullopt;
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
  if (const auto note = heightNote(measures)) text += "# " + *note + "\n";
  return text + anatomy::patientText(patient);
}

Result<void> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file)
{
  const auto text = measuredPatientText(measures, label);
  if (!text) return text.error();
  return writeWhole(file, *text, {Links::followed, Audience::owner});
}

}  // namespace perilymph::imaging

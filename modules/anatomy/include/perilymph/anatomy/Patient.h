// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A patient's cochlea as measured in the clinic: three lengths of the scala tympani, or the
// diameters of the basal turn.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Side of the ear. A left ear is mirrored on input: internally every ear is a right one.
enum class Side { right, left };

inline constexpr std::array sides{Choice<Side>{Side::right, "right"},
                                  Choice<Side>{Side::left, "left"}};
/// "right" or "left", in files.
constexpr const char* nameOf(Side side) { return nameIn(sides, side); }

/// Standard deviations of the errors of A, B and H, and their correlations, as their measurement
/// states them.
struct BasalTurnErrors {
  Length a, b;
  std::optional<Length> h = std::nullopt;
  double ab = 0.0, ah = 0.0, bh = 0.0;  ///< Correlations of the errors, above -1 and below 1.
};

/// How A, B and H were measured in a CT; empty where a patient file does not state it.
struct MeasurementOrigin {
  std::string software;           ///< Name and version.
  std::string seriesKey;          ///< SHA-256 of the series.
  std::string landmarksByHand;    ///< Names of landmarks that a person placed: "RW, A".
  std::string landmarksProposed;  ///< Names of those that the software placed.
};

/// The three parameters of the published anatomy; or A, B and optionally H of the mean anatomy. If
/// `basalTurn` is set, the three lengths are ignored.
struct Patient {
  std::string label = "published";
  Side side = Side::right;
  Length scalaTympaniLength = millimeters(35.58);  ///< Along the organ of Corti.
  Length roundWindowWidth = millimeters(1.94);     ///< Width of the section at the round window.
  Length roundWindowHeight = millimeters(1.85);    ///< Height of the section at the round window.
  std::optional<BasalTurn> basalTurn = std::nullopt;
  std::optional<BasalTurnErrors> errors = std::nullopt;  ///< Errors of `basalTurn`, if known.
  MeasurementOrigin origin = {};                         ///< Origin of `basalTurn`.
  /// State of the file or plan that it was read from: `changed` after the program wrote it, or
  /// `absent`, never sealed, such as a file that a person wrote.
  Seal seal = Seal::intact;
};

/// The CT series in which the measures were taken; empty if they were changed afterward.
std::string statedSeries(const Patient& patient);

/// Whether the measures were taken in a CT: the patient names its series or the software that measured
/// in it, and they were not changed afterward. Others were entered by a person.
bool isFromCt(const Patient& patient);

/// A sentence about measures that were changed by hand, or that name an origin which no seal vouches
/// for; else empty.
Sentence noteOn(const Patient& patient);

/// The same out of a file that keeps it as text; another text as it is.
Sentence storedNote(const std::string& text);

/// Allowed range of a Patient's values.
struct PatientLimits {
  Length lengthLow, lengthHigh, widthLow, widthHigh, heightLow, heightHigh;
};
PatientLimits patientLimits();

/// Reads a patient: keys `label, side`, and either `st_length_mm, rw_width_mm, rw_height_mm` or
/// `a_mm, b_mm` with optional `h_mm`, their errors `a_sd_mm, b_sd_mm, h_sd_mm`, the correlations of
/// these errors `ab_correlation, ah_correlation, bh_correlation` and the origin
/// `measured_with, series_sha256, landmarks_by_hand, landmarks_proposed`. The seal `content_sha256` is
/// over all of these values; comments, spaces and the order of keys are free.
Result<Patient> loadPatient(const std::filesystem::path& file);
/// The same from a text; messages show `name` in place of the file.
Result<Patient> patientIn(const std::string& text, const std::string& name);

/// Text of a patient for loadPatient(), rounded to a picometer, with its seal: none where there was
/// none, and one that does not hold for changed measures, whoever writes them again.
std::string patientText(const Patient& patient);

/// Writes a patient to a file for loadPatient(), rounded to a picometer.
Result<void> savePatient(const Patient& patient, const std::filesystem::path& file);

/// Checks values that did not come from a file (command line, window).
Result<void> checkPatient(const Patient& patient);

/// Checks a code that stands for a patient in files and reports: 1 to 24 letters, digits and
/// hyphens, so that neither needs another spelling of it.
Result<void> checkPatientCode(const std::string& code);

/// A virtual patient with A and B drawn from the population: the same for the same seed on every
/// machine.
Result<Patient> samplePatient(std::uint64_t seed);

/// Virtual patient `number` of a study or prediction, 1 to 1,000,002: seeds of neighboring studies
/// have no patient in common.
Result<Patient> samplePatient(std::uint64_t studySeed, std::uint64_t number);

/// A sentence for each of A and B that is two standard deviations or more from the population mean,
/// for a B that is so far from what A predicts (expectedB()), and for an H outside limitsOfH():
/// allowed, but the measurement should be checked.
std::vector<Sentence> unusualMeasures(const Patient& patient);

/// The published three-parameter scala tympani of a patient, with a straight lead-in before the
/// round window. Takes a few tenths of a second; not real-time safe.
std::shared_ptr<const ScalaTympani> buildPublished(const Patient& patient, Length leadIn);

}  // namespace perilymph::anatomy

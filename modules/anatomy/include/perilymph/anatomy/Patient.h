#pragma once

// A patient's cochlea as the clinic knows it: three lengths of the scala tympani, or the diameters
// of the basal turn.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Which ear. A left ear is mirrored at the door: inside, every ear is a right one.
enum class Side { right, left };

/// The paper's three numbers, from which the published anatomy is built; or A, B and perhaps H,
/// from which the mean anatomy is. With a `basalTurn` the three lengths say nothing.
struct Patient {
  std::string label = "published";
  Side side = Side::right;
  Length scalaTympaniLength = millimeters(35.58);  ///< Along the organ-of-Corti path.
  Length roundWindowWidth =
      millimeters(1.94);  ///< Width of the scala's section at the round window.
  Length roundWindowHeight = millimeters(1.85);  ///< Height of the same section.
  std::optional<BasalTurn> basalTurn = std::nullopt;
};

/// The least and the greatest value that a Patient's number may have.
struct PatientLimits {
  Length lengthLow, lengthHigh, widthLow, widthHigh, heightLow, heightHigh;
};
PatientLimits patientLimits();

/// Reads a patient: keys `label, side`, and either `st_length_mm, rw_width_mm, rw_height_mm` or
/// `a_mm, b_mm` with or without `h_mm`.
Result<Patient> loadPatient(const std::filesystem::path& file);

/// Writes a patient to a file that loadPatient() reads back, to a picometer.
Result<Done> savePatient(const Patient& patient, const std::filesystem::path& file);

/// Checks numbers that did not come from a file (command line, window).
Result<Done> checkPatient(const Patient& patient);

/// A virtual patient whose A and B are drawn from the population: the same for the same seed on
/// every machine.
Result<Patient> samplePatient(std::uint64_t seed);

/// A sentence for each of A and B that lies more than two standard deviations from the population's
/// mean, and for an H outside limitsOfH(): allowed, but worth a second look at the measurement.
std::vector<std::string> unusualMeasures(const Patient& patient);

/// The published three-parameter scala tympani of a patient, with a straight lead-in before the
/// round window. Takes some tenths of a second; not real-time safe.
std::shared_ptr<const ScalaTympani> buildPublished(const Patient& patient, Length leadIn);

}  // namespace perilymph::anatomy

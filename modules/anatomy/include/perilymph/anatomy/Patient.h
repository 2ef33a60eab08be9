#pragma once

// A patient's cochlea as the clinic knows it: three lengths from CT.

#include <filesystem>
#include <memory>
#include <string>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Which ear. A left ear is mirrored at the door: inside, every ear is a right one.
enum class Side { right, left };

/// The paper's three numbers.
struct Patient {
  std::string label = "published";
  Side side = Side::right;
  Length scalaTympaniLength = millimeters(35.58);  ///< Along the organ-of-Corti path.
  Length roundWindowWidth = millimeters(1.94);     ///< Of the scala's section at the round window.
  Length roundWindowHeight = millimeters(1.85);    ///< Of the same section.
};

/// The least and the greatest value that a Patient's number may have.
struct PatientLimits {
  Length lengthLow, lengthHigh, widthLow, widthHigh, heightLow, heightHigh;
};
PatientLimits patientLimits();

/// Reads a patient: keys `label, side, st_length_mm, rw_width_mm, rw_height_mm`.
Result<Patient> loadPatient(const std::filesystem::path& file);

/// Checks numbers that did not come from a file (command line, window).
Result<Done> checkPatient(const Patient& patient);

/// The published three-parameter scala tympani of a patient, with a straight lead-in before the
/// round window. Takes milliseconds; not real-time safe.
std::shared_ptr<const ScalaTympani> buildPublished(const Patient& patient, Length leadIn);

}  // namespace perilymph::anatomy

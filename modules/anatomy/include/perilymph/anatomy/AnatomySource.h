// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sources of anatomies. One table, used by all programs, contains their names, titles, the patient
// measures that scale them and their builders.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Source of a scala tympani's shape: the published experiment's three-parameter model, the mean of
/// 15 measured cochleae, or Clark's spiral.
enum class AnatomySource : std::uint8_t { published, mean, clark };

/// The anatomy of a scenario that names neither an anatomy nor a patient.
inline constexpr AnatomySource defaultAnatomy = AnatomySource::mean;

/// Kinds of patient measures.
enum class PatientMeasures : std::uint8_t {
  none,
  threeLengths,  ///< Length, width and height of the scala tympani.
  basalTurn      ///< A, B and optionally H.
};

/// Row of the table of sources.
struct AnatomySourceTraits {
  using Build = Result<std::shared_ptr<const ScalaTympani>> (*)(const Patient& patient,
                                                                Length leadIn);
  AnatomySource source;
  const char* name;          ///< In files and on the command line.
  const char* title;         ///< For display, in English.
  PatientMeasures takes;     ///< Measures of a patient that scale it.
  bool alwaysTakes = false;  ///< Also scaled by a Patient's default lengths, because it has no
                             ///< other shape.
  Build build = nullptr;     ///< May throw std::invalid_argument. Not real-time safe.
};

/// All sources, in the order in which programs list them.
std::span<const AnatomySourceTraits> anatomySources();

/// The row of a source.
const AnatomySourceTraits& traitsOf(AnatomySource source);

/// Name of a source in files and on the command line.
const char* nameOf(AnatomySource source);

/// The source with a name; empty if there is none.
std::optional<AnatomySource> anatomySourceNamed(std::string_view name);

/// Names of all sources.
std::vector<std::string> anatomySourceNames();

/// Measures of a patient: A and B if known, otherwise three lengths.
PatientMeasures measuresOf(const Patient& patient);

/// Keys of measures in a patient's file, for a message: "a_mm and b_mm".
const char* keysOf(PatientMeasures measures);

/// The source that is scaled by a kind of measures.
AnatomySource sourceScaledBy(PatientMeasures measures);

/// Whether an anatomy is scaled by a patient's measures and therefore patient-specific.
bool isScaledBy(AnatomySource source, const Patient& patient);

/// A cochlea to build.
struct Cochlea {
  AnatomySource source = AnatomySource::published;
  Patient patient;
  Length leadIn = millimeters(1);  ///< Straight length before the round window.
};

/// Builds the scala tympani of a cochlea. Takes some tenths of a second; not real-time safe.
///
/// @param name  Name of the cochlea in error messages.
Result<std::shared_ptr<const ScalaTympani>> buildAnatomy(const Cochlea& cochlea,
                                                         const std::string& name);

}  // namespace perilymph::anatomy

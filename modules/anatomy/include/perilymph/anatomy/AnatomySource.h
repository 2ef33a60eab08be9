#pragma once

// Sources of anatomies: what a scala tympani is built from. One table holds their names, titles,
// the patient's measures they are scaled by and their builders; every program asks it.

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

/// Kinds of measures by which a patient is known.
enum class PatientMeasures : std::uint8_t {
  none,
  threeLengths,  ///< Length, width and height of the scala tympani.
  basalTurn      ///< A, B and perhaps H.
};

/// Row of the table of sources.
struct AnatomySourceTraits {
  using Build = Result<std::shared_ptr<const ScalaTympani>> (*)(const Patient& patient,
                                                                Length leadIn);
  AnatomySource source;
  const char* name;          ///< In files and on the command line.
  const char* title;         ///< For people, English.
  PatientMeasures takes;     ///< Measures of a patient that scale it.
  bool alwaysTakes = false;  ///< A Patient's default lengths scale it, too: it has no other shape.
  Build build = nullptr;     ///< May throw std::invalid_argument. Not real-time safe.
};

/// Every source, in the order in which programs list them.
std::span<const AnatomySourceTraits> anatomySources();

/// The row of a source.
const AnatomySourceTraits& traitsOf(AnatomySource source);

/// Name of a source in files and on the command line.
const char* nameOf(AnatomySource source);

/// The source of a name; nothing if there is none.
std::optional<AnatomySource> anatomySourceNamed(std::string_view name);

/// Names of all sources.
std::vector<std::string> anatomySourceNames();

/// Measures that a patient has: A and B where they are known, otherwise three lengths.
PatientMeasures measuresOf(const Patient& patient);

/// Keys of measures in a patient's file, for a sentence: "a_mm and b_mm".
const char* keysOf(PatientMeasures measures);

/// The source that is scaled by a kind of measures.
AnatomySource sourceScaledBy(PatientMeasures measures);

/// Whether an anatomy is scaled by a patient's measures, so that it is this patient's.
bool isScaledBy(AnatomySource source, const Patient& patient);

/// A cochlea to build.
struct Cochlea {
  AnatomySource source = AnatomySource::published;
  Patient patient;
  Length leadIn = millimeters(1);  ///< Straight stretch before the round window.
};

/// Builds the scala tympani of a cochlea. Takes some tenths of a second; not real-time safe.
///
/// @param name  Name of the cochlea in a refusal.
Result<std::shared_ptr<const ScalaTympani>> buildAnatomy(const Cochlea& cochlea,
                                                         const std::string& name);

}  // namespace perilymph::anatomy

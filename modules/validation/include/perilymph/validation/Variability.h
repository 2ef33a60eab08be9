// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Variation between the insertions of an experiment, as data with sources, and the drawing of one
// insertion.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/analysis/ExperimentDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::validation {

/// A source of variation between insertions.
enum class SpreadSource : std::uint32_t { start, alignment, motion, curvature, friction, noise };

inline constexpr std::array<SpreadSource, 6> allSpreadSources = {
    SpreadSource::start,     SpreadSource::alignment, SpreadSource::motion,
    SpreadSource::curvature, SpreadSource::friction,  SpreadSource::noise};

/// "start", "alignment", "motion", "curvature", "friction", "noise".
const char* spreadSourceName(SpreadSource source) noexcept;

/// The set of active sources; one bit each.
class SpreadSources {
public:
  static SpreadSources all();
  static SpreadSources none() { return {}; }
  static SpreadSources only(SpreadSource source);

  bool has(SpreadSource source) const noexcept;

private:
  std::uint32_t bits_ = 0;
};

/// Variability of an experiment.
struct Variability {
  std::string label;
  std::string scenario;   ///< The nominal scenario.
  Duration samplePeriod;  ///< Between force samples.
  Duration timeStep;      ///< Time step of the mechanics; the sample period is a multiple of it.
  Length startLow, startHigh;          ///< Initial depth of the tip past the opening: uniform.
  Angle tiltDeviation, turnDeviation;  ///< Standard deviations of the approach: normal.
  double speedDeviation = 0.0;         ///< Fraction of the speed: normal.
  double tremorFrequency = 0.0;        ///< [Hz]
  Length tremorAmplitude;              ///< Along each of three axes, phases uniform.
  /// Deviation of the fraction of free curvature that remains with the stylet in: normal about the
  /// array's value, negative if carrier or stylet are bent the opposite way.
  double curvatureDeviation = 0.0;
  double frictionDeviation = 0.0;  ///< Fraction of all coefficients: log-normal, mean preserved.
  Force noiseDeviation;            ///< Standard deviation of one force sample: normal.
  Length knotSpacing;              ///< Approximate spacing of the spline's knots.
  std::vector<std::pair<std::string, std::string>> provenance;  ///< For each table of the file.
};

/// Reads a variability from its TOML file.
Result<Variability> loadVariability(const std::filesystem::path& file);

/// One drawn insertion: its model and the motion of the hand.
struct DrawnInsertion {
  session::InsertionParameters parameters;  ///< Start, approach, array and friction as drawn.
  analysis::TremblingPush push;             ///< The motion of the crosshead.
  double noiseDeviation = 0.0;              ///< [N]
  std::uint64_t seed = 0, number = 0;       ///< Seed of its noise.
};

/// Insertion `number` of a study. An inactive source leaves the scenario's value; an active one
/// draws the same numbers whichever other sources are active.
DrawnInsertion drawInsertion(const session::InsertionParameters& nominal,
                             const Variability& variability, SpreadSources sources,
                             std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::validation

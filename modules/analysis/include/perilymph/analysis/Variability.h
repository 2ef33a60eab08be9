#pragma once

// What differs from one insertion of an experiment to the next, as data with its sources, and one
// insertion drawn from it.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {

/// One reason why two insertions differ.
enum class SpreadSource : std::uint32_t { start, alignment, motion, curvature, friction, noise };

inline constexpr std::array<SpreadSource, 6> allSpreadSources = {
    SpreadSource::start,     SpreadSource::alignment, SpreadSource::motion,
    SpreadSource::curvature, SpreadSource::friction,  SpreadSource::noise};

/// "start", "alignment", "motion", "curvature", "friction", "noise".
const char* spreadSourceName(SpreadSource source) noexcept;

/// Which sources act; one bit each.
class SpreadSources {
public:
  static SpreadSources all();
  static SpreadSources none() { return {}; }
  static SpreadSources only(SpreadSource source);

  bool has(SpreadSource source) const noexcept;

private:
  std::uint32_t bits_ = 0;
};

/// How an experiment varied.
struct Variability {
  std::string label;
  std::string scenario;   ///< Whose insertions vary.
  Duration samplePeriod;  ///< Between force samples.
  Duration timeStep;      ///< Time step of the mechanics; a sample's period is a multiple of it.
  Length startLow, startHigh;          ///< Start depth of the tip inside the opening: uniform.
  Angle tiltDeviation, turnDeviation;  ///< Standard deviations of the approach: normal.
  double speedDeviation = 0.0;         ///< Share of the speed: normal.
  double tremorFrequency = 0.0;        ///< [Hz]
  Length tremorAmplitude;              ///< Along each of three axes, phases uniform.
  /// Share of the free curvature that is left with the stylet in: normal about the array's value,
  /// negative where carrier or stylet are bent the other way.
  double curvatureDeviation = 0.0;
  double frictionDeviation = 0.0;  ///< Share of all coefficients: log-normal, mean kept.
  Force noiseDeviation;            ///< Standard deviation of one force sample: normal.
  Length knotSpacing;              ///< Between the knots of the spline, nearly.
  std::vector<std::pair<std::string, std::string>> provenance;  ///< Per table of the file.
};

/// Reads how an experiment varied from its TOML file.
Result<Variability> loadVariability(const std::filesystem::path& file);

/// One insertion of many: what the model is built from and how the hand moves.
struct DrawnInsertion {
  session::Scenario scenario;           ///< Start, approach, array and friction as drawn.
  double speed = 0.0;                   ///< Speed of the hand [m/s].
  double tremorAmplitude = 0.0;         ///< [m]
  double tremorFrequency = 0.0;         ///< [Hz]
  std::array<double, 3> tremorPhase{};  ///< Phase along D's axes [rad].
  double noiseDeviation = 0.0;          ///< [N]
  std::uint64_t seed = 0, number = 0;   ///< Where its noise comes from.
};

/// Insertion `number` of a study. A source that does not act leaves the scenario's own value; one
/// that acts draws the same numbers whichever others act.
DrawnInsertion drawInsertion(const session::Scenario& nominal, const Variability& variability,
                             SpreadSources sources, std::uint64_t seed, std::uint64_t number);

}  // namespace perilymph::analysis

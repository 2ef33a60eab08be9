// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The resistance in one clinic, friction, stiffness and hand together, as its outcomes tell: a distribution
// of two shifts, by which the simulations of a plan are weighted. It moves depth only.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/planning/UnstoppedDraws.h"

namespace perilymph::planning {

/// The grid of both shifts: f, of the logarithm of friction, and g, of the logarithm of the force at
/// which surgeons stop; each over three standard deviations of its prior on both sides.
inline constexpr std::size_t frictionShifts = 41, stopShifts = 21;
/// Standard deviations of the prior of f and g. f: what all ears share in the shipped friction
/// (resources/friction/estimate-from-pig-tissue.toml: 0.20 and 0.20); g: choice, low.
inline constexpr double frictionShiftSd = 0.28, stopShiftSd = 0.25;
/// Standard deviation of ln friction between ears, which no outcomes narrow (the same file), and of the
/// kernel that smooths a few simulations (choice, medium).
inline constexpr double earFrictionSd = 0.20, kernelSd = 0.10;
/// The shift at a place of the grid.
double frictionShift(std::size_t place);
double stopShift(std::size_t place);

/// Probability that a standard normal value lies below a deviate; 0 and 1 at infinity.
double normalBelow(double deviate);

/// Probabilities on the grid, by f, then by g: place f * stopShifts + g. Their sum is 1.
using ResistanceCells = std::array<double, frictionShifts * stopShifts>;
/// Both normal, independent.
ResistanceCells resistancePrior();

/// One simulation of a plan as a clinic's resistance needs it.
struct StopDraw {
  double logFriction = 0.0;  ///< u, logarithm of the factor of its friction.
  double intended_mm = 0.0;  ///< Depth at which its surgeon means to stop.
  double end_mm = 0.0;       ///< Depth at which its push without a stop ended.
  bool isFull = true;        ///< There the array is in fully; else it buckled, folded or jammed.
  /// Depth at which the force reaches F e^g, F its surgeon's limit; infinite where it does not.
  std::array<double, stopShifts> stop_mm{};

  /// Depth at which its surgeon stops with a place of g: of the three depths the least.
  double depth_mm(std::size_t stopShift) const;
};
StopDraw stopDrawOf(const UnstoppedDraw& draw);

/// Simulations of a plan with the spread from which u was drawn.
struct StopDraws {
  std::vector<StopDraw> draws;
  double logFrictionSd = 0.0;  ///< Standard deviation of u: Plan::frictionSpread.
};

/// Weights of the simulations at a place of f; their sum is 1. u was drawn from N(0, s^2); wanted is
///
///     kappa_k(f) = N(u_k; f, 0.20^2 + 0.10^2),   w_k ~ kappa_k(f) / N(u_k; 0, s^2)
std::vector<double> frictionWeights(const StopDraws& draws, std::size_t frictionShift);

/// Weighted simulations over all cells.
struct WeightedDepths {
  std::vector<std::pair<double, double>>
      depths_mm;           ///< Depth and weight, ascending; weights sum to 1.
  double effective = 0.0;  ///< Effective number of simulations: 1 / sum w_k^2 (Kish 1965).

  /// Probability of a lesser depth, where the depth is measured with an error; of a further value, as the
  /// quantile i / (n + 1) of n sorted ones.
  double percentile(double depth_mm, double sd_mm) const;
  /// Quantiles of a further depth without an error.
  Band band() const;
};
WeightedDepths depthsIn(const ResistanceCells& cells, const StopDraws& draws);

/// Effective number of simulations from which on a band is given.
inline constexpr double fewestEffective = 100.0;

/// What a file of a clinic's resistance holds: no code, and no date but years.
struct ClinicResistance {
  ResistanceCells cells{};
  double friction = 0.0;  ///< Coefficient, static, from which f counts.
  std::size_t resisted = 0, censored = 0, uninformative = 0;  ///< Outcomes by what they tell.
  double logScore = 0.0;  ///< Sum of ln p with the clinic's minus with the shipped resistance.
  int firstYear = 0, lastYear = 0;
  std::string number = {};  ///< SHA-256 of the file as read.
};

/// The text of the file, with its seal.
std::string clinicResistanceText(const ClinicResistance& clinic);
/// Reads a file. Refuses what was changed by hand, what is no such file, and probabilities that are none.
Result<ClinicResistance> loadClinicResistance(const std::filesystem::path& file);
/// The same from a text.
Result<ClinicResistance> clinicResistanceIn(const std::string& text, const std::string& name);

}  // namespace perilymph::planning

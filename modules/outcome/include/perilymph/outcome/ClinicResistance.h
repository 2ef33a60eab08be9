// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the outcomes of a clinic tell about its resistance: friction, stiffness and hand together.

#include <cstddef>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/outcome/Surgery.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::outcome {

/// What the end of an insertion tells about resistance.
enum class Evidence {
  none,      ///< Nothing: reason unknown, buckled, several attempts, folded, translocated, other.
  resisted,  ///< The force reached the surgeon's limit at this length.
  censored,  ///< It had not reached it there: mark, hearing, bleeding.
};
/// @param isDisplaced  The array is folded or translocated.
Evidence evidenceOf(const Surgery& surgery, bool isDisplaced);

/// The inserted length of one patient beside the simulations of his plan.
struct InsertedLength {
  Evidence evidence = Evidence::none;
  double length_mm = 0.0, sd_mm = 0.0;  ///< Tip past the opening; error of the CT.
  double insertable_mm = 0.0;           ///< Greatest length of the array.
  int year = 0;
};

/// Standard deviation of what model and cochlea leave open in a length [mm] (choice, medium), beside the CT's error.
inline constexpr double modelSd_mm = 0.7;
/// Share of the likelihood of a felt resistance that is uniform over the insertable length: wrong reasons
/// (choice, medium).
inline constexpr double strayShare = 0.05;
/// Exponent of each likelihood, against a wrong model (choice, medium).
inline constexpr double tempering = 0.5;

/// Likelihood of a length on the grid, not tempered. With s^2 = sd^2 + 0.7^2, w_k(f) of
/// planning::frictionWeights() and L_k(g) the depth at which simulation k reaches F_k e^g:
///
///     resisted:  0.95 sum_k w_k(f) phi((l - L_k(g)) / s) / s + 0.05 / l_insertable
///     censored:  sum_k w_k(f) Phi((L_k(g) - l) / s)
///     none:      1
///
/// Never below 1e-6, so that an outcome that no simulation explains leaves the posterior finite.
planning::ResistanceCells likelihoodOf(const InsertedLength& inserted,
                                       const planning::StopDraws& draws);

/// One patient, scored by what was known before his surgery.
struct ResistanceScore {
  double logClinic = 0.0, logShipped = 0.0;  ///< ln p of the length; both 0 if it tells nothing.
  double percentile = 0.0;                   ///< The length among the clinic's depths, 0 to 1.
  double shippedPercentile = 0.0;            ///< In those of the prior.
  bool isOffered = false;  ///< Whether the clinic's resistance was offered before.
};

/// The posterior of a clinic after some patients.
class ResistancePosterior {
public:
  ResistancePosterior();

  /// Scores a patient and then learns from the length. Patients are taken in the order of surgery.
  ResistanceScore add(const InsertedLength& inserted, const planning::StopDraws& draws);

  /// Probabilities on the grid.
  const planning::ResistanceCells& cells() const noexcept { return cells_; }
  /// Mean of f and of g.
  double meanFrictionShift() const;
  double meanStopShift() const;
  /// Offered from five lengths that ended by resistance and a sum of ln p_clinic - ln p_shipped of 3 on
  /// (choices, medium).
  bool isOffered() const noexcept;
  std::size_t count(Evidence evidence) const noexcept;
  double logScore() const noexcept { return logScore_; }
  /// What its file holds.
  ///
  /// @param friction  Static coefficient from which f counts.
  planning::ClinicResistance resistance(double friction) const;

private:
  planning::ResistanceCells cells_, prior_;
  std::size_t resisted_ = 0, censored_ = 0, uninformative_ = 0;
  double logScore_ = 0.0;
  int firstYear_ = 0, lastYear_ = 0;
};

/// Lengths that have to have ended by resistance, and the gain in ln p, before a clinic's resistance is offered.
inline constexpr std::size_t fewestResisted = 5;
inline constexpr double minGain = 3.0;

/// Shift of a clinic's angles against those of the model at the same depth, N(0, 20 degrees) before any
/// was measured: landmarks and shapes. It tells nothing about resistance.
struct AngleOffset {
  double mean_deg = 0.0, sd_deg = 20.0;

  /// Learns from the difference of a measured angle and the simulations' at the measured length.
  void add(double difference_deg, double sd_deg);
};

}  // namespace perilymph::outcome

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Virtual clinics: patients whose insertions are known, planned by simulations that know neither their
// cochlea nor their friction. A pool of pushes without a stop is made once; clinics are put together of it.

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/outcome/ClinicResistance.h"

namespace perilymph::test {

/// How many patients the pool has, simulations of each plan, and true pushes of each patient.
struct PoolSize {
  std::size_t patients = 0, draws = 0, truths = 0;
};

/// One true push: in the true cochlea, with a hand, approach and stiffness of its own.
struct TruePush {
  double logFriction =
      0.0;  ///< Logarithm of the factor of its friction: equally spaced over -1.1 to 1.1.
  std::vector<double> rise_mN, rise_mm;  ///< The stop curve.
  double end_mm = 0.0;
  bool isFull = true;

  /// Depth at which the force reaches a limit; infinite where it does not.
  double stop_mm(double limit_mN) const;
};

/// A patient of the pool.
struct PoolPatient {
  planning::StopDraws plan;
  std::vector<TruePush> truths;       ///< With the stiffness as drawn.
  std::vector<TruePush> stiffTruths;  ///< 1.5 times as stiff.
};

/// FLEX28 in cochleae of another family than the plans' (TruePatient.h), 40 nodes and 10 ms.
struct Pool {
  std::vector<PoolPatient> patients;
  double allInside_mm = 0.0, insertable_mm = 0.0;  ///< Range of the intended depth.
  double stopLow_mN = 0.0, stopHigh_mN = 0.0;      ///< Range of the surgeons' limits.
};
Result<Pool> makePool(const PoolSize& size);

/// What is wrong in a world.
enum class World {
  right,
  reasonsMissing,  ///< Half of the stop reasons are not known.
  stiffer,         ///< True arrays are 1.5 times as stiff as simulated.
  lengthsOff,      ///< Measured lengths are 1.5 mm too long.
  stopAt120,       ///< Every surgeon stops at 120 mN.
};

/// Results of a clinic's patients, each scored by what was known before his surgery.
struct ClinicRun {
  double frictionShift = 0.0, stopShift = 0.0;  ///< True ones.
  std::vector<outcome::ResistanceScore> scores;
  double meanFrictionShift = 0.0, meanStopShift = 0.0;  ///< Means of the posterior at the end.
  std::size_t resisted = 0, censored = 0, uninformative = 0;
  bool isOffered = false;  ///< At the end.
};

/// Clinic `number` of a seed: f and g of its own, normal as their priors; each patient one of the pool, a
/// true push of his by the density of a friction between ears, a surgeon's limit and an intended depth.
ClinicRun runClinic(const Pool& pool, World world, std::size_t patients, std::uint64_t seed,
                    std::uint64_t number);

}  // namespace perilymph::test

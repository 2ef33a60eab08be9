#pragma once

// One insertion of an experiment, measured as the load cell does: a force every 50 ms.

#include <atomic>
#include <memory>
#include <vector>

#include "perilymph/analysis/Variability.h"
#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::analysis {

/// What the load cell and the crosshead wrote down.
struct MeasuredInsertion {
  /// Crosshead travel since it began to move [m], as experiments measure it. It differs from the
  /// tip's travel where the array bends before the opening.
  std::vector<double> travel;
  std::vector<double> depth;  ///< Past the opening [m].
  std::vector<double> force;  ///< Axial on the hand, with the cell's noise [N].
  std::uint64_t ticks = 0;
  std::uint64_t ticksNotConverged = 0;
};

/// Runs a drawn insertion to a travel in virtual time and samples its force.
///
/// @param anatomy  The cochlea of its scenario, shared between insertions.
/// @param stop     Travel at which it ends.
/// @param isAsked  Ends it early, with an error, once true.
Result<MeasuredInsertion> measure(const DrawnInsertion& drawn,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  Duration samplePeriod, Length stop,
                                  const std::atomic<bool>& isAsked);

}  // namespace perilymph::analysis

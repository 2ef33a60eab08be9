// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What drawn inputs mean for the repeated experiment.

#include "perilymph/session/InsertionParameters.h"
#include "perilymph/validation/PriorPredictive.h"

namespace perilymph::validation {

/// An input's value among a repetition's.
inline double valueOf(const InputValues& values, Input input)
{
  return values[static_cast<std::size_t>(input)];
}

/// The nominal insertion with drawn inputs; the array unscaled.
session::InsertionParameters withInputs(const session::InsertionParameters& nominal,
                                        const InputValues& inputs);

/// The variability between insertions with the drawn starts and knots.
Variability withInputs(const Variability& variability, const InputValues& inputs);

/// A record up to a travel, and the samples of a rest there: the force relaxes from its value at the
/// end, exponentially with the time constant relaxationTime.
///
/// @param travel, force  Samples of the crosshead, which continues; cut at `end`.
struct StoppedRecord {
  std::vector<double> travel, force;
};
inline constexpr Duration relaxationTime = milliseconds(500);
StoppedRecord stoppedRecord(const std::vector<double>& travel, const std::vector<double>& force,
                            Length end, Duration rest, double relaxation, Duration samplePeriod);

}  // namespace perilymph::validation

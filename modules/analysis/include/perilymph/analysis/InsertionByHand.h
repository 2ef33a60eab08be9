// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion by a drawn surgeon, in virtual time.

#include <memory>
#include <stop_token>

#include "perilymph/analysis/ClinicalPrediction.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::analysis {

/// Pushes an array until it is fully in, or its force reaches the surgeon's limit, or
/// the array buckles or slips out; then the hand rests, still trembling, while the force relaxes.
///
/// @param nominal         The scenario's; the surgeon replaces speed, friction and free length.
/// @param profileSpacing  Between points of the force profile; 0: no profile.
/// @param stop            Ends it early; the result is then meaningless.
/// @param shape           Receives the array at the end, for a view; may be null.
ClinicalInsertion insertByHand(const session::InsertionParameters& nominal,
                               std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                               const HandDistribution& hand, const Surgeon& surgeon,
                               Length profileSpacing, const std::stop_token& stop,
                               haptics::Snapshot* shape = nullptr);

}  // namespace perilymph::analysis

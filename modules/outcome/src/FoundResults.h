// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From fitted positions to angles, distances, frequencies, probabilities and flags.

#include "EarFrame.h"
#include "Refinement.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

/// What the search noticed.
struct FoundEvidence {
  bool isSeenSingly = true;
  std::vector<bool> isSeen;  ///< For each contact.
  int unexplained = 0;       ///< Bright places that no contact explains.
  double shiftMargin =
      0.0;  ///< Cost of the best fit with other numbers of the contacts above the best.
  bool isSecondNear = false, areMissing = false, areManyMissing = false, isCoarse = false;
};

Result<FoundArray> resultsOf(const ct::CtVolume& volume, const Ear& ear, const EarFrame& frame,
                             const ContactsRequest& request, const FittedChain& chain,
                             const std::vector<bool>& isFixed, const FoundEvidence& evidence);

}  // namespace perilymph::outcome

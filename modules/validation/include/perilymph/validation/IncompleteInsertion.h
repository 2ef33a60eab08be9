// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Insertions of a study that end before full travel: how, and how many.

#include <cstdint>
#include <string>
#include <vector>

#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::validation {

/// An insertion that did not reach its stop.
struct IncompleteInsertion {
  std::uint64_t number = 0;  ///< In its study, from 1.
  haptics::InsertionEnd end = haptics::InsertionEnd::fault;
  double maxDepth = 0.0;   ///< Maximum depth of the tip past the opening [m].
  double crosshead = 0.0;  ///< Travel of the crosshead at the end [m].
  double maxForce = 0.0;   ///< Maximum axial force on the hand [N].
  std::string fault;       ///< The engine's message; empty unless it stopped the insertion.
};

/// "198 of 200 insertions reached the end; 2 buckled in front of the opening (numbers 25 and 30)."
Sentence completionSentence(int runs, const std::vector<IncompleteInsertion>& incomplete);

}  // namespace perilymph::validation

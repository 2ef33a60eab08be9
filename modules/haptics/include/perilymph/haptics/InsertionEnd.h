// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How an insertion ended: the one table of names for programs, files and the window.

#include <array>
#include <cstdint>
#include <string>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {

/// How an insertion ended.
enum class InsertionEnd : std::uint32_t {
  none,                 ///< It has not ended.
  finished,             ///< The stop travel is reached.
  stoppedByResistance,  ///< The axial force reached the surgeon's limit.
  buckled,              ///< The array folded between the tweezers and the opening.
  outOfOpening,         ///< The tip slipped out of the opening, or missed it.
  foldedTip,            ///< The tip points back along the scala.
  jammed,               ///< The force exceeded 2 N, or the tip no longer advanced.
  fault,                ///< The engine stopped it: device lost, or values not finite.
  refused,              ///< It could not be prepared.
};

/// The ends that are events of a tick, with their bits of TickOutput::status.
inline constexpr std::array<std::pair<InsertionEnd, Status>, 5> endEvents = {
    {{InsertionEnd::stoppedByResistance, endedByResistance},
     {InsertionEnd::buckled, endedBuckled},
     {InsertionEnd::outOfOpening, endedOutOfOpening},
     {InsertionEnd::foldedTip, endedFoldedTip},
     {InsertionEnd::jammed, endedJammed}}};

/// Status bits of all ends.
inline constexpr std::uint32_t anyEnd =
    endedByResistance | endedBuckled | endedOutOfOpening | endedFoldedTip | endedJammed;

/// The status bit of an end; 0 if it has none.
std::uint32_t bitOf(InsertionEnd end) noexcept;

/// How the insertion of this tick ended; the first event counts, whatever follows.
InsertionEnd endOf(const TickOutput& now) noexcept;

/// The name in files and tables: "finished", "stopped_by_resistance", "buckled", "out_of_opening",
/// "folded_tip", "jammed", "fault", "refused"; "none" if it has not ended.
const char* nameOf(InsertionEnd end) noexcept;

/// The end with a name; none for any other text. Names of version 0.1 ("slipped out") are known.
InsertionEnd endNamed(const std::string& name) noexcept;

/// What happened, as a clause without a subject: "buckled in front of the opening".
const char* clauseOf(InsertionEnd end) noexcept;

}  // namespace perilymph::haptics

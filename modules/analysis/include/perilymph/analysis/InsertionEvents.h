// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Events of an insertion, in the order of time, and the forces of marker ribs at the opening.

#include <cstdint>
#include <optional>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Sentence.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::analysis {

enum class EventKind : std::uint8_t {
  firstResistance,   ///< The force first reaches that which surgeons detect in the median.
  ribAtOpening,      ///< The middle of a marker rib reaches the opening.
  styletWithdrawal,  ///< The stylet begins to move back.
  rupture,           ///< The cochlear partition ruptures.
  translocation,     ///< A part of the array is above the partition.
  peak,              ///< The largest axial force.
  resistance,        ///< The insertion ends by the force at which the surgeon stops.
  buckled,           ///< The insertion ends, as the following.
  outOfOpening,
  foldedTip,
  jammed,
  end,         ///< The insertion ends at its stop travel.
  withdrawal,  ///< The hand withdraws the array after the end.
};

/// One event.
struct InsertionEvent {
  EventKind kind = EventKind::end;
  int number = 0;           ///< Rib from the tip: 1, 2, ...; else 0.
  std::uint64_t place = 0;  ///< Index of the tick in the recording.
  double time = 0.0;        ///< Since the first motion [s].
  double travel = 0.0;      ///< [m]
  double depth = 0.0;       ///< Depth of the tip past the opening [m].
  double angle = 0.0;       ///< Angle of the tip from the round window [rad].
  double force = 0.0;       ///< Axial, on the hand [N].
};

/// Stable name for files: "rupture", "rib_at_opening".
const char* nameOf(EventKind kind);
/// For display: "rupture of the partition", "rib 1 at the opening".
Sentence textOf(const InsertionEvent& event);

/// Finds the events of an insertion in its ticks, or in samples of them.
class EventFinder {
public:
  /// @param felt  The force that surgeons detect [N]; 0: unknown.
  EventFinder(const electrode::ArrayDesign& array, double felt);

  /// The next tick, in order.
  ///
  /// @param peak  The peak so far, with the ticks that were left out since the last one.
  void add(std::uint64_t place, const haptics::TickOutput& now, const haptics::PeakForce& peak);

  /// The events so far, in the order of time.
  std::vector<InsertionEvent> events() const;

private:
  void note(EventKind kind, std::uint64_t place, const haptics::TickOutput& now, int number = 0);

  std::vector<double> ribs_;  ///< Distances from the tip, ascending [m].
  double felt_;
  std::vector<InsertionEvent> events_;
  std::optional<InsertionEvent> peak_;
  std::optional<haptics::TickOutput> before_;
  std::size_t nextRib_ = 0;
  bool hasResistance_ = false, hasEnded_ = false, isWithdrawn_ = false;
};

/// Distance of a rib's middle from the opening, or from the ends of its passage, in which a force is the
/// rib's. The range in which the validation reads the raw force at the first rib.
constexpr Length ribReach() { return millimeters(0.5); }

/// A maximum of the axial force.
struct ForceAtDepth {
  double force = 0.0;   ///< [N]
  double travel = 0.0;  ///< [m]
  double depth = 0.0;   ///< Depth of the tip past the opening [m].
  double angle = 0.0;   ///< Angle of the tip from the round window [rad].
};

/// Separates the peak while a marker rib passes the opening from that of the array in the cochlea.
class RibPeaks {
public:
  /// @param passage  Length of the opening's passage behind its plane; 0 without one.
  RibPeaks(const electrode::ArrayDesign& array, Length passage);

  void add(const haptics::TickOutput& now);

  /// The largest force with no rib at the opening; equal to the peak of an array without ribs.
  const ForceAtDepth& array() const { return array_; }
  /// The largest force with a rib at the opening; empty if none came there.
  const std::optional<ForceAtDepth>& rib() const { return rib_; }
  /// Number of the rib of rib(), from the tip: 1, 2, ...
  int ribNumber() const { return ribNumber_; }

private:
  std::vector<double> ribs_;  ///< Distances from the tip, ascending [m].
  double passage_;            ///< [m]
  ForceAtDepth array_;
  std::optional<ForceAtDepth> rib_;
  int ribNumber_ = 0;
};

}  // namespace perilymph::analysis

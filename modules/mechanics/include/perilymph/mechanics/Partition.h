// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochlear partition, which ruptures under the array: translocation.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// The angles from the round window between which the cochlear partition is the roof of a scala
/// tympani [rad]. Its first 12 degrees are eased into the straight lead-in, and the membrane ends 5
/// degrees before the apex: forces there are not forces on the partition, and it does not rupture.
struct PartitionRange {
  double begin = 0.0, end = 0.0;
  bool holds(double angle) const noexcept { return angle > begin && angle < end; }
};

/// That of a scala tympani.
PartitionRange partitionRangeOf(const anatomy::ScalaTympani& scala);

/// What is above a partition that can rupture.
///
/// With the energy E of the wall on a node in the scala below or above (the node's side), and that
/// without a partition E_both, in the lumen of both scalae, the partition stores w (E - E_both).
/// w is 1 where it is intact and 0 where it is open; the force on it is the gradient of that energy.
struct PartitionModel {
  /// @throws std::invalid_argument if the sections above cannot be built.
  PartitionModel(const anatomy::ScalaTympani& tympani, Force breakingForce);

  /// Builds what queries of the two lumens read, once: some tenths of a second, not real-time safe. A
  /// query does it if nobody did, which spares it an insertion that never loads the partition.
  void prepare() const;

  std::shared_ptr<const anatomy::ScalaTympani> vestibuli;  ///< The scala vestibuli.
  std::shared_ptr<const anatomy::ScalaTympani> both;       ///< Both scalae without a partition.
  double strength = 0.0;                                   ///< Force at which it ruptures [N].
  PartitionRange range;                                    ///< Where it is.

  /// Length of torn edge along which the partition yields (choice, low).
  static constexpr double edge = 0.5e-3;  // [m]
  /// Growth of a rupture in a step in which its edge carries the strength (choice, low).
  static constexpr double growth = 0.1e-3;  // [m]
};

/// A part of the partition that ruptured, its edges included.
struct RupturedRange {
  double begin = 0.0, end = 0.0;              ///< Angles from the round window [rad].
  double beginRadius = 0.0, endRadius = 0.0;  ///< Distance of the duct's center from the axis at
                                              ///< the edges [m].
};

/// A rupture at the end of a step.
struct Rupture {
  std::uint64_t tick = 0;  ///< Steps done.
  double angle = 0.0;      ///< From the round window [rad].
  double force = 0.0;      ///< Force normal to the partition, within one contact [N].
  double depth = 0.0;      ///< Array length past the opening [m].
};

/// Maximum number of separate ruptures; at more places the partition holds.
inline constexpr std::size_t maxRuptures = 4;

/// IntactFraction w of the partition at an angle.
struct IntactFraction {
  double value = 1.0;
  double slope = 0.0;  ///< Derivative by the angle [1/rad].
  double bend = 0.0;   ///< Second derivative.
};

/// The state of a partition. Until it ruptures, nothing else in the program depends on it.
struct PartitionState {
  std::array<RupturedRange, maxRuptures> ranges{};
  std::size_t count = 0;  ///< Number of ranges, sorted by angle.
  Rupture first;          ///< The first rupture.
  /// Whether each node is above the partition; in an open part, nearer to the scala vestibuli. Empty
  /// without a partition that can rupture.
  std::vector<unsigned char> isAbove;

  bool isRuptured() const noexcept { return count > 0; }
  /// Length of the array above the partition, for the spacing of its nodes [m]. Real-time safe.
  double lengthAbove(double spacing) const noexcept;
  /// Real-time safe.
  IntactFraction at(double angle) const noexcept;
};

}  // namespace perilymph::mechanics

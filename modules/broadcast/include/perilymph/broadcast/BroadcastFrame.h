// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is sent of one moment of an insertion.

#include <array>
#include <cstdint>
#include <type_traits>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::broadcast {

/// Maximum number of contacts that are sent. Shipped arrays have 12 to 22.
inline constexpr std::uint32_t maxContacts = 64;

/// A position with axes, in the cochlear frame W.
struct Pose {
  std::array<double, 3> place_W{};  ///< [m]
  std::array<std::array<double, 3>, 3> axis_W{
      {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  ///< Unit vectors x, y, z.
};

/// One moment of an insertion: fixed size, no pointers.
struct BroadcastFrame {
  std::uint64_t tick = 0;
  Pose tip;       ///< The array's end; z points out of it.
  Pose tweezers;  ///< The array's base; z points along the array.
  std::uint32_t contacts = 0;
  std::array<std::array<double, 3>, maxContacts> contact_W{};      ///< Centers, tip first [m].
  std::uint32_t nodes = 0;                                         ///< 0, or 2 and more.
  std::array<std::array<float, 3>, mechanics::maxNodes> node_W{};  ///< Base first, tip last [m].
  /// Half the diameters of the section at each node, within and across the plane of curl [m].
  std::array<std::array<float, 2>, mechanics::maxNodes> halfWidth{};
  std::array<double, 3> force_W{};  ///< Force of the array on the hand [N].
  double axialForce = 0.0;          ///< Insertion force along the approach [N].
};
static_assert(std::is_trivially_copyable_v<BroadcastFrame>);

/// The content of a snapshot. Contacts that are closer to the base than the array is long stay at
/// the base; a snapshot with fewer than 2 nodes, or nodes that are not finite, has neither contacts
/// nor nodes, and its poses are without rotation.
BroadcastFrame broadcastFrame(const haptics::Snapshot& now, const electrode::ArrayDesign& array);

}  // namespace perilymph::broadcast

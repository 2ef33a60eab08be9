// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is sent of one moment of an insertion.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::broadcast {

/// Maximum number of contacts that are sent. Shipped arrays have 12 to 22.
inline constexpr std::uint32_t maxContacts = 64;

/// The frame in which everything is sent.
enum class Coordinates {
  cochlea,  ///< The cochlear frame W.
  patient   ///< That of the patient's CT, as 3D Slicer has it: RAS, x to the right, y anterior, z
            ///< superior. DICOM and this program have LPS, whose x and y are the opposite.
};
inline constexpr std::array coordinateSystems{Choice<Coordinates>{Coordinates::cochlea, "cochlea"},
                                              Choice<Coordinates>{Coordinates::patient, "patient"}};
/// "cochlea" or "patient", in messages, settings and on the command line.
constexpr const char* nameOf(Coordinates coordinates)
{
  return nameIn(coordinateSystems, coordinates);
}

/// The cochlear frame W in the patient's frame, RAS.
struct Placement {
  /// Axes of W, unit vectors; their determinant is -1 for a left ear, whose W is mirrored.
  std::array<std::array<double, 3>, 3> axis_R{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  std::array<double, 3> origin_R{};  ///< [m]

  bool operator==(const Placement&) const = default;
};

/// A vector of W in RAS.
Eigen::Vector3d directionIn(const Placement& placement, const Eigen::Vector3d& vector_W);
/// A point of W in RAS [m].
Eigen::Vector3d pointIn(const Placement& placement, const Eigen::Vector3d& point_W);

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
  std::array<double, 3> force_W{};   ///< Force of the array on the hand [N].
  double axialForce = 0.0;           ///< Insertion force along the approach [N].
  double time = 0.0;                 ///< Since the first motion [s].
  double travel = 0.0, depth = 0.0;  ///< Travel of the base; array past the opening [m].
  double tipAngle = 0.0;             ///< From the round window; 0 before it [rad].
  /// Where the frame is sent in the patient's coordinates; else in W.
  std::optional<Placement> patient = std::nullopt;
  /// The transform to the patient and the CT are those of this cochlea.
  bool isPlaced = false;
  bool isShown = true;  ///< False: nothing else is known that could be sent.
};
static_assert(std::is_trivially_copyable_v<BroadcastFrame>);

/// The content of a snapshot. Contacts that are closer to the base than the array is long stay at
/// the base; a snapshot with fewer than 2 nodes, or nodes that are not finite, has neither contacts
/// nor nodes, and its poses are without rotation.
BroadcastFrame broadcastFrame(const haptics::Snapshot& now, const electrode::ArrayDesign& array);

}  // namespace perilymph::broadcast

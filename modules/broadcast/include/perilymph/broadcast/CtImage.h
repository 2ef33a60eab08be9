// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patient's CT as a message.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "perilymph/broadcast/BroadcastFrame.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::broadcast {

/// A CT, and the cochlear frame W in the patient's frame P.
struct PlacedCt {
  std::shared_ptr<const ct::CtVolume> volume;  ///< Not null.
  /// Axes of W in P, as columns; determinant -1 for a left ear, whose W is mirrored.
  Eigen::Matrix3d axes_PW = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin_P = Eigen::Vector3d::Zero();  ///< [mm]

  bool operator==(const PlacedCt&) const = default;
};

/// W in the patient's frame as it is sent: RAS in place of LPS.
Placement placementOf(const PlacedCt& ct);

/// An IMAGE message, ready to be sent.
using PackedImage = std::shared_ptr<const std::vector<std::uint8_t>>;

/// What is sent of a CT: voxels within this distance of the origin of W, or of the place next to it,
/// along the axes of the volume [mm]; less if they were more than maxImageVoxels.
inline constexpr double imageRadius_mm = 20.0;
/// 64 MB.
inline constexpr std::size_t maxImageVoxels = 32u << 20;

/// The CT around the cochlea, as an image. In W a left ear is mirrored, as its array is. The message
/// holds intensities and their place, nothing else of the series. Takes up to a second, and for
/// that time three times the memory of the message; not on the haptic thread.
Result<PackedImage> packImage(const PlacedCt& ct, Coordinates coordinates = Coordinates::cochlea);

}  // namespace perilymph::broadcast

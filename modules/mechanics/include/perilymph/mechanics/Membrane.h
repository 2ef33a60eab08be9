// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The basilar membrane: the compliant part of the roof.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// Stiffness of the membrane. Its rupture: Partition.h.
struct MembraneLaw {
  /// Stiffness of the membrane's middle under one sample point. Reported point stiffnesses are 0.6
  /// to 9 N/m; this is about their geometric mean (low).
  Stiffness perSamplePoint = newtonsPerMeter(2.3);
  /// Penetration at which the secant stiffness has doubled: F = k p (1 + (p / hardening)^2). About
  /// half the membrane's width (choice, low).
  Length hardening = millimeters(0.2);
};

/// Fraction of the array's footprint on the wall that is on the membrane; the rest is on bone.
struct MembraneFraction {
  double fraction = 0.0;  ///< 0 to 1.
  /// Gradient of the fraction by position [1/m].
  Eigen::Vector3d gradient_W = Eigen::Vector3d::Zero();
};

/// Position of the membrane in the roof of a scala tympani.
///
/// An array is at least as wide as the membrane, so it does not sink in as a point would: its
/// footprint extends half its radius to either side (as for a round array pressed in by an eighth
/// of its radius; choice, low), with the largest weight at its center. The fraction changes
/// smoothly across the membrane, and over the first and the last five degrees of the duct.
class MembranePlace {
public:
  explicit MembranePlace(const anatomy::ScalaTympani& scala);

  /// Fraction of membrane under an array that touches the wall. Real-time safe.
  ///
  /// @param at_W      Point on the array's center line [m].
  /// @param radius    Radius of the array there [m].
  /// @param track     Angle of the point.
  /// @param normal_W  Normal of the touched wall; at the roof it points down.
  MembraneFraction fractionAt(const Eigen::Vector3d& at_W, double radius,
                              const anatomy::LumenTrack& track,
                              const Eigen::Vector3d& normal_W) const noexcept;

private:
  double perSection_ = 0.0;    ///< Table entries per angle [1/rad].
  double lastAngle_ = 0.0;     ///< [rad]
  std::vector<double> inner_;  ///< Distance of its inner edge from the modiolar axis [m].
  std::vector<double> outer_;  ///< Distance of its outer edge [m].
};

}  // namespace perilymph::mechanics

#pragma once

// The basilar membrane: the soft part of the roof.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// How the membrane yields. It does not rupture.
struct MembraneLaw {
  /// Stiffness of the membrane's middle under one sample point. Point stiffnesses of 0.6 to
  /// 9 N/m are reported; about their geometric mean (low).
  Stiffness perSamplePoint = newtonsPerMeter(2.3);
  /// At this depth it is twice as stiff as at first: F = k p (1 + (p / hardening)^2). About half
  /// the membrane's width (choice, low).
  Length hardening = millimeters(0.2);
};

/// How much of the array's footprint on the wall is on the membrane; the rest of it is on bone.
struct MembraneFraction {
  double fraction = 0.0;  ///< 0 to 1.
  /// Gradient of the fraction by position [1/m].
  Eigen::Vector3d gradient_W = Eigen::Vector3d::Zero();
};

/// Where the membrane is in the roof of a scala tympani.
///
/// An array is as wide as the membrane or wider, so it does not fall into it as a point would: its
/// footprint reaches half its radius to either side (that of a round array pressed in by an eighth
/// of its radius; choice, low), weighted most in its middle. The share grows and falls without a
/// kink across the membrane, and over the first and the last five degrees of the duct.
class MembranePlace {
public:
  explicit MembranePlace(const anatomy::ScalaTympani& scala);

  /// What an array that touches the wall has above it. Real-time safe.
  ///
  /// @param at_W      Its center line [m].
  /// @param radius    Its radius [m].
  /// @param track     Its angle.
  /// @param normal_W  Of the wall it touches; off the roof this points down.
  MembraneFraction fractionAt(const Eigen::Vector3d& at_W, double radius,
                              const anatomy::LumenTrack& track,
                              const Eigen::Vector3d& normal_W) const noexcept;

private:
  double perSection_ = 0.0;    ///< Entries of the tables per angle [1/rad].
  double lastAngle_ = 0.0;     ///< [rad]
  std::vector<double> inner_;  ///< Radius of its inner edge from the modiolar axis [m].
  std::vector<double> outer_;  ///< Distance of its outer edge [m].
};

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Mapping of the hand's motion from the device's frame D to the cochlear frame W.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/haptics/SampleValidator.h"

namespace perilymph::haptics {

/// Pose of the tweezers.
struct BasePose {
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();     ///< Unit: direction in which the array
                                                         ///< leaves them.
  Eigen::Vector3d curl_W = Eigen::Vector3d::UnitX();     ///< Unit, perpendicular to the axis:
                                                         ///< direction of curl.
};

/// Couples the hand to the base of the array like a clutch. D's -z, away from the user, is the
/// direction of the approach; D's x is E.x, as far as it is across. Along the axis of the opening, D
/// is parallel to E.
///
///     position_W = anchor_W + scale X_WD (hand_D - handAtAnchor_D)
///
/// The rotation since the anchor is applied to axis and curl. All functions are real-time safe.
class Registration {
public:
  /// @param entry        The opening of the model.
  /// @param approach_W   Unit: direction in which the hand pushes the array, D's -z.
  /// @param motionScale  Motion of the base over motion of the hand.
  Registration(const anatomy::Entry& entry, const Eigen::Vector3d& approach_W, double motionScale);

  /// Sets the anchor: from now on the base moves from `pose`, relative to the current hand.
  void anchor(const HandState& hand, const BasePose& pose) noexcept;

  /// Pose of the base commanded by the hand.
  BasePose pose(const HandState& hand) const noexcept;

  Eigen::Vector3d toCochlea(const Eigen::Vector3d& vector_D) const noexcept;
  Eigen::Vector3d toDevice(const Eigen::Vector3d& vector_W) const noexcept;

  /// Unit: direction in which the hand pushes the array.
  Eigen::Vector3d inward_W() const noexcept { return -rotation_WD_.col(2); }
  double motionScale() const noexcept { return motionScale_; }

  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  Eigen::Matrix3d rotation_WD_;
  double motionScale_;
  Eigen::Vector3d handAtAnchor_D_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotationAtAnchor_D_ = Eigen::Quaterniond::Identity();
  BasePose anchor_;
};

}  // namespace perilymph::haptics

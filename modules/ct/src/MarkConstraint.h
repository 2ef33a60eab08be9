// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Landmarks that a person placed, as soft constraints of the fit.
//
// A constraint states that a length r(pose, shape) is 0. The person errs by a standard deviation
// sigma; the fit usually by s, or by S where it is wrong altogether, which has the probability p after
// the mark was seen. With the precision
//
//     P = w / ((1 - w) f),   w = (1 - p) s^2 / (s^2 + sigma^2) + p S^2 / (S^2 + sigma^2),
//
// the fit moves by w r, the mean of both cases. f is the variance of r by the fit's own covariance,
// which leaves out the limits of the shape.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "LumenShape.h"
#include "Pose.h"
#include "perilymph/ct/Marks.h"

namespace perilymph::ct {

/// One length that a landmark makes 0.
struct MarkConstraint {
  Mark mark;
  Eigen::Vector3d point_P;  ///< A point of the wall, or of the axis [mm].
  double sd_mm;             ///< Standard deviation of the person's placement.
  double angle = 0.0;       ///< Angle of the wall's turn, full turns included [rad].
  /// Unit vector across the axis along which the axis misses the point; empty for a point of the
  /// wall.
  std::optional<Eigen::Vector3d> across_W;
  double precision = 0.0;  ///< Weight in the fit [1/mm^2].
};

/// Derivatives by rotation and translation in W (6), then by the shape.
using PoseShapeRow = Eigen::Matrix<double, 6 + shape::count, 1>;

struct MarkResidual {
  double value_mm;
  PoseShapeRow row;
};

/// The constraints of landmarks for a fit in its present state: the ends of A and B lie on the outer
/// wall of the basal turn; floor and apex on the lowest floor and the highest roof; modiolus and
/// apex on the axis. The round window is no constraint of the wall, which is open there.
///
/// @param axis_W  The clinical axis, unit.
std::vector<MarkConstraint> constraintsOf(const Marks& marks, const LumenShape& family,
                                          const Pose& pose, const ShapeVector& shape,
                                          const Eigen::Vector3d& axis_W);

/// Value and derivatives of a constraint; empty if the wall is out of reach.
std::optional<MarkResidual> residualOf(const MarkConstraint& constraint, const LumenShape& family,
                                       const ShapedLumen& lumen, const Pose& pose);

/// Whether a fit may be wrong altogether: p = 0 if that is excluded.
enum class GrossError { possible, excluded };

/// Sets the precisions by the distance of a finished fit from the marks.
///
/// @param posterior  Covariance of the fit's pose and shape.
void setPrecisions(std::vector<MarkConstraint>& constraints, const LumenShape& family,
                   const Pose& pose, const ShapeVector& shape, const Eigen::MatrixXd& posterior,
                   GrossError grossError);

/// Whether a fit is more than three standard deviations of the person from a landmark.
bool contradicts(const Marks& marks, const LumenShape& family, const Pose& pose,
                 const ShapeVector& shape, const Eigen::Vector3d& axis_W);

/// How far a fit is from landmarks, from 0 (within a fraction of a standard deviation) to 1 (four
/// standard deviations or more), in the mean.
double disagreement(const Marks& marks, const LumenShape& family, const Pose& pose,
                    const ShapeVector& shape, const Eigen::Vector3d& axis_W);

/// The pose in which round window, modiolus and apex are where the landmarks say; empty without
/// these three.
std::optional<Pose> poseOf(const Marks& marks, const LumenShape& family,
                           const Eigen::Vector3d& axis_W, bool isRight);

}  // namespace perilymph::ct

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A segmented scala tympani: checked, registered to the cochlear frame, measured, and converted to
// a lumen.

#include <memory>
#include <string>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Pose of W in the frame of an imported surface.
struct ImportPlace {
  Eigen::Vector3d origin_I = Eigen::Vector3d::Zero();  ///< Origin of W in the file's frame I [m].
  /// Axes of W in I, as columns. The determinant is -1 for a left ear, which is mirrored.
  Eigen::Matrix3d axes_IW = Eigen::Matrix3d::Identity();

  Eigen::Vector3d into_W(const Eigen::Vector3d& point_I) const
  {
    return axes_IW.transpose() * (point_I - origin_I);
  }
  Eigen::Vector3d outOf_W(const Eigen::Vector3d& point_W) const
  {
    return origin_I + axes_IW * point_W;
  }
};

/// A reason to check the measures of an imported surface.
struct ImportDoubt {
  std::string flag;  ///< "spiked_wall", "opening_in_doubt" or "unusual_proportions".
  std::string sentence;
};

/// Result of importing a segmented surface.
struct ImportedScala {
  Surface wall_W;    ///< The wall in W, open at the opening [m]; a left ear is mirrored.
  Surface closed_W;  ///< The same, closed by a lid over the opening.
  ImportPlace place;
  Side side = Side::right;
  Length a;         ///< Sum of the outer wall's distances from the axis at 0 and 180 degrees.
  Length b;         ///< The same at 90 and 270 degrees.
  Length h;         ///< Highest roof minus lowest floor along the axis, from 0 degrees to the apex.
  Angle lastAngle;  ///< Angle of the apical end from the round window.
  Length leadIn;    ///< Straight length before the round window, excluded from all measures.
  double volume = 0.0;  ///< Enclosed volume, lead-in included [m^3].
  Entry entry;          ///< The opening, in W.
  std::vector<ImportDoubt> doubts;
};

/// Determines axis, round window and measures of a surface in meters.
///
/// The axis is first that of the spiral motion that best maps the surface onto itself, then the one
/// about which log r and z of the duct's center line are best fitted by polynomials in the angle
/// (`src/importing/ModiolarAxis.h`). The round window is the rim of an open surface, after a straight lead-in
/// if there is one; in a closed surface it is the end of the duct in its widest turn.
///
/// Refuses, with a message, every surface that cannot be a scala tympani. Takes about a second.
Result<ImportedScala> importScala(const Surface& segmented);

/// The imported wall as a lumen. Takes seconds.
std::shared_ptr<const Lumen> lumenOf(const ImportedScala& scala);

}  // namespace perilymph::anatomy

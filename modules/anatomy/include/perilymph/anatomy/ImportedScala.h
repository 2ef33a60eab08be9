#pragma once

// A scala tympani as someone else segmented it: checked, put into the cochlear frame, measured, and
// made a lumen.

#include <memory>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Where an imported surface lies in W.
struct ImportPlace {
  Eigen::Vector3d origin_I = Eigen::Vector3d::Zero();  ///< Origin of W in the file's frame I [m].
  /// Axes of W in I, as columns. Their determinant is -1 for a left ear, which is mirrored.
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

/// What was found in a segmented surface.
struct ImportedScala {
  Surface wall_W;    ///< The wall in W, open at the opening [m]; a left ear is mirrored.
  Surface closed_W;  ///< The same with a lid over the opening.
  ImportPlace place;
  Side side = Side::right;
  Length a;         ///< Outer wall's distance from the axis at 0 degrees and that at 180, summed.
  Length b;         ///< The same at 90 and 270 degrees.
  Length h;         ///< Highest roof minus lowest floor along the axis, from 0 degrees on.
  Angle lastAngle;  ///< Angle of the apical end from the round window.
  Length leadIn;    ///< Straight stretch before the round window, left out of all measures.
  double volume = 0.0;  ///< Enclosed, lead-in included [m^3].
  Entry entry;          ///< The opening, in W.
};

/// Finds axis, round window and measures of a surface in meters.
///
/// The axis is first that of the spiral motion which moves the surface most nearly along itself,
/// then the one about which log r and z of the duct's center line are most nearly polynomials in
/// the angle
/// (`src/ModiolarAxis.h`). The round window is the rim of an open surface, after a straight lead-in
/// if there is one; of a closed one the end of the duct in its widest turn.
///
/// Every surface that cannot be a scala tympani is refused with a sentence. Takes a second.
Result<ImportedScala> importScala(const Surface& segmented);

/// Its wall as a lumen. Takes seconds.
std::shared_ptr<const Lumen> lumenOf(const ImportedScala& scala);

}  // namespace perilymph::anatomy

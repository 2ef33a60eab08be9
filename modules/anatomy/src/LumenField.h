#pragma once

// The wall query of a scala tympani: a table of distances in unrolled coordinates, smooth in all
// three, read in the tick.

#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// Signed distance to the wall over (angle, radial, axial), the last two as shares of the section's
/// half width and half height, as a uniform tricubic B-spline.
///
/// The samples are the spline's coefficients. That smooths over one grid step (0.03 to 0.06 mm), so
/// the distance has continuous second derivatives even along the ridges where two walls are equally
/// near; elsewhere it is off by a few micrometers (measured in the tests).
class LumenField {
public:
  /// Builds the table. Takes a tenth of a second.
  explicit LumenField(const ScalaTympani& scala);

  /// The wall nearest to one point. Real-time safe.
  void locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& track,
              WallPoint& wall) const noexcept;

private:
  struct Unrolled;
  void fillSection(const ScalaTympani& scala, int section);
  void continueIntoLeadIn();
  Unrolled unroll(const Eigen::Vector3d& point_W, const LumenTrack& track,
                  bool inLeadIn) const noexcept;

  Entry entry_;
  Eigen::Vector3d inward_W_;
  double lastAngle_, perSection_;
  int sections_ = 0;
  // Coefficients over the angle.
  std::vector<double> centerRadius_, centerHeight_, halfWidth_, halfHeight_;
  std::vector<double> membraneInner_, membraneOuter_, membraneHeight_;
  std::vector<double>
      leastRadius_;  ///< Per section: the wall's least distance from the center [m].
  std::vector<double>
      leastSlant_;               ///< Per section: least distance in space over that in the section.
  std::vector<float> distance_;  ///< [section][radial][axial], [m].
};

}  // namespace perilymph::anatomy

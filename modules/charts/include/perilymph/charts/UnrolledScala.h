// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scala tympani unrolled: angle along, width across, with the array and its contacts.

#include <vector>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// The scala seen along the modiolus and unrolled: angle from the round window [degrees] to the
/// right, radial distance from the section's center [mm] upward, outer wall at the top. The scales
/// differ. The lumen is drawn with its maximum width, so an array on the floor may touch where it
/// appears free.
///
/// The normal force of the wall on each millimeter of the array is a bar at the wall; forces of
/// floor and roof are rings on the array. Where the cochlear partition is torn, the lumen is red; what is
/// above it, in the scala vestibuli, is outlined in red.
class UnrolledScala {
public:
  /// Length of a bar [px] for this force per length.
  static constexpr double bar_px = 18.0, bar_mN_mm = 50.0;

  explicit UnrolledScala(const anatomy::ScalaTympani& scala, ChartStyle style = {});

  /// Draws the view at a size in pixels. The range, 0 to 540 degrees, is extended by quarter turns
  /// with the tip.
  figures::Drawing draw(const ArrayInScala& now, double width, double height) const;

  /// The same as a standalone picture, with a line that explains the axes.
  figures::Drawing drawPage(const ArrayInScala& now, double width, double height) const;

private:
  struct Width {
    double angle_deg, inner_mm, outer_mm;
  };
  Width widthAt(double angle_deg) const;

  ChartStyle style_;
  double lastAngle_deg_, leadIn_deg_;
  double inner_mm_ = 0.0, outer_mm_ = 0.0;  ///< Maximum extent.
  std::vector<Width> widths_;               ///< At equal angles, from the opening on.
};

}  // namespace perilymph::charts

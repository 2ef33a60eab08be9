// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Section through the scala tympani at the tip, with the array.

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// The half-plane through the modiolar axis one tip radius behind the tip: modiolus on the left,
/// apex up, to scale. The array is drawn as the cut through the body that the mechanics holds
/// against the wall. The arrow is the sum of the wall's normal forces on the last millimeter of the
/// array, with the scale arrow_px_mN.
class TipSection {
public:
  static constexpr double forceReach_mm = 1.0;
  static constexpr double arrow_px_mN = 1.0;
  static constexpr double longestArrow_px = 60.0;

  explicit TipSection(const anatomy::ScalaTympani& scala, ChartStyle style = {});

  /// Draws the view at a size in pixels. Before the tip is inside, the section at the round window.
  figures::Drawing draw(const ArrayInScala& now, double width, double height) const;

  /// Angle of the section drawn for an array.
  static double angle_deg(const ArrayInScala& now);

private:
  const anatomy::ScalaTympani& scala_;
  ChartStyle style_;
  double halfWidth_mm_ = 0.0, halfHeight_mm_ = 0.0;  ///< Half size that contains every section.
};

}  // namespace perilymph::charts

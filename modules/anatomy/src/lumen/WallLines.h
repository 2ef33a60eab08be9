// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lengthwise lines of the wall, from which the distance table is computed.

#include <array>

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// The points of a section's outline and the lengthwise line of the wall through each of them.
class WallLines {
public:
  static constexpr int points = 120;

  WallLines(const ScalaTympani& scala, double angle);

  /// Distance in space from (u, v) in the section, relative to its center [m], to the wall, by the
  /// nearest line and a parabola through its neighbors.
  double distance(double u, double v) const noexcept;

  /// Minimum distance of the outline from the center [m].
  double minRadius() const noexcept { return minRadius_; }
  /// Minimum ratio of the distance in space to the distance in the section.
  double minSlant() const noexcept { return minSlant_; }

private:
  /// Every third point is looked at first. Points are stored in this order.
  static constexpr int stride = 3;
  static constexpr int coarse = points / stride;
  static constexpr std::size_t placeOf(int point) noexcept
  {
    return static_cast<std::size_t>(point % stride * coarse + point / stride);
  }

  /// Squared distance in space to the line at a place, for T = Four to those at four places.
  template <class T>
  T squaredTo(std::size_t place, double u, double v) const noexcept;
  /// Squared distance to the wall; negative by rounding only.
  double squaredDistance(double u, double v) const noexcept;

  using Column = std::array<double, points>;
  // A point of the outline; unit tangent and curvature [1/m] of its lengthwise line, their components
  // in the section, the magnitude of the curvature, and the arc over which a parabola approximates
  // the line [m]. Columns, so that several points are computed at a time.
  Column u_, v_, alongU_, alongV_, bendU_, bendV_, bend_, reach_;
  double minRadius_ = 1e9, minSlant_ = 1.0;
};

}  // namespace perilymph::anatomy

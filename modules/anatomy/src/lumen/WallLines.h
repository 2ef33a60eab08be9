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
  /// A point (u, v) of the outline; unit tangent and curvature [1/m] of its lengthwise line, their
  /// components in the section, and the magnitude of the curvature.
  struct Line {
    double u, v;
    double alongU, alongV;
    double bendU, bendV;
    double bend;

    double squaredDistance(double atU, double atV) const noexcept;
  };

  std::array<Line, points> lines_;
  double minRadius_ = 1e9, minSlant_ = 1.0;
};

}  // namespace perilymph::anatomy

#pragma once

// How the wall runs on from one section to the next: what the table of distances is made from.

#include <array>

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// The points of a section's outline, and the wall's lengthwise line through each of them.
class WallLines {
public:
  static constexpr int points = 120;

  WallLines(const ScalaTympani& scala, double angle);

  /// Distance in space from (u, v) in the section, from its center [m], to the wall, by the nearest
  /// line and a parabola through its neighbors.
  double distance(double u, double v) const noexcept;

  /// The outline's least distance from the center [m].
  double minRadius() const noexcept { return minRadius_; }
  /// The least ratio of distance in space to distance in the section.
  double minSlant() const noexcept { return minSlant_; }

private:
  /// A point (u, v) of the outline; unit tangent and curvature [1/m] of its lengthwise line, their
  /// parts in the section, and the size of the curvature.
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

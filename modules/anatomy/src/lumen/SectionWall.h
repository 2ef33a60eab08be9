// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The wall of one section in many directions: what depends on the angle alone is computed once.

#include <array>
#include <cstddef>
#include <vector>

#include "numerics/CubicTable.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {

/// A position in a table over the angle: the first of four coefficients, and the fraction.
struct Place {
  std::size_t first;
  double fraction;
};

/// A direction around a section [rad], with its sine and cosine.
struct Direction {
  double angle;
  SineCosine around;
};

/// Directions at equal steps around a section, computed once for each count.
template <int count>
const std::array<Direction, count>& directionsAround()
{
  static const std::array<Direction, count> all = [] {
    std::array<Direction, count> each;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * pi * k / count;
      each[static_cast<std::size_t>(k)] = {angle, sineCosine(angle)};
    }
    return each;
  }();
  return all;
}

/// The outline of a scala tympani at an angle. Refers to the scala.
class SectionWall {
public:
  /// @param angle  From the round window [rad]; negative in the lead-in.
  SectionWall(const ScalaTympani& scala, double angle) noexcept;

  /// ScalaTympani::wall_W() in a direction [rad].
  Eigen::Vector3d at(double direction) const noexcept
  {
    return at(direction, sineCosine(direction));
  }
  /// The same for a direction whose sine and cosine are known.
  Eigen::Vector3d at(double direction, const SineCosine& around) const noexcept;
  Eigen::Vector3d at(const Direction& direction) const noexcept
  {
    return at(direction.angle, direction.around);
  }

  /// Bounds of the distance between center and wall in all directions [m]: a spline lies between its
  /// coefficients. Takes as long as ten points.
  struct Radii {
    double min, max;
  };
  Radii radii() const noexcept;

  /// The same bounds for every step of the table around the section.
  std::vector<Radii> radiiOfSteps() const;
  /// The step in which a direction lies [rad].
  std::size_t stepOf(double direction) const noexcept { return indexOf(direction).first; }

private:
  /// The position of a direction in the table around the section.
  Place indexOf(double direction) const noexcept;

  SectionWall(const ScalaTympani& scala, double angle, Place place) noexcept;

  const ScalaTympani& scala_;
  const double* rows_;  // of the wall's coefficients, the first of four
  CubicWeights along_;
  SineCosine turn_;
  double centerRadius_, centerHeight_;  // [m]
  bool isLeadIn_;
};

}  // namespace perilymph::anatomy

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The wall of one section in many directions: what depends on the angle alone is computed once.

#include <cstddef>

#include "numerics/CubicTable.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {

/// A position in a table over the angle: the first of four coefficients, and the fraction.
struct Place {
  std::size_t first;
  double fraction;
};

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

  /// Bounds of the distance between center and wall in all directions [m]: a spline lies between its
  /// coefficients. Takes as long as ten points.
  struct Radii {
    double min, max;
  };
  Radii radii() const noexcept;

private:
  SectionWall(const ScalaTympani& scala, double angle, Place place) noexcept;

  const ScalaTympani& scala_;
  const double* rows_;  // of the wall's coefficients, the first of four
  CubicWeights along_;
  SineCosine turn_;
  double centerRadius_, centerHeight_;  // [m]
  bool isLeadIn_;
};

}  // namespace perilymph::anatomy

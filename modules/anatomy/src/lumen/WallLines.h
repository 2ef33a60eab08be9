// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lengthwise lines of the wall, from which the distance table is computed.

#include <array>
#include <cstddef>
#include <span>

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

  /// distance() at all points of a grid, to the same bits, without the lines that are nowhere near.
  ///
  /// @param u, v  Increasing [m].
  /// @param to    Receives the distance at (u[i], v[j]) at i v.size() + j [m].
  void distances(std::span<const double> u, std::span<const double> v, double* to) const noexcept;

  /// Minimum distance of the outline from the center [m].
  double minRadius() const noexcept { return minRadius_; }
  /// Minimum ratio of the distance in space to the distance in the section.
  double minSlant() const noexcept { return minSlant_; }

private:
  /// Every third point is looked at first.
  static constexpr int stride = 3;
  static constexpr int coarse = points / stride;
  /// Points are stored with the last ones before the first and the first ones after the last, so that
  /// the neighbors of each lie beside it.
  static constexpr std::size_t stored = points + 2 * stride + 1;
  static constexpr std::size_t placeOf(int coarsePoint) noexcept
  {
    return static_cast<std::size_t>(stride * (coarsePoint + 1));
  }

  /// Squared distance in space from one point or four to the line at a place.
  template <class T>
  T squaredTo(std::size_t place, const T& u, const T& v) const noexcept;
  /// The same from one point to the two lines before a place and the two after it.
  auto squaredBeside(std::size_t place, double u, double v) const noexcept;
  /// Squared distance to the wall from the nearest of the coarse points and the squared distance to its
  /// line; negative by rounding only.
  double refined(std::size_t place, double squared, double u, double v) const noexcept;
  /// The coarse points that can be the nearest ones of a part of the grid; their number.
  std::size_t candidates(double u, double v, double radius, std::size_t* places) const noexcept;
  void distancesInLanes(std::span<const double> u, std::span<const double> v,
                        double* to) const noexcept;

  using Column = std::array<double, stored>;
  // A point of the outline; unit tangent and curvature [1/m] of its lengthwise line, their components
  // in the section, the magnitude of the curvature, and the arc over which a parabola approximates
  // the line [m]. Columns, so that several points are computed at a time.
  Column u_, v_, alongU_, alongV_, bendU_, bendV_, bend_, reach_;
  Column slope_{};  ///< Length of the tangent's part in the section, of the points themselves.
  double minRadius_ = 1e9, minSlant_ = 1.0;
};

}  // namespace perilymph::anatomy

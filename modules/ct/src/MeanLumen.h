// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bony lumen of the mean cochlea in CT: scala tympani, media and vestibuli as one, at every
// angle of the half-plane through the modiolar axis. Lengths in mm, angles in rad.

#include <cstddef>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

/// A place in the tables of lines along the duct: the entry before an angle, and the fraction of the
/// step to the next.
struct LinePlace {
  std::size_t first;
  double fraction;

  double in(const std::vector<double>& table) const
  {
    return table[first] + fraction * (table[first + 1] - table[first]);
  }
};

/// Signed distance to a section's outline in its half-plane, and its gradient.
struct SectionDistance {
  double inside;  ///< Distance from the outline, positive inside [mm].
  double du, dv;  ///< Its derivatives along u and v.
};

/// Sections of the mean scala tympani, each united with its mirror image in its roof (the scala
/// vestibuli is not measured) and made convex: the spiral ligament fills the notch between both,
/// and CT does not distinguish it from fluid.
///
/// In a section, u is the distance radially outward from the outermost wall and v that along the
/// axis from the center of the section.
class MeanLumen {
public:
  static Result<MeanLumen> make();

  static constexpr double firstAngle() { return -0.35; }  ///< Start of the tables [rad].
  double lastAngle() const { return lastAngle_; }         ///< Angle of the apex [rad].

  /// For several lines at one angle, and for other tables of as many entries.
  LinePlace placeOf(double angle) const;
  double outerRadius(const LinePlace& place) const { return place.in(outer_); }      ///< [mm]
  double height(const LinePlace& place) const { return place.in(height_); }          ///< [mm]
  double width(const LinePlace& place) const { return place.in(width_); }            ///< [mm]
  double halfHeight(const LinePlace& place) const { return place.in(halfHeight_); }  ///< [mm]

  double outerRadius(double angle) const { return at(outer_, angle); }          ///< [mm]
  double outerRadiusSlope(double angle) const { return slope(outer_, angle); }  ///< [mm/rad]
  double height(double angle) const { return at(height_, angle); }  ///< Height of the center [mm].
  double heightSlope(double angle) const { return slope(height_, angle); }  ///< [mm/rad]
  double width(double angle) const { return at(width_, angle); }            ///< Radial [mm].
  double halfHeight(double angle) const { return at(halfHeight_, angle); }  ///< [mm]

  /// Distance in the section at an angle; a lower bound far outside the tables.
  SectionDistance distance(double angle, double u, double v) const;

private:
  MeanLumen() = default;
  double at(const std::vector<double>& table, double angle) const
  {
    return placeOf(angle).in(table);
  }
  double slope(const std::vector<double>& table, double angle) const;

  double lastAngle_ = 0.0;
  std::vector<double> outer_, height_, width_, halfHeight_;  ///< Every `lineStep`.
  std::vector<float> field_;                                 ///< [angle][v][u]
  int angles_ = 0;
};

}  // namespace perilymph::ct

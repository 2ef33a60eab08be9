// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The wall query of a scala tympani: a table of signed distances in unrolled coordinates, smooth in
// all three, read in the tick.

#include <array>
#include <cstdint>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

struct CubicBlock;

/// Signed distance to the wall over (angle, radial, axial), the last two relative to the section's
/// half width and half height, as a uniform tricubic B-spline.
///
/// The samples are the spline's coefficients. This smooths over one grid step (0.03 to 0.06 mm), so
/// that the distance has continuous second derivatives even along the ridges where two walls are
/// equally near; elsewhere its error is a few micrometers (measured in the tests).
class LumenField {
public:
  /// Builds the table. Takes a tenth of a second.
  explicit LumenField(const ScalaTympani& scala);

  /// Finds the wall nearest to one point. Real-time safe.
  void locate(const Eigen::Vector3d& point_W, double reach, LumenTrack& track,
              WallPoint& wall) const noexcept;

  /// Updates the track of a point. Real-time safe.
  void follow(const Eigen::Vector3d& point_W, LumenTrack& memory) const noexcept;

private:
  // The columns of the table along the duct: the section's center, its half width and half height,
  // and the basilar membrane's edges and height from that center [m].
  enum Column : std::size_t {
    centerRadius,
    centerHeight,
    halfWidth,
    halfHeight,
    membraneInner,
    membraneOuter,
    membraneHeight,
    columns
  };

  struct Unrolled;

  // construction of the table
  void fillSection(const ScalaTympani& scala, int section);
  void continueIntoLeadIn();
  double along(Column column, std::size_t section, const double weights[4]) const noexcept;

  // evaluation of the table
  bool track(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept;
  Unrolled unroll(const Eigen::Vector3d& point_W, const LumenTrack& track) const noexcept;
  /// The distance and its derivatives by the index of the angle and by those of p and q [m].
  CubicBlock distanceAt(Unrolled& at) const noexcept;
  /// The Hessian of the distance, and how far it may be used.
  void setHessian(const LumenTrack& track, const Unrolled& at, const CubicBlock& spline,
                  WallPoint& wall) const noexcept;
  void setTurning(const Eigen::Vector3d& point_W, const LumenTrack& track, const Unrolled& at,
                  const CubicBlock& spline, WallPoint& wall) const noexcept;
  bool isOnMembrane(const LumenTrack& track, const Unrolled& at,
                    const WallPoint& wall) const noexcept;

  static constexpr int across = 46;                     // samples over a section, along each axis
  static constexpr std::size_t page = across * across;  // samples per section
  static constexpr double margin = 1.25;  // extent of the table in half widths and half heights
  static constexpr double samplesPerUnit = (across - 3) / (2.0 * margin);  // samples per half width

  Entry entry_;
  Eigen::Vector3d inward_W_;
  double lastAngle_, perSection_;
  int sections_ = 0;
  /// Spline coefficients over the angle, two more than sections.
  std::vector<std::array<double, columns>> along_;
  std::vector<double> minRadius_;  ///< Per section: minimum distance of the wall from the center
                                   ///< [m].
  std::vector<double>
      minSlant_;                 ///< Per section: minimum ratio of the distance in space to that in
                                 ///< the section.
  std::vector<float> distance_;  ///< [section][radial][axial], [m].
  std::vector<std::uint8_t> trust_;  ///< The same cells: indices into trustRadii.
};

}  // namespace perilymph::anatomy

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An individual's bony lumen: the mean one with radii, rise and sections changed by parameters, and
// the derivatives of the wall distance by them. Frame W, lengths in mm.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "MeanLumen.h"

namespace perilymph::ct {

/// The parameters of a shape, in one vector. All 0 is the mean cochlea.
namespace shape {
inline constexpr int half = 0;    ///< A1, B1, A2, B2 minus the population's mean [mm].
inline constexpr int rise = 4;    ///< Relative change of the center line's heights.
inline constexpr int width = 5;   ///< Relative change of the sections' width at 0 and per turn.
inline constexpr int tilt = 7;    ///< Shear dv/du of the sections at 0 and per turn.
inline constexpr int height = 9;  ///< Relative change of the sections' height, a spline.
inline constexpr int heightKnots = 14;
inline constexpr int radial =
    height + heightKnots;  ///< Outer wall outward [4 mm radius], a spline.
inline constexpr int knots = 25;
inline constexpr int axial = radial + knots;  ///< Displacement of sections toward the apex [mm], a
                                              ///< spline.
inline constexpr int count = axial + knots;

inline constexpr double firstKnot_deg = -90.0;
inline constexpr double knotStep_deg = 45.0;
inline constexpr double heightStep_deg = 90.0;
}  // namespace shape

using ShapeVector = Eigen::Matrix<double, shape::count, 1>;

/// Position of one turn's section at an angle, and its derivatives.
struct SectionPlace {
  double outer, outerSlope;    ///< Maximum radius [mm], [mm/rad].
  double middle, middleSlope;  ///< Height of the section's center [mm], [mm/rad].
  double width, height, tilt;  ///< Factors on u and v, shear.
};

/// Distance of a point from the wall of one turn, with its derivatives.
struct TurnDistance {
  double angle = 0.0;                                  ///< Full turns included [rad].
  double u = 0.0, width = 0.0;                         ///< In the mean section [mm].
  double inside = 0.0;                                 ///< Positive in the lumen [mm].
  double curvature = 0.0;                              ///< Mean curvature of the section [1/mm].
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< In W.
  double byOuter = 0.0, byMiddle = 0.0, byWidth = 0.0, byHeight = 0.0, byTilt = 0.0;
};

/// The turns whose wall is near a point.
struct NearTurns {
  std::array<TurnDistance, 4> turn;
  int count = 0;
  int nearest = -1;  ///< The turn that contains the point, or the nearest one.
};

/// Weights of four neighbors of a uniform cubic B-spline.
struct SplineWeights {
  int first;
  std::array<double, 4> weight;
};
SplineWeights splineWeights(double angle, double step_deg, int count);

/// The family of shapes. Keeps a reference to the mean lumen, which must outlive it.
class LumenShape {
public:
  explicit LumenShape(const MeanLumen& mean);

  const MeanLumen& mean() const { return mean_; }

  SectionPlace place(const ShapeVector& q, double angle) const;

  /// Adds `factor` times a turn's derivatives by the shape's parameters to a row.
  template <class Row>
  void addDerivatives(const TurnDistance& turn, double factor, Row&& row) const;

  /// Effect of A1, B1, A2, B2 on the maximum radius at an angle, relative to the mean's [1/mm].
  std::array<double, 4> populationModes(double angle) const
  {
    return populationModes(mean_.placeOf(angle));
  }
  std::array<double, 4> populationModes(const LinePlace& place) const;

  /// Precision matrix of the prior: population covariance, amplitudes and smoothness.
  Eigen::MatrixXd priorPrecision() const;
  /// Center of the prior: the mean cochlea with the section height of bony lumens.
  static ShapeVector priorMean();

private:
  const MeanLumen& mean_;
  std::array<std::vector<double>, 4> modes_;  ///< As the lines of the mean lumen.
};

/// Whether a spiral rises from the base to the middle turn. One that falls winds as in the other ear.
bool climbs(const LumenShape& family, const ShapeVector& q);

/// One shape of the family with tabulated lines, for many queries.
class ShapedLumen {
public:
  ShapedLumen(const LumenShape& family, const ShapeVector& q);

  SectionPlace place(double angle) const { return place(mean_.placeOf(angle)); }
  SectionPlace place(const LinePlace& at) const;
  /// The turns within `reach` of a point in W [mm].
  NearTurns distances(const Eigen::Vector3d& point_W, double reach) const;
  /// Distance from the wall of the nearest of these turns, positive in the lumen [mm]; empty without one.
  std::optional<double> inside(const Eigen::Vector3d& point_W, double reach) const;
  const MeanLumen& mean() const { return mean_; }

private:
  struct Beside;
  /// Calls `visit` with every turn that may be within reach.
  ///
  /// @param r  Distance of the point from the axis [mm].
  template <class Visit>
  void eachTurn(const Eigen::Vector3d& point_W, double r, double reach, const Visit& visit) const;

  const MeanLumen& mean_;
  std::vector<SectionPlace> places_;  ///< As the lines of the mean lumen.
};

template <class Row>
void LumenShape::addDerivatives(const TurnDistance& turn, double factor, Row&& row) const
{
  const double perTurn = turn.angle / 6.283185307179586 - 0.5;
  const LinePlace place = mean_.placeOf(turn.angle);
  const double meanOuter = mean_.outerRadius(place);
  const std::array<double, 4> modes = populationModes(place);
  for (int i = 0; i < 4; ++i)
    row[shape::half + i] += factor * turn.byOuter * meanOuter * modes[static_cast<std::size_t>(i)];
  row[shape::rise] += factor * turn.byMiddle * mean_.height(place);
  row[shape::width] += factor * turn.byWidth;
  row[shape::width + 1] += factor * turn.byWidth * perTurn;
  row[shape::tilt] += factor * turn.byTilt;
  row[shape::tilt + 1] += factor * turn.byTilt * perTurn;
  const SplineWeights coarse = splineWeights(turn.angle, shape::heightStep_deg, shape::heightKnots);
  const SplineWeights fine = splineWeights(turn.angle, shape::knotStep_deg, shape::knots);
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    row[shape::height + coarse.first + i] += factor * turn.byHeight * coarse.weight[k];
    row[shape::radial + fine.first + i] +=
        factor * turn.byOuter * 0.25 * meanOuter * fine.weight[k];
    row[shape::axial + fine.first + i] += factor * turn.byMiddle * fine.weight[k];
  }
}

}  // namespace perilymph::ct

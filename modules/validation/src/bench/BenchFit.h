// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The grid of all unknowns, and the likelihood of a specimen's curves on it.

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <vector>

#include "CurveLikelihood.h"
#include "perilymph/validation/BenchChain.h"

namespace perilymph::validation {

/// Every point has the same weight but for the friction in soap, which is log-normal. Their meaning and
/// ranges: resources/guide/friction.md.
namespace grid {
inline constexpr std::array<double, 5> radii_mm{2.2, 2.4, 2.6, 2.8, 3.0};
inline constexpr std::array<double, 3> tightenings_per_mm{0.020, 0.035, 0.050};
inline constexpr std::array<double, 3> starts_mm{3.5, 4.3, 5.1};
inline constexpr std::array<double, 6> growths{0.0, 1.0, 3.0, 10.0, 30.0, 100.0};
inline constexpr std::array<double, 4> tipCotangents{1.5, 2.667, 3.833, 5.0};
inline constexpr std::size_t geometries =
    radii_mm.size() * tightenings_per_mm.size() * starts_mm.size();
inline constexpr std::size_t shapes = growths.size() * tipCotangents.size();  ///< The array's.

inline constexpr double logStep = 0.1;        ///< Step of friction and stiffness.
inline constexpr std::size_t levels = 77;     ///< EI(0) of 1e-9 to 2e-6 N m^2.
inline constexpr std::size_t frictions = 47;  ///< 0.01 to 1.
double logStiffness(std::size_t level);
double logFriction(std::size_t friction);
/// Weights of the friction in soap: 95 % from 0.0395 to 0.0605, as measured for silicone on PTFE.
Eigen::VectorXd soapPrior();
}  // namespace grid

/// ln(F / EI(0)) at some depths, over geometry, shape of the array, and friction.
class ShapeTable {
public:
  explicit ShapeTable(std::vector<double> depths);
  /// @param depth  One of those given.
  double at(std::size_t shape, std::size_t geometry, std::size_t friction, double depth) const;
  Eigen::VectorXd at(std::size_t shape, std::size_t geometry, std::size_t friction,
                     const std::vector<double>& depths) const;

private:
  std::vector<double> depths_, values_;
};

/// The curve of one medium down to some depth.
struct CurveFit {
  BenchMedium medium = BenchMedium::soap;
  std::vector<double> depths, forces;
  std::vector<LevelLikelihood> table;  ///< Over shape, geometry, friction.
  double shift = 0.0;                  ///< The largest ln p, taken from all likelihoods.

  const LevelLikelihood& at(std::size_t shape, std::size_t geometry, std::size_t friction) const
  {
    return table[(shape * grid::geometries + geometry) * grid::frictions + friction];
  }
};

/// The curves of a specimen from 8 mm to some depth.
class SpecimenFit {
public:
  SpecimenFit(const BenchSpecimen& specimen, const ShapeTable& table, double deepest);

  const std::vector<CurveFit>& curves() const { return curves_; }
  /// Index of a medium's curve; the number of curves if there is none.
  std::size_t indexOf(BenchMedium medium) const;
  /// The sum of all curves' shifts.
  double shift() const;

  /// Likelihood times prior of the frictions (rows) of each curve (columns), over exp(shift).
  Eigen::MatrixXd cell(std::size_t shape, std::size_t geometry, std::size_t level) const;
  /// Sum over geometries and frictions, over exp(shift()), for each array: shape * levels + level.
  Eigen::VectorXd evidence() const;

  /// Calls visit(array, geometry, cell) for every cell that is not negligible; array is
  /// shape * levels + level.
  template <class Visit>
  void forEachCell(Visit visit) const
  {
    for (std::size_t shape = 0; shape < grid::shapes; ++shape)
      for (std::size_t level = 0; level < grid::levels; ++level)
        for (std::size_t geometry = 0; geometry < grid::geometries; ++geometry)
          if (const Eigen::MatrixXd each = cell(shape, geometry, level);
              (each.colwise().sum().array() > 0.0).all())
            visit(shape * grid::levels + level, geometry, each);
  }

private:
  std::vector<CurveFit> curves_;
};

/// For each column of a cell, the product of the sums of the others.
Eigen::VectorXd productsOfOthers(const Eigen::MatrixXd& cell);

/// Depths of a curve within some range, limits included.
std::vector<double> depthsWithin(const BenchCurve& curve, double low, double high);

inline constexpr double shallowest = 8e-3, deepestForPrediction = 13e-3, deepestFitted = 14e-3;

/// The specimens with their fits from 8 to 13 mm and from 8 to 14.
struct BenchFits {
  const std::vector<BenchSpecimen>& specimens;
  const ShapeTable& table;
  std::vector<SpecimenFit> before, all;
};

/// ln p of the forces from 13 to 14 mm, given those from 8 to 13: of each specimen, by both models.
std::vector<ModelScore> scoresOf(const BenchFits& fits);
/// These forces with their bands.
std::vector<PredictedForce> predictionsOf(const BenchFits& fits);

}  // namespace perilymph::validation

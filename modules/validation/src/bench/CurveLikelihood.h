// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How well a model describes one measured curve of force over depth:
//   ln F_i = ln F_model(z_i) + d + e_i,   d ~ N(0, 0.15^2) once for the curve,
//   var e_i = (1.5 mN / F_i)^2 + 0.15^2,  correlation exp(-|z_i - z_k| / 3 mm).

#include <Eigen/Dense>
#include <vector>

namespace perilymph::validation {

/// Covariance of ln F of a curve. @param depths [m] @param forces [N]
Eigen::MatrixXd curveCovariance(const std::vector<double>& depths,
                                const std::vector<double>& forces);

/// ln p of a curve as a function of x, added to the model's ln F at every depth:
/// constant - (squares - 2 x slope + x^2 weight) / 2.
struct LevelLikelihood {
  double constant = 0.0, squares = 0.0, slope = 0.0, weight = 1.0;

  double at(double level) const noexcept
  {
    return constant - 0.5 * (squares - level * (2.0 * slope - level * weight));
  }
  double best() const noexcept { return constant - 0.5 * (squares - slope * slope / weight); }
  /// ln of the integral over all levels.
  double integrated() const;
};

class CurveLikelihood {
public:
  CurveLikelihood(const std::vector<double>& depths, const std::vector<double>& forces);

  /// @param logModel  ln F of the model at the depths, in their order.
  LevelLikelihood of(const Eigen::VectorXd& logModel) const;

private:
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd logForce_;
  Eigen::VectorXd level_;  // of ones, whitened
  double constant_;
};

/// What the first depths of a curve say about a later one, for a given model.
struct Continuation {
  Eigen::VectorXd weights;  ///< Factors of the residuals ln F - ln F_model at the first depths.
  double deviation;         ///< Standard deviation of ln F at the later depth, these known.
};
Continuation continuationOf(const std::vector<double>& depths, const std::vector<double>& forces,
                            double laterDepth, double laterForce);

}  // namespace perilymph::validation

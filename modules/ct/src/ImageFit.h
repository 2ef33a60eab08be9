// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Analysis by synthesis: fits shape, pose, intensity levels and blur to the voxels near the wall.
//
//     I(x) = b + (f - b) min(1, sum over turns of Phi((d - sigma_n^2 / 2R) / sigma_n)),
//     sigma_n^2 = sigma_xy^2 (1 - n_z^2) + sigma_z^2 n_z^2
//
// with d the distance from the wall, positive in the lumen, R the section's mean radius of
// curvature, b and f the levels of bone and lumen, and n_z the component of the wall normal along
// the slice normal.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "LumenShape.h"
#include "MarkConstraint.h"
#include "Pieces.h"
#include "Pose.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// One voxel of the fit.
struct Observation {
  Eigen::Vector3d point_P;
  double intensity;
};

/// What a fit is to agree with: voxels, and landmarks that a person placed.
struct Observations {
  std::vector<Observation> voxels;
  std::vector<MarkConstraint> marks = {};
  double sampled = 1.0;  ///< Fraction of the voxels near the wall.
};

/// The fitted parameters.
struct FitState {
  Pose pose;
  ShapeVector shape = LumenShape::priorMean();
  double bone = 0.0, lumen = 0.0;             ///< Levels.
  double blurInPlane = 0.2, blurAxial = 0.2;  ///< Standard deviations of the PSF [mm].
};

/// Free parameters of a stage of the fit.
enum class Freedom {
  poseAndSize,  ///< Pose, the population's four parameters, rise, mean height of sections, levels.
  shape,        ///< Everything but the blur.
  everything,
};

struct FitSettings {
  Freedom freedom = Freedom::everything;
  int maxIterations = 20;
  double minBlur = 0.0;  ///< Lower bound of the blur, for annealing [mm].
  double band_mm = 1.0;  ///< Voxels farther from the wall are ignored.
};

struct FitResult {
  FitState state;
  double misfit = 1.0;    ///< Mean of min(1, (r / 0.3 contrast)^2) over the voxels of the band.
  double residual = 0.0;  ///< Robust standard deviation of r [intensity].
  double cost = 0.0;
  int iterations = 0;
  std::size_t voxels = 0;  ///< In the band, with nonzero weight.
  double sampled = 1.0;    ///< Fraction of the band's voxels that were used.
  /// Covariance of rotation and translation in W (6), then of the shape, assuming that residuals
  /// are independent between voxels.
  Eigen::MatrixXd covariance;
  /// Covariance of the same parameters due to the placement of landmarks.
  Eigen::MatrixXd markCovariance;
  /// Inverse of the normal matrix, priors included, for the same parameters.
  Eigen::MatrixXd posterior;
};

/// Number of parameters: 6 of the pose, the shape, 4 nuisance parameters.
inline constexpr int fitted = 6 + shape::count + 4;

class ImageFit {
public:
  /// @param sliceNormal_P  Unit vector of the axial blur.
  ImageFit(const LumenShape& family, const Eigen::Vector3d& sliceNormal_P,
           const Eigen::Vector2d& blurGuess_mm);

  /// Levenberg-Marquardt with Student-t weights from an initial state.
  FitResult run(const FitState& start, const Observations& observations,
                const FitSettings& settings, Threads threads) const;

  /// What the model shows at a point in W: 1 at the lumen's level, 0 at the bone's.
  double contentAt(const Eigen::Vector3d& point_W, const ShapedLumen& lumen,
                   const FitState& state) const;

private:
  struct Prediction;
  struct Normal;
  /// The image model and its derivatives at all voxels.
  Prediction predict(const FitState& state, const Observations& observations,
                     const FitSettings& settings, Threads threads) const;
  /// Weights of the voxels for a scale of the residuals, and the cost.
  void weigh(const FitState& state, const Observations& observations, double scale,
             Prediction& prediction, Threads threads) const;
  Normal normalOf(const FitState& state, const Observations& observations,
                  const Prediction& prediction, Threads threads) const;

  /// Logarithms of the blur's ratios to its guess, in plane and axial.
  std::array<double, 2> logBlurOf(const FitState& state) const;

  const LumenShape& family_;
  Eigen::Vector3d sliceNormal_P_;
  Eigen::Vector2d blurGuess_;
  Eigen::MatrixXd prior_;
  ShapeVector priorMean_;
};

/// The voxels within `reach_mm` of a state's wall, at most about `maxCount`: if there are more, a
/// quasi-random subset.
Observations observe(const CtVolume& volume, const LumenShape& family, const FitState& state,
                     double reach_mm, std::size_t maxCount, Threads threads);

}  // namespace perilymph::ct

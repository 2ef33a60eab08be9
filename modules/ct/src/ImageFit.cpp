// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "NormalDistribution.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double freedomOfStudent = 3.0;  // nu of the residuals' distribution
constexpr double innerWallWeight = 0.25;  // porous bone and the auditory canal are behind it
constexpr double innerWall = -0.62;       // in section widths from the outer wall
constexpr double vestibule_deg = 14.0;    // below this angle vestibule and round window change the
                                          // wall
constexpr double blurSpread = 0.25;       // prior of log sigma
constexpr double misfitScale = 0.3;       // residual that counts as unexplained [contrast]
// Model errors extend over patches of wall, so that voxels are not independent.
constexpr double dataWeight = 0.35;

/// A sparse row of derivatives.
class SparseRow {
public:
  double& operator[](int i)
  {
    if (!touched_[static_cast<std::size_t>(i)]) {
      touched_[static_cast<std::size_t>(i)] = true;
      indices_[static_cast<std::size_t>(count_++)] = i;
    }
    return values_[static_cast<std::size_t>(i)];
  }
  /// A view of the row from an index on.
  struct From {
    SparseRow& row;
    int first;
    double& operator[](int i) { return row[first + i]; }
  };
  void clear()
  {
    for (int i = 0; i < count_; ++i) {
      values_[static_cast<std::size_t>(indices_[static_cast<std::size_t>(i)])] = 0.0;
      touched_[static_cast<std::size_t>(indices_[static_cast<std::size_t>(i)])] = false;
    }
    count_ = 0;
  }
  void accumulate(double weight, double residual, Eigen::MatrixXd& matrix,
                  Eigen::VectorXd& right) const
  {
    // Whole columns, two rows at a time: what is not in the row adds zero.
    using Whole = Eigen::Matrix<double, fitted, 1>;
    const Whole weighted = weight * Eigen::Map<const Whole>(values_.data());
    right += residual * weighted;
    for (int a = 0; a < count_; ++a) {
      const int j = indices_[static_cast<std::size_t>(a)];
      matrix.col(j).tail(fitted - j) +=
          values_[static_cast<std::size_t>(j)] * weighted.tail(fitted - j);
    }
  }

private:
  std::array<double, fitted> values_{};
  std::array<bool, fitted> touched_{};
  std::array<int, fitted> indices_{};
  int count_ = 0;
};

constexpr int levels = 6 + shape::count;  // bone, lumen
constexpr int blurs = levels + 2;         // log sigma in plane, axial

/// Predicted intensity of one voxel.
struct Prediction {
  double intensity, weight, nearest;
};

double regionWeight(const TurnDistance& turn)
{
  if (turn.angle < degrees(vestibule_deg).si()) return 0.0;
  return turn.u < innerWall * turn.width ? innerWallWeight : 1.0;
}

}  // namespace

struct ImageFit::Normal {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(fitted, fitted);  ///< Lower triangle.
  Eigen::MatrixXd data;                                            ///< The matrix without priors.
  Eigen::VectorXd right = Eigen::VectorXd::Zero(fitted);
  double cost = 0.0, misfit = 0.0;
  std::vector<double> residuals;  ///< Residuals of the voxels with full weight.
  std::size_t voxels = 0;
};

ImageFit::ImageFit(const LumenShape& family, const Eigen::Vector3d& sliceNormal_P,
                   const Eigen::Vector2d& blurGuess_mm)
    : family_(family),
      sliceNormal_P_(sliceNormal_P),
      blurGuess_(blurGuess_mm),
      prior_(family.priorPrecision()),
      priorMean_(LumenShape::priorMean())
{
}

namespace {

/// Evaluates the image model at one point; fills the row if given.
Prediction synthesize(const LumenShape& family, const ShapedLumen& lumen, const FitState& state,
                      const FitSettings& settings, const Eigen::Vector3d& slice_W,
                      const Eigen::Vector3d& point_P, SparseRow* row)
{
  const Eigen::Vector3d point_W = state.pose.into_W(point_P);
  const NearTurns near = lumen.distances(point_W, settings.band_mm + 0.5);
  Prediction result{state.bone, 0.0, -10.0};
  if (near.nearest < 0) return result;
  const TurnDistance& nearest = near.turn[static_cast<std::size_t>(near.nearest)];
  result.nearest = nearest.inside;
  if (std::fabs(nearest.inside) > settings.band_mm) return result;
  result.weight = regionWeight(nearest);
  const double contrast = state.lumen - state.bone;
  const double inPlane = std::max(state.blurInPlane, settings.minBlur);
  const double axial = std::max(state.blurAxial, settings.minBlur);
  double occupancy = 0.0;
  for (int i = 0; i < near.count; ++i) {
    const TurnDistance& turn = near.turn[static_cast<std::size_t>(i)];
    const double along = turn.gradient.dot(slice_W);
    const double variance =
        inPlane * inPlane * std::max(0.0, 1.0 - along * along) + axial * axial * along * along;
    const double sigma = std::sqrt(variance);
    // Blur moves the half maximum of a convex lumen inward, by sigma^2 / (2 R) for a cylinder.
    const double x = (turn.inside - 0.5 * variance * turn.curvature) / sigma;
    occupancy += normalCumulative(x);
    if (row == nullptr) continue;
    const double slope = contrast * normalDensity(x) / sigma;
    // The point in W moves by -(shift) and by p x turn.
    const Eigen::Vector3d byTurn = turn.gradient.cross(point_W);
    for (int k = 0; k < 3; ++k) {
      (*row)[k] += slope * byTurn[k];
      (*row)[3 + k] -= slope * turn.gradient[k];
    }
    family.addDerivatives(turn, slope, SparseRow::From{*row, 6});
    const double bySigma = -slope * turn.inside / variance;
    (*row)[blurs] += bySigma * inPlane * inPlane * std::max(0.0, 1.0 - along * along);
    (*row)[blurs + 1] += bySigma * axial * axial * along * along;
  }
  if (occupancy > 1.0) {
    occupancy = 1.0;
    if (row != nullptr) row->clear();
  }
  if (row != nullptr) {
    (*row)[levels] += 1.0 - occupancy;
    (*row)[levels + 1] += occupancy;
  }
  result.intensity = state.bone + contrast * occupancy;
  return result;
}

}  // namespace

double ImageFit::contentAt(const Eigen::Vector3d& point_W, const ShapedLumen& lumen,
                           const FitState& state) const
{
  FitSettings settings;
  settings.band_mm = 3.0;  // of all of the lumen
  const Eigen::Vector3d slice_W = state.pose.axes_PW.transpose() * sliceNormal_P_;
  const Prediction shown =
      synthesize(family_, lumen, state, settings, slice_W, state.pose.outOf_W(point_W), nullptr);
  return (shown.intensity - state.bone) / (state.lumen - state.bone);
}

ImageFit::Normal ImageFit::assemble(const FitState& state, const Observations& observations,
                                    const FitSettings& settings, double scale) const
{
  Normal normal;
  const ShapedLumen lumen(family_, state.shape);
  const Eigen::Vector3d slice_W = state.pose.axes_PW.transpose() * sliceNormal_P_;
  const double contrast = std::fabs(state.lumen - state.bone);
  SparseRow row;
  double weightSum = 0.0;
  for (const Observation& observation : observations.voxels) {
    row.clear();
    const Prediction predicted =
        synthesize(family_, lumen, state, settings, slice_W, observation.point_P, &row);
    if (predicted.weight <= 0.0) continue;
    const double residual = observation.intensity - predicted.intensity;
    const double relative = residual / scale;
    const double student = (freedomOfStudent + 1.0) / (freedomOfStudent + relative * relative);
    const double weight = dataWeight * predicted.weight * student / (scale * scale);
    row.accumulate(weight, residual, normal.matrix, normal.right);
    normal.cost += dataWeight * predicted.weight * (freedomOfStudent + 1.0) *
                   logarithm(1.0 + relative * relative / freedomOfStudent);
    const double unexplained = residual / (misfitScale * contrast);
    normal.misfit += predicted.weight * std::min(1.0, unexplained * unexplained);
    weightSum += predicted.weight;
    if (predicted.weight >= 1.0) normal.residuals.push_back(std::fabs(residual));
    ++normal.voxels;
  }
  normal.misfit = weightSum > 0.0 ? normal.misfit / weightSum : 1.0;

  normal.data = normal.matrix;
  for (const MarkConstraint& mark : observations.marks) {
    const auto residual = residualOf(mark, family_, lumen, state.pose);
    if (!residual) continue;
    constexpr int n = 6 + shape::count;
    normal.matrix.topLeftCorner<n, n>() +=
        mark.precision * residual->row * residual->row.transpose();
    normal.right.head<n>() -= mark.precision * residual->value_mm * residual->row;
    normal.cost += mark.precision * residual->value_mm * residual->value_mm;
  }
  // Contribution of the prior.
  const Eigen::VectorXd off = state.shape - priorMean_;
  normal.matrix.block<shape::count, shape::count>(6, 6) += prior_;
  normal.right.segment<shape::count>(6) -= prior_ * off;
  normal.cost += off.dot(prior_ * off);
  const double logBlur[2] = {logarithm(state.blurInPlane / blurGuess_[0]),
                             logarithm(state.blurAxial / blurGuess_[1])};
  for (int i = 0; i < 2; ++i) {
    constexpr double precision = 1.0 / (blurSpread * blurSpread);
    normal.matrix(blurs + i, blurs + i) += precision;
    normal.right[blurs + i] -= precision * logBlur[i];
    normal.cost += precision * logBlur[i] * logBlur[i];
  }
  return normal;
}

namespace {

std::array<bool, fitted> movable(Freedom freedom)
{
  std::array<bool, fitted> can{};
  for (int i = 0; i < fitted; ++i) {
    const bool isSize = i < 6 + shape::width || (i >= levels && i < blurs);
    const bool isHeight = i >= 6 + shape::height && i < 6 + shape::radial;
    can[static_cast<std::size_t>(i)] = freedom == Freedom::everything ||
                                       (freedom == Freedom::shape && i < blurs) || isSize ||
                                       isHeight;
  }
  return can;
}

FitState stepped(const FitState& state, const Eigen::VectorXd& step)
{
  FitState next = state;
  next.pose = state.pose.moved(step.head<3>(), step.segment<3>(3));
  next.shape += step.segment<shape::count>(6);
  next.bone += step[levels];
  next.lumen += step[levels + 1];
  next.blurInPlane *= exponential(std::clamp(step[blurs], -0.3, 0.3));
  next.blurAxial *= exponential(std::clamp(step[blurs + 1], -0.3, 0.3));
  return next;
}

double medianOf(std::vector<double> values)
{
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

FitResult ImageFit::run(const FitState& start, const Observations& observations,
                        const FitSettings& settings) const
{
  const std::array<bool, fitted> can = movable(settings.freedom);
  FitResult result;
  result.state = start;
  constexpr double toDeviation = 1.4826;  // standard deviation of a normal distribution from the
                                          // median
  const double contrast = std::fabs(start.lumen - start.bone);
  double scale = 0.15 * contrast;
  Normal normal = assemble(result.state, observations, settings, scale);
  double damping = 1e-3;
  for (; result.iterations < settings.maxIterations; ++result.iterations) {
    // The scale follows the residuals for some iterations and is then fixed, so that the cost has a
    // minimum.
    if (result.iterations % 3 == 0 && result.iterations < 10) {
      scale = std::clamp(toDeviation * medianOf(normal.residuals), 0.03 * contrast, 0.3 * contrast);
      normal = assemble(result.state, observations, settings, scale);
    }
    Eigen::MatrixXd matrix = normal.matrix.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd right = normal.right;
    for (int i = 0; i < fitted; ++i) {
      if (can[static_cast<std::size_t>(i)]) {
        matrix(i, i) *= 1.0 + damping;
        matrix(i, i) += 1e-12;
        continue;
      }
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = 1.0;
      right[i] = 0.0;
    }
    Eigen::VectorXd step = matrix.ldlt().solve(right);
    if (!step.allFinite()) break;
    const double turn = step.head<3>().norm(), shift = step.segment<3>(3).norm();
    step *= std::min(1.0, std::min(0.2 / std::max(turn, 1e-9), 0.6 / std::max(shift, 1e-9)));
    const FitState next = stepped(result.state, step);
    Normal nextNormal = assemble(next, observations, settings, scale);
    // Voxels leaving the band change the total cost: compare means.
    const double before = normal.cost / std::max<double>(1.0, static_cast<double>(normal.voxels));
    const double after =
        nextNormal.cost / std::max<double>(1.0, static_cast<double>(nextNormal.voxels));
    if (after < before && nextNormal.voxels * 2 > normal.voxels) {
      result.state = next;
      normal = std::move(nextNormal);
      damping = std::max(1e-6, 0.3 * damping);
      if (before - after < 1e-6 * before && result.iterations > 10) break;
    } else {
      damping *= 8.0;
      if (damping > 1e4) break;
    }
  }
  result.cost = normal.cost;
  result.misfit = normal.misfit;
  result.voxels = normal.voxels;
  result.sampled = observations.sampled;
  result.residual = toDeviation * medianOf(normal.residuals);
  // The covariance due to noise: parameters change by H^-1 J^T W n; with W J^T J = D of one scale,
  Eigen::MatrixXd matrix = normal.matrix.selfadjointView<Eigen::Lower>();
  matrix.diagonal().array() += 1e-9;
  const Eigen::MatrixXd data = normal.data.selfadjointView<Eigen::Lower>();
  const Eigen::LDLT<Eigen::MatrixXd> solver(matrix);
  const Eigen::MatrixXd gain = solver.solve(data);
  constexpr int n = 6 + shape::count;
  result.covariance = dataWeight * solver.solve(gain.transpose()).topLeftCorner(n, n);
  result.posterior = solver.solve(Eigen::MatrixXd::Identity(fitted, fitted)).topLeftCorner(n, n);
  // Parameters change by H^-1 J^T P times the displacement of a mark.
  result.markCovariance = Eigen::MatrixXd::Zero(n, n);
  const ShapedLumen lumen(family_, result.state.shape);
  for (const MarkConstraint& mark : observations.marks) {
    const auto residual = residualOf(mark, family_, lumen, result.state.pose);
    if (!residual) continue;
    const Eigen::VectorXd change = mark.precision * mark.sd_mm * (result.posterior * residual->row);
    result.markCovariance += change * change.transpose();
  }
  return result;
}

Observations observe(const CtVolume& volume, const LumenShape& family, const FitState& state,
                     double reach_mm, std::size_t maxCount)
{
  const ShapedLumen lumen(family, state.shape);
  std::array<int, 3> low{}, high{};
  const Eigen::Vector3d center = volume.toIndex(state.pose.outOf_W({0.8, 0.0, 0.8}));
  const Eigen::Vector3d spacing = volume.spacing_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double radius = 7.5 / spacing[a];
    low[axis] = std::clamp(static_cast<int>(center[a] - radius), 0, volume.size()[axis] - 1);
    high[axis] = std::clamp(static_cast<int>(center[a] + radius), 0, volume.size()[axis] - 1);
  }
  std::vector<Observation> all;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        if (volume.voxel(i, j, k) == unmeasured) continue;
        const Eigen::Vector3d point_P = volume.toLps(Eigen::Vector3d(i, j, k));
        const Eigen::Vector3d point_W = state.pose.into_W(point_P);
        if (std::fabs(point_W.z() - 1.0) > 4.5) continue;
        const NearTurns near = lumen.distances(point_W, reach_mm);
        if (near.nearest < 0 ||
            std::fabs(near.turn[static_cast<std::size_t>(near.nearest)].inside) > reach_mm)
          continue;
        all.push_back({point_P, static_cast<double>(volume.voxel(i, j, k))});
      }
  if (all.size() <= maxCount) return {std::move(all), {}, 1.0};
  std::vector<Observation> some;
  const double keep = static_cast<double>(maxCount) / static_cast<double>(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    // Multiples of the golden ratio are equally distributed in [0, 1).
    const double x = 0.6180339887498949 * static_cast<double>(i);
    if (x - std::floor(x) < keep) some.push_back(all[i]);
  }
  return {std::move(some), {}, keep};
}

}  // namespace perilymph::ct

// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "NormalDistribution.h"
#include "perilymph/foundation/Four.h"
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
constexpr double blurPrecision = 1.0 / (blurSpread * blurSpread);
constexpr double misfitScale = 0.3;  // residual that counts as unexplained [contrast]
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
  int count() const { return count_; }
  /// The parameter of an entry, and its value.
  int index(int entry) const { return indices_[static_cast<std::size_t>(entry)]; }
  double value(int entry) const { return values_[static_cast<std::size_t>(index(entry))]; }

private:
  std::array<double, fitted> values_{};
  std::array<bool, fitted> touched_{};
  std::array<int, fitted> indices_{};
  int count_ = 0;
};

constexpr int levels = 6 + shape::count;  // bone, lumen
constexpr int blurs = levels + 2;         // log sigma in plane, axial

/// Predicted intensity of one voxel.
struct VoxelPrediction {
  double intensity, weight, nearest;
};

static_assert(fitted <= 256);

constexpr std::size_t rowsTogether = 256;  ///< Voxels of one piece of work.

/// The normal equations in columns, of which only the lower triangle is right, from rows and weights. Each
/// column is summed in the order of the voxels.
class Columns {
public:
  static constexpr std::size_t stride = (fitted + 3) / 4 * 4;

  std::array<double, stride * fitted> matrix{};
  std::array<double, stride> right{};

  /// Adds a row to the columns of one of several pieces.
  void add(const std::uint8_t* index, const double* value, std::size_t count, double weight,
           double residual, std::size_t piece, std::size_t pieces)
  {
    withLanes([&]() PERILYMPH_KERNEL {
      alignas(32) double weighted[stride] = {};
      for (std::size_t k = 0; k < count; ++k) weighted[index[k]] = weight * value[k];
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t j = index[k];
        if (j % pieces != piece) continue;
        right[j] += residual * weighted[j];
        double* const column = matrix.data() + stride * j;
        for (std::size_t i = j / 4 * 4; i < stride; i += 4)
          store(load<Four>(column, i) + value[k] * load<Four>(weighted, i), column, i);
      }
    });
  }
};

double regionWeight(const TurnDistance& turn)
{
  if (turn.angle < degrees(vestibule_deg).si()) return 0.0;
  return turn.u < innerWall * turn.width ? innerWallWeight : 1.0;
}

}  // namespace

/// The image model at the voxels of the band, in their order.
struct ImageFit::Prediction {
  struct Voxel {
    double residual, regionWeight;
    double weight = 0.0, cost = 0.0;  ///< For a scale.
  };
  /// Some voxels, and the entries of their rows one after another.
  struct Piece {
    std::vector<Voxel> voxels;
    std::vector<std::uint8_t> index;
    std::vector<double> value;
    std::vector<std::size_t> end;  ///< Where each voxel's entries end.
  };
  std::unique_ptr<const ShapedLumen> lumen;
  std::vector<Piece> pieces;
  std::vector<double> residuals;  ///< Residuals of the voxels with full weight.
  double misfit = 1.0;
  double cost = 0.0;  ///< For a scale.
  std::size_t voxels = 0;
};

struct ImageFit::Normal {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(fitted, fitted);  ///< Lower triangle.
  Eigen::MatrixXd data;                                            ///< The matrix without priors.
  Eigen::VectorXd right = Eigen::VectorXd::Zero(fitted);
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
VoxelPrediction synthesize(const LumenShape& family, const ShapedLumen& lumen,
                           const FitState& state, const FitSettings& settings,
                           const Eigen::Vector3d& slice_W, const Eigen::Vector3d& point_P,
                           SparseRow* row)
{
  const Eigen::Vector3d point_W = state.pose.into_W(point_P);
  const NearTurns near = lumen.distances(point_W, settings.band_mm + 0.5);
  VoxelPrediction result{state.bone, 0.0, -10.0};
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
  const VoxelPrediction shown =
      synthesize(family_, lumen, state, settings, slice_W, state.pose.outOf_W(point_W), nullptr);
  return (shown.intensity - state.bone) / (state.lumen - state.bone);
}

std::array<double, 2> ImageFit::logBlurOf(const FitState& state) const
{
  return {logarithm(state.blurInPlane / blurGuess_[0]), logarithm(state.blurAxial / blurGuess_[1])};
}

ImageFit::Prediction ImageFit::predict(const FitState& state, const Observations& observations,
                                       const FitSettings& settings, Threads threads) const
{
  Prediction prediction;
  prediction.lumen = std::make_unique<const ShapedLumen>(family_, state.shape);
  const Eigen::Vector3d slice_W = state.pose.axes_PW.transpose() * sliceNormal_P_;
  const std::vector<Observation>& voxels = observations.voxels;
  prediction.pieces.resize((voxels.size() + rowsTogether - 1) / rowsTogether);
  eachPiece(prediction.pieces.size(), threads, [&](std::size_t place) {
    Prediction::Piece& piece = prediction.pieces[place];
    SparseRow row;
    const std::size_t end = std::min(voxels.size(), (place + 1) * rowsTogether);
    constexpr std::size_t ofOneTurn = 36;  // entries of a row; there are 43 beside a second turn
    piece.voxels.reserve(rowsTogether);
    piece.end.reserve(rowsTogether);
    piece.index.reserve(rowsTogether * ofOneTurn);
    piece.value.reserve(rowsTogether * ofOneTurn);
    for (std::size_t i = place * rowsTogether; i < end; ++i) {
      row.clear();
      const VoxelPrediction predicted =
          synthesize(family_, *prediction.lumen, state, settings, slice_W, voxels[i].point_P, &row);
      if (predicted.weight <= 0.0) continue;
      piece.voxels.push_back({voxels[i].intensity - predicted.intensity, predicted.weight});
      for (int k = 0; k < row.count(); ++k) {
        piece.index.push_back(static_cast<std::uint8_t>(row.index(k)));
        piece.value.push_back(row.value(k));
      }
      piece.end.push_back(piece.value.size());
    }
  });
  const double contrast = std::fabs(state.lumen - state.bone);
  double weightSum = 0.0, misfit = 0.0;
  for (const Prediction::Piece& piece : prediction.pieces)
    for (const Prediction::Voxel& voxel : piece.voxels) {
      const double unexplained = voxel.residual / (misfitScale * contrast);
      misfit += voxel.regionWeight * std::min(1.0, unexplained * unexplained);
      weightSum += voxel.regionWeight;
      if (voxel.regionWeight >= 1.0) prediction.residuals.push_back(std::fabs(voxel.residual));
      ++prediction.voxels;
    }
  prediction.misfit = weightSum > 0.0 ? misfit / weightSum : 1.0;
  return prediction;
}

void ImageFit::weigh(const FitState& state, const Observations& observations, double scale,
                     Prediction& prediction, Threads threads) const
{
  eachPiece(prediction.pieces.size(), threads, [&](std::size_t place) {
    for (Prediction::Voxel& voxel : prediction.pieces[place].voxels) {
      const double relative = voxel.residual / scale;
      const double student = (freedomOfStudent + 1.0) / (freedomOfStudent + relative * relative);
      voxel.weight = dataWeight * voxel.regionWeight * student / (scale * scale);
      voxel.cost = dataWeight * voxel.regionWeight * (freedomOfStudent + 1.0) *
                   logarithm(1.0 + relative * relative / freedomOfStudent);
    }
  });
  double& cost = prediction.cost = 0.0;
  for (const Prediction::Piece& piece : prediction.pieces)
    for (const Prediction::Voxel& voxel : piece.voxels) cost += voxel.cost;
  for (const MarkConstraint& mark : observations.marks)
    if (const auto residual = residualOf(mark, family_, *prediction.lumen, state.pose))
      cost += mark.precision * residual->value_mm * residual->value_mm;
  const Eigen::VectorXd off = state.shape - priorMean_;
  cost += off.dot(prior_ * off);
  for (const double logBlur : logBlurOf(state)) cost += blurPrecision * logBlur * logBlur;
}

ImageFit::Normal ImageFit::normalOf(const FitState& state, const Observations& observations,
                                    const Prediction& prediction, Threads threads) const
{
  const auto columns = std::make_unique<Columns>();
  const std::size_t pieces = threads == Threads::one ? 1 : processors();
  eachPiece(pieces, threads, [&](std::size_t piece) {
    for (const Prediction::Piece& each : prediction.pieces) {
      std::size_t first = 0;
      for (std::size_t i = 0; i < each.voxels.size(); ++i) {
        const std::size_t end = each.end[i];
        columns->add(each.index.data() + first, each.value.data() + first, end - first,
                     each.voxels[i].weight, each.voxels[i].residual, piece, pieces);
        first = end;
      }
    }
  });
  Normal normal;
  for (int j = 0; j < fitted; ++j) {
    const auto column = static_cast<std::size_t>(j) * Columns::stride;
    for (int i = j; i < fitted; ++i)
      normal.matrix(i, j) = columns->matrix[column + static_cast<std::size_t>(i)];
    normal.right[j] = columns->right[static_cast<std::size_t>(j)];
  }

  normal.data = normal.matrix;
  for (const MarkConstraint& mark : observations.marks) {
    const auto residual = residualOf(mark, family_, *prediction.lumen, state.pose);
    if (!residual) continue;
    constexpr int n = 6 + shape::count;
    normal.matrix.topLeftCorner<n, n>() +=
        mark.precision * residual->row * residual->row.transpose();
    normal.right.head<n>() -= mark.precision * residual->value_mm * residual->row;
  }
  // Contribution of the prior.
  const Eigen::VectorXd off = state.shape - priorMean_;
  normal.matrix.block<shape::count, shape::count>(6, 6) += prior_;
  normal.right.segment<shape::count>(6) -= prior_ * off;
  const std::array<double, 2> logBlur = logBlurOf(state);
  for (int i = 0; i < 2; ++i) {
    normal.matrix(blurs + i, blurs + i) += blurPrecision;
    normal.right[blurs + i] -= blurPrecision * logBlur[static_cast<std::size_t>(i)];
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
                        const FitSettings& settings, Threads threads) const
{
  const std::array<bool, fitted> can = movable(settings.freedom);
  FitResult result;
  result.state = start;
  constexpr double toDeviation = 1.4826;  // standard deviation of a normal distribution from the
                                          // median
  const double contrast = std::fabs(start.lumen - start.bone);
  double scale = 0.15 * contrast;
  Prediction shown = predict(result.state, observations, settings, threads);
  Normal normal;
  const auto weighAgain = [&] {
    weigh(result.state, observations, scale, shown, threads);
    normal = normalOf(result.state, observations, shown, threads);
  };
  if (settings.maxIterations == 0) weighAgain();
  double damping = 1e-3;
  for (; result.iterations < settings.maxIterations; ++result.iterations) {
    // The scale follows the residuals for some iterations and is then fixed, so that the cost has a
    // minimum.
    if (result.iterations % 3 == 0 && result.iterations < 10) {
      scale = std::clamp(toDeviation * medianOf(shown.residuals), 0.03 * contrast, 0.3 * contrast);
      weighAgain();
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
    Prediction nextShown = predict(next, observations, settings, threads);
    weigh(next, observations, scale, nextShown, threads);
    // Voxels leaving the band change the total cost: compare means.
    const double before = shown.cost / std::max<double>(1.0, static_cast<double>(shown.voxels));
    const double after =
        nextShown.cost / std::max<double>(1.0, static_cast<double>(nextShown.voxels));
    if (after < before && nextShown.voxels * 2 > shown.voxels) {
      result.state = next;
      shown = std::move(nextShown);
      normal = normalOf(result.state, observations, shown, threads);
      damping = std::max(1e-6, 0.3 * damping);
      if (before - after < 1e-6 * before && result.iterations > 10) break;
    } else {
      damping *= 8.0;
      if (damping > 1e4) break;
    }
  }
  result.cost = shown.cost;
  result.misfit = shown.misfit;
  result.voxels = shown.voxels;
  result.sampled = observations.sampled;
  result.residual = toDeviation * medianOf(shown.residuals);
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
  for (const MarkConstraint& mark : observations.marks) {
    const auto residual = residualOf(mark, family_, *shown.lumen, result.state.pose);
    if (!residual) continue;
    const Eigen::VectorXd change = mark.precision * mark.sd_mm * (result.posterior * residual->row);
    result.markCovariance += change * change.transpose();
  }
  return result;
}

Observations observe(const CtVolume& volume, const LumenShape& family, const FitState& state,
                     double reach_mm, std::size_t maxCount, Threads threads)
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
  std::vector<std::vector<Observation>> inSlice(static_cast<std::size_t>(high[2] - low[2] + 1));
  eachPiece(inSlice.size(), threads, [&](std::size_t slice) {
    const int k = low[2] + static_cast<int>(slice);
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        if (volume.voxel(i, j, k) == unmeasured) continue;
        const Eigen::Vector3d point_P = volume.toLps(Eigen::Vector3d(i, j, k));
        const Eigen::Vector3d point_W = state.pose.into_W(point_P);
        if (std::fabs(point_W.z() - 1.0) > 4.5) continue;
        const std::optional<double> inside = lumen.inside(point_W, reach_mm);
        if (!inside || std::fabs(*inside) > reach_mm) continue;
        inSlice[slice].push_back({point_P, static_cast<double>(volume.voxel(i, j, k))});
      }
  });
  std::vector<Observation> all;
  for (const std::vector<Observation>& each : inSlice)
    all.insert(all.end(), each.begin(), each.end());
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

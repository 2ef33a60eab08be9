// SPDX-License-Identifier: BSD-3-Clause

// Forces behind the depths that were fitted, by the capstan law and by a constant ratio of the media.

#include <algorithm>
#include <cmath>

#include "BenchFit.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::validation {

namespace {

/// Sums over geometries with the shape that the friction in soap gives to all curves: rows are arrays,
/// columns the frictions in soap, over exp(shift()). Curves other than soap have free levels.
Eigen::MatrixXd constantRatioEvidence(const SpecimenFit& specimen)
{
  Eigen::MatrixXd sums =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(grid::shapes * grid::levels),
                            static_cast<Eigen::Index>(grid::frictions));
  for (std::size_t shape = 0; shape < grid::shapes; ++shape)
    for (std::size_t geometry = 0; geometry < grid::geometries; ++geometry)
      for (std::size_t friction = 0; friction < grid::frictions; ++friction) {
        double others = 1.0;
        const CurveFit* soap = nullptr;
        for (const CurveFit& curve : specimen.curves())
          if (curve.medium == BenchMedium::soap)
            soap = &curve;
          else
            others *= exponential(curve.at(shape, geometry, friction).integrated() - curve.shift);
        for (std::size_t level = 0; level < grid::levels; ++level) {
          const double own =
              soap == nullptr
                  ? 1.0
                  : exponential(soap->at(shape, geometry, friction).at(grid::logStiffness(level)) -
                                soap->shift);
          sums(static_cast<Eigen::Index>(shape * grid::levels + level),
               static_cast<Eigen::Index>(friction)) += own * others;
        }
      }
  return sums;
}

/// The distribution of ln F as a sum of normal ones with equal deviation.
class Mixture {
public:
  void add(double mean, double weight)
  {
    const double bin = std::clamp((mean - low) / width, 0.0, static_cast<double>(bins - 1));
    weights_[static_cast<std::size_t>(bin)] += weight;
  }

  /// Quantiles [N] of the mixture with this deviation.
  std::vector<double> quantiles(double deviation, const std::vector<double>& fractions) const
  {
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(5.0 * deviation / width));
    std::vector<double> spread(bins, 0.0);
    for (std::ptrdiff_t apart = -reach; apart <= reach; ++apart) {
      const double x = width * static_cast<double>(apart) / deviation;
      const double kernel = exponential(-0.5 * x * x);
      for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(bins); ++i) {
        const std::ptrdiff_t to = std::clamp<std::ptrdiff_t>(i + apart, 0, bins - 1);
        spread[static_cast<std::size_t>(to)] += kernel * weights_[static_cast<std::size_t>(i)];
      }
    }
    double all = 0.0;
    for (const double each : spread) all += each;
    std::vector<double> values;
    for (const double fraction : fractions) {
      double sum = 0.0;
      std::size_t i = 0;
      while (i + 1 < bins && sum + spread[i] < fraction * all) sum += spread[i++];
      const double within = spread[i] > 0.0 ? (fraction * all - sum) / spread[i] : 0.5;
      values.push_back(exponential(low + width * (static_cast<double>(i) + within)));
    }
    return values;
  }

private:
  static constexpr double low = -9.0, width = 0.01;  // 0.1 mN to 1 N
  static constexpr std::size_t bins = 900;
  std::vector<double> weights_ = std::vector<double>(bins, 0.0);
};

/// A later force of a curve, and how it continues the fit.
struct Later {
  std::size_t curve;
  double depth, force;
  Continuation continuation;
  Mixture mixture;
};

std::vector<Later> laterForces(const BenchSpecimen& specimen, const SpecimenFit& fit)
{
  std::vector<Later> later;
  for (std::size_t i = 0; i < specimen.curves.size(); ++i) {
    const BenchCurve& curve = specimen.curves[i];
    const CurveFit& fitted = fit.curves()[i];
    const std::vector<double> depths = depthsWithin(curve, shallowest, deepestFitted);
    for (std::size_t k = 0; k < curve.depths.size(); ++k) {
      const double depth = curve.depths[k];
      if (depth <= fitted.depths.back() || depth > depths.back()) continue;
      later.push_back({i,
                       depth,
                       curve.forces[k],
                       continuationOf(fitted.depths, fitted.forces, depth, curve.forces[k]),
                       {}});
    }
  }
  return later;
}

void addCells(std::vector<Later>& later, const SpecimenFit& fit, const ShapeTable& table,
              const Eigen::VectorXd& arrays)
{
  // ln F later = base + free level, both over shape, geometry and friction
  std::vector<std::vector<double>> bases(later.size());
  for (std::size_t i = 0; i < later.size(); ++i) {
    const CurveFit& curve = fit.curves()[later[i].curve];
    Eigen::VectorXd measured(static_cast<Eigen::Index>(curve.forces.size()));
    for (std::size_t k = 0; k < curve.forces.size(); ++k)
      measured(static_cast<Eigen::Index>(k)) = logarithm(curve.forces[k]);
    for (std::size_t shape = 0; shape < grid::shapes; ++shape)
      for (std::size_t geometry = 0; geometry < grid::geometries; ++geometry)
        for (std::size_t friction = 0; friction < grid::frictions; ++friction)
          bases[i].push_back(table.at(shape, geometry, friction, later[i].depth) +
                             later[i].continuation.weights.dot(
                                 measured - table.at(shape, geometry, friction, curve.depths)));
  }
  fit.forEachCell([&](std::size_t array, std::size_t geometry, const Eigen::MatrixXd& cell) {
    const double weight = arrays(static_cast<Eigen::Index>(array));
    if (!(weight > 0.0)) return;
    const Eigen::VectorXd others = productsOfOthers(cell);
    const std::size_t shape = array / grid::levels;
    const double level = grid::logStiffness(array % grid::levels);
    for (std::size_t i = 0; i < later.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(later[i].curve);
      const double common = weight * others(column);
      if (!(common > 0.0)) continue;
      const double shifted = level * (1.0 - later[i].continuation.weights.sum());
      const std::size_t row = (shape * grid::geometries + geometry) * grid::frictions;
      for (std::size_t friction = 0; friction < grid::frictions; ++friction)
        later[i].mixture.add(bases[i][row + friction] + shifted,
                             common * cell(static_cast<Eigen::Index>(friction), column));
    }
  });
}

}  // namespace

std::vector<ModelScore> scoresOf(const BenchFits& fits)
{
  const Eigen::VectorXd soap = grid::soapPrior();
  std::vector<ModelScore> scores;
  Eigen::VectorXd arrays;
  Eigen::MatrixXd arraysByRatio;
  for (std::size_t k = 0; k < fits.specimens.size(); ++k) {
    const SpecimenFit &before = fits.before[k], &all = fits.all[k];
    const Eigen::VectorXd beforeSums = before.evidence(), allSums = all.evidence();
    const Eigen::MatrixXd beforeRatio = constantRatioEvidence(before);
    const Eigen::MatrixXd allRatio = constantRatioEvidence(all);
    const bool isFirst = k == 0;
    if (isFirst) {
      arrays = Eigen::VectorXd::Ones(beforeSums.size());
      arraysByRatio = Eigen::MatrixXd::Ones(beforeRatio.rows(), beforeRatio.cols());
    }
    const double shifted = all.shift() - before.shift();
    const auto ratioSum = [&](const Eigen::MatrixXd& sums) {
      return (arraysByRatio.cwiseProduct(sums) * soap).sum();
    };
    ModelScore score;
    score.specimen = fits.specimens[k].name;
    for (std::size_t i = 0; i < all.curves().size(); ++i)
      score.forces += all.curves()[i].depths.size() - before.curves()[i].depths.size();
    score.capstan = shifted + logarithm(arrays.dot(allSums)) - logarithm(arrays.dot(beforeSums));
    score.constantRatio =
        shifted + logarithm(ratioSum(allRatio)) - logarithm(ratioSum(beforeRatio));
    scores.push_back(score);
    if (isFirst) {
      arrays = beforeSums;
      arraysByRatio = beforeRatio;
    }
  }
  return scores;
}

std::vector<PredictedForce> predictionsOf(const BenchFits& fits)
{
  std::vector<PredictedForce> predicted;
  Eigen::VectorXd arrays =
      Eigen::VectorXd::Ones(static_cast<Eigen::Index>(grid::shapes * grid::levels));
  for (std::size_t k = 0; k < fits.specimens.size(); ++k) {
    const BenchSpecimen& specimen = fits.specimens[k];
    const SpecimenFit& fit = fits.before[k];
    std::vector<Later> later = laterForces(specimen, fit);
    addCells(later, fit, fits.table, arrays);
    for (const Later& each : later) {
      const std::vector<double> quantiles =
          each.mixture.quantiles(each.continuation.deviation, {0.05, 0.5, 0.95});
      predicted.push_back({specimen.name, specimen.curves[each.curve].medium, each.depth,
                           each.force, quantiles[1], quantiles[0], quantiles[2]});
    }
    if (k == 0) arrays = fit.evidence();
  }
  return predicted;
}

}  // namespace perilymph::validation

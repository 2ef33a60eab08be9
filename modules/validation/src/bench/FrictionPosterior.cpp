// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "BenchFit.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::validation {

namespace {

constexpr std::array<double, 6> betweenSpecimens{0.05, 0.1, 0.2, 0.3, 0.5, 0.8};

/// Quantile of weights on the friction's grid, each spread evenly over its step.
double frictionQuantile(const Eigen::VectorXd& weights, double fraction)
{
  const double wanted = fraction * weights.sum();
  double sum = 0.0;
  Eigen::Index i = 0;
  while (i + 1 < weights.size() && sum + weights(i) < wanted) sum += weights(i++);
  const double within = weights(i) > 0.0 ? (wanted - sum) / weights(i) : 0.5;
  return exponential(grid::logFriction(static_cast<std::size_t>(i)) +
                     grid::logStep * (within - 0.5));
}

Estimate estimateOf(const Eigen::VectorXd& weights)
{
  return {frictionQuantile(weights, 0.5), frictionQuantile(weights, 0.025),
          frictionQuantile(weights, 0.975)};
}

/// Friction of every curve of a specimen, with these weights of the arrays.
std::vector<MediumFriction> frictionsOf(const BenchSpecimen& specimen, const SpecimenFit& fit,
                                        const Eigen::VectorXd& arrays)
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(grid::frictions),
                                               static_cast<Eigen::Index>(fit.curves().size()));
  fit.forEachCell([&](std::size_t array, std::size_t, const Eigen::MatrixXd& cell) {
    const Eigen::VectorXd others = productsOfOthers(cell);
    sums += arrays(static_cast<Eigen::Index>(array)) * cell * others.asDiagonal();
  });
  std::vector<MediumFriction> media;
  for (Eigen::Index i = 0; i < sums.cols(); ++i) {
    const Eigen::VectorXd weights = sums.col(i) / sums.col(i).sum();
    media.push_back({specimen.name,
                     specimen.curves[static_cast<std::size_t>(i)].medium,
                     estimateOf(weights),
                     {weights.data(), weights.data() + weights.size()}});
  }
  return media;
}

/// Weights of a specimen's friction (columns) for each median and deviation of their distribution.
Eigen::MatrixXd hyperWeights()
{
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(grid::frictions * betweenSpecimens.size()),
                          static_cast<Eigen::Index>(grid::frictions));
  for (Eigen::Index row = 0; row < weights.rows(); ++row) {
    const auto median = static_cast<std::size_t>(row) % grid::frictions;
    const double deviation = betweenSpecimens[static_cast<std::size_t>(row) / grid::frictions];
    for (Eigen::Index i = 0; i < weights.cols(); ++i) {
      const double x =
          (grid::logFriction(static_cast<std::size_t>(i)) - grid::logFriction(median)) / deviation;
      weights(row, i) = exponential(-0.5 * x * x);
    }
    weights.row(row) /= weights.row(row).sum();
  }
  return weights;
}

/// For one array, the likelihood of a specimen over the hyperparameters (rows) and the friction of
/// PTFE in saline (columns), which all channels share.
Eigen::MatrixXd likelihoodOfSpecimen(const SpecimenFit& fit, const Eigen::MatrixXd& hyper,
                                     std::size_t shape, std::size_t level)
{
  const auto tissue = static_cast<Eigen::Index>(fit.indexOf(BenchMedium::tissue));
  const auto saline = static_cast<Eigen::Index>(fit.indexOf(BenchMedium::saline));
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(hyper.cols(), hyper.cols());
  for (std::size_t geometry = 0; geometry < grid::geometries; ++geometry) {
    const Eigen::MatrixXd cell = fit.cell(shape, geometry, level);
    double others = 1.0;
    for (Eigen::Index i = 0; i < cell.cols(); ++i)
      if (i != tissue && i != saline) others *= cell.col(i).sum();
    together += (others * cell.col(tissue)) * cell.col(saline).transpose();
  }
  return hyper * together;
}

TissueFriction tissueOf(const std::string& specimens, const Eigen::VectorXd& posterior,
                        const Eigen::MatrixXd& hyper)
{
  TissueFriction tissue;
  tissue.specimens = specimens;
  Eigen::VectorXd medians = Eigen::VectorXd::Zero(hyper.cols());
  for (Eigen::Index row = 0; row < posterior.size(); ++row) {
    const auto count = static_cast<Eigen::Index>(grid::frictions);
    medians(row % count) += posterior(row);
    tissue.between += posterior(row) * betweenSpecimens[static_cast<std::size_t>(row / count)];
  }
  tissue.between /= posterior.sum();
  tissue.median = estimateOf(medians);
  tissue.further = estimateOf(hyper.transpose() * posterior);
  return tissue;
}

/// Tissue over the specimens that the authors call good, and over all.
std::vector<TissueFriction> tissueOverSpecimens(const std::vector<BenchSpecimen>& specimens,
                                                const std::vector<SpecimenFit>& fits)
{
  const Eigen::MatrixXd hyper = hyperWeights();
  Eigen::VectorXd good = Eigen::VectorXd::Zero(hyper.rows()), all = good;
  for (std::size_t shape = 0; shape < grid::shapes; ++shape)
    for (std::size_t level = 0; level < grid::levels; ++level) {
      Eigen::MatrixXd ofGood = Eigen::MatrixXd::Ones(hyper.rows(), hyper.cols());
      Eigen::MatrixXd ofPoor = ofGood;
      for (std::size_t k = 0; k < fits.size(); ++k)
        (specimens[k].isPoor ? ofPoor : ofGood).array() *=
            likelihoodOfSpecimen(fits[k], hyper, shape, level).array();
      good += ofGood.rowwise().sum();
      all += ofGood.cwiseProduct(ofPoor).rowwise().sum();
    }
  std::string goodNames, allNames;
  for (const BenchSpecimen& each : specimens) {
    allNames += (allNames.empty() ? "" : " ") + each.name;
    if (!each.isPoor) goodNames += (goodNames.empty() ? "" : " ") + each.name;
  }
  std::vector<TissueFriction> tissue = {tissueOf(goodNames, good, hyper)};
  if (allNames != goodNames) tissue.push_back(tissueOf(allNames, all, hyper));
  return tissue;
}

}  // namespace

BenchResult inferFriction(const std::vector<BenchSpecimen>& specimens)
{
  std::vector<double> depths;
  for (const BenchSpecimen& specimen : specimens)
    for (const BenchCurve& curve : specimen.curves)
      for (const double depth : depthsWithin(curve, shallowest, deepestFitted))
        depths.push_back(depth);
  const ShapeTable table(depths);

  BenchResult result;
  for (std::size_t i = 0; i < grid::frictions; ++i)
    result.frictions.push_back(exponential(grid::logFriction(i)));

  BenchFits both{specimens, table, {}, {}};
  for (const BenchSpecimen& specimen : specimens) {
    both.before.emplace_back(specimen, table, deepestForPrediction);
    both.all.emplace_back(specimen, table, deepestFitted);
  }
  const std::vector<SpecimenFit>& fits = both.all;
  const SpecimenFit& first = fits.front();
  result.media =
      frictionsOf(specimens.front(), first,
                  Eigen::VectorXd::Ones(static_cast<Eigen::Index>(grid::shapes * grid::levels)));
  const Eigen::VectorXd arrays = first.evidence();
  for (std::size_t k = 1; k < fits.size(); ++k)
    for (MediumFriction& each : frictionsOf(specimens[k], fits[k], arrays))
      result.pairs.push_back(std::move(each));
  result.tissue = tissueOverSpecimens(specimens, fits);

  Eigen::Index best = 0;
  arrays.maxCoeff(&best);
  const auto array = static_cast<std::size_t>(best);
  result.tipStiffness = exponential(grid::logStiffness(array % grid::levels));
  result.growth = grid::growths[array / grid::levels / grid::tipCotangents.size()];

  result.predicted = predictionsOf(both);
  result.scores = scoresOf(both);
  return result;
}

}  // namespace perilymph::validation

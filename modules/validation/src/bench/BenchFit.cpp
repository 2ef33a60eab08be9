// SPDX-License-Identifier: BSD-3-Clause
#include "BenchFit.h"

#include <algorithm>
#include <cmath>

#include "RodInChannel.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::validation {

namespace grid {

double logStiffness(std::size_t level)
{
  return logarithm(1e-9) + logStep * static_cast<double>(level);
}

double logFriction(std::size_t friction)
{
  return logarithm(0.01) + logStep * static_cast<double>(friction);
}

Eigen::VectorXd soapPrior()
{
  const double low = logarithm(0.0395), high = logarithm(0.0605);
  const double deviation = (high - low) / (2.0 * 1.96);
  Eigen::VectorXd prior(static_cast<Eigen::Index>(frictions));
  for (std::size_t i = 0; i < frictions; ++i) {
    const double x = (logFriction(i) - 0.5 * (low + high)) / deviation;
    prior(static_cast<Eigen::Index>(i)) = exponential(-0.5 * x * x);
  }
  return prior / prior.sum();
}

}  // namespace grid

ShapeTable::ShapeTable(std::vector<double> depths) : depths_(std::move(depths))
{
  using namespace grid;
  std::sort(depths_.begin(), depths_.end());
  depths_.erase(std::unique(depths_.begin(), depths_.end()), depths_.end());
  values_.resize(shapes * geometries * frictions * depths_.size());
  std::size_t geometry = 0;
  for (const double radius : radii_mm)
    for (const double tightening : tightenings_per_mm)
      for (const double start : starts_mm) {
        const SpiralChannel channel{1e-3 * radius, 1e3 * tightening, 1e-3 * start};
        for (std::size_t friction = 0; friction < frictions; ++friction) {
          const ChannelForce force(channel, exponential(logFriction(friction)), depths_.back());
          std::vector<ChannelForce::Parts> parts;
          for (const double depth : depths_) parts.push_back(force.at(depth));
          std::size_t shape = 0;
          for (const double growth : growths)
            for (const double cotangent : tipCotangents) {
              const std::size_t row = (shape * geometries + geometry) * frictions + friction;
              for (std::size_t i = 0; i < depths_.size(); ++i)
                values_[row * depths_.size() + i] = logarithm(parts[i].force(growth, cotangent));
              ++shape;
            }
        }
        ++geometry;
      }
}

double ShapeTable::at(std::size_t shape, std::size_t geometry, std::size_t friction,
                      double depth) const
{
  const auto place = std::lower_bound(depths_.begin(), depths_.end(), depth) - depths_.begin();
  const std::size_t row = (shape * grid::geometries + geometry) * grid::frictions + friction;
  return values_[row * depths_.size() + static_cast<std::size_t>(place)];
}

Eigen::VectorXd ShapeTable::at(std::size_t shape, std::size_t geometry, std::size_t friction,
                               const std::vector<double>& depths) const
{
  Eigen::VectorXd values(static_cast<Eigen::Index>(depths.size()));
  for (std::size_t i = 0; i < depths.size(); ++i)
    values(static_cast<Eigen::Index>(i)) = at(shape, geometry, friction, depths[i]);
  return values;
}

std::vector<double> depthsWithin(const BenchCurve& curve, double low, double high)
{
  constexpr double slack = 1e-6;
  std::vector<double> depths;
  for (const double depth : curve.depths)
    if (depth >= low - slack && depth <= high + slack) depths.push_back(depth);
  return depths;
}

SpecimenFit::SpecimenFit(const BenchSpecimen& specimen, const ShapeTable& table, double deepest)
{
  for (const BenchCurve& curve : specimen.curves) {
    CurveFit fit;
    fit.medium = curve.medium;
    fit.depths = depthsWithin(curve, shallowest, deepest);
    for (std::size_t i = 0; i < curve.depths.size(); ++i)
      if (std::find(fit.depths.begin(), fit.depths.end(), curve.depths[i]) != fit.depths.end())
        fit.forces.push_back(curve.forces[i]);
    const CurveLikelihood likelihood(fit.depths, fit.forces);
    for (std::size_t shape = 0; shape < grid::shapes; ++shape)
      for (std::size_t geometry = 0; geometry < grid::geometries; ++geometry)
        for (std::size_t friction = 0; friction < grid::frictions; ++friction)
          fit.table.push_back(likelihood.of(table.at(shape, geometry, friction, fit.depths)));
    fit.shift = fit.table.front().best();
    for (const LevelLikelihood& each : fit.table) fit.shift = std::max(fit.shift, each.best());
    curves_.push_back(std::move(fit));
  }
}

std::size_t SpecimenFit::indexOf(BenchMedium medium) const
{
  std::size_t index = 0;
  while (index < curves_.size() && curves_[index].medium != medium) ++index;
  return index;
}

double SpecimenFit::shift() const
{
  double sum = 0.0;
  for (const CurveFit& curve : curves_) sum += curve.shift;
  return sum;
}

Eigen::MatrixXd SpecimenFit::cell(std::size_t shape, std::size_t geometry, std::size_t level) const
{
  static const Eigen::VectorXd soap = grid::soapPrior();
  constexpr double flat = 1.0 / static_cast<double>(grid::frictions);
  Eigen::MatrixXd likelihood(static_cast<Eigen::Index>(grid::frictions),
                             static_cast<Eigen::Index>(curves_.size()));
  const double logStiffness = grid::logStiffness(level);
  constexpr double negligible = -30.0;
  for (Eigen::Index column = 0; column < likelihood.cols(); ++column) {
    const CurveFit& curve = curves_[static_cast<std::size_t>(column)];
    for (Eigen::Index row = 0; row < likelihood.rows(); ++row) {
      const double prior = curve.medium == BenchMedium::soap ? soap(row) : flat;
      const LevelLikelihood& each = curve.at(shape, geometry, static_cast<std::size_t>(row));
      const double exponent = each.at(logStiffness) - curve.shift;
      likelihood(row, column) = exponent > negligible ? prior * exponential(exponent) : 0.0;
    }
  }
  return likelihood;
}

Eigen::VectorXd SpecimenFit::evidence() const
{
  Eigen::VectorXd sums =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(grid::shapes * grid::levels));
  forEachCell([&](std::size_t array, std::size_t, const Eigen::MatrixXd& cell) {
    sums(static_cast<Eigen::Index>(array)) += cell.colwise().sum().prod();
  });
  return sums;
}

Eigen::VectorXd productsOfOthers(const Eigen::MatrixXd& cell)
{
  const Eigen::VectorXd sums = cell.colwise().sum();
  Eigen::VectorXd products = Eigen::VectorXd::Ones(sums.size());
  for (Eigen::Index i = 0; i < sums.size(); ++i)
    for (Eigen::Index k = 0; k < sums.size(); ++k)
      if (k != i) products(i) *= sums(k);
  return products;
}

}  // namespace perilymph::validation

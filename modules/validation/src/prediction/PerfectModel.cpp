// SPDX-License-Identifier: BSD-3-Clause

// How many rows of the clinical table a perfect model would meet, by simulation of the rule.

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/validation/ClinicalPrediction.h"
#include "prediction/PublishedClinic.h"

namespace perilymph::validation {

namespace {

constexpr int replicates = 2000;  // the number of hits is known to 0.03
constexpr std::uint64_t perfectSeed = 1;
enum class PerfectDraw : std::uint64_t { friction = 200, insertions, clinics };

using analysis::RandomStream;

std::size_t anyOf(RandomStream& random, std::size_t count)
{
  return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(count)),
                  count - 1);
}

/// The insertions of an array, and the clinics that publish its depth.
struct AngleTruth {
  std::vector<PublishedSample> samples;
  double betweenCenters = 0.0;
  SimulatedSample simulated;
  std::vector<double> residual;  ///< Angles without the effect of the shared friction [deg].
  double slope = 0.0;            ///< [deg]

  /// One clinic's sample, if the simulated insertions are the truth at a shared friction.
  PublishedSample draw(const PublishedSample& like, double friction, RandomStream& random) const
  {
    const double shift = slope * friction + betweenCenters * random.normal();
    std::vector<double> values(static_cast<std::size_t>(like.count));
    for (double& value : values) value = residual[anyOf(random, residual.size())] + shift;
    PublishedSample sample{quantile(values, 0.5), std::nullopt, like.count};
    // whole degrees are published
    if (like.interquartile)
      sample.interquartile = std::max(1.0, quantile(values, 0.75) - quantile(values, 0.25));
    return sample;
  }

  bool isHit(const std::vector<std::size_t>& chosen, double friction, RandomStream& random) const
  {
    std::vector<PublishedSample> published;
    for (const PublishedSample& each : samples) published.push_back(draw(each, friction, random));
    SimulatedSample again;
    for (const std::size_t i : chosen) {
      again.values.push_back(simulated.values[i % simulated.values.size()]);
      again.sharedFriction.push_back(simulated.sharedFriction[i % simulated.values.size()]);
    }
    return compare(pooled(published, betweenCenters_deg), again).isHit();
  }
};

/// The simulated outcomes of a rate.
struct RateTruth {
  ClinicalRate rate;
  std::vector<bool> outcomes;

  bool isHit(const std::vector<std::size_t>& chosen, RandomStream& random) const
  {
    int found = 0, published = 0;
    for (const std::size_t i : chosen) found += outcomes[i % outcomes.size()] ? 1 : 0;
    for (int i = 0; i < rate.of; ++i) published += outcomes[anyOf(random, outcomes.size())] ? 1 : 0;
    return expectedCounts(rate.of, found, static_cast<int>(chosen.size())).holds(published);
  }
};

AngleTruth angleTruth(const PublishedArray& array,
                      const std::vector<analysis::ClinicalInsertion>& insertions)
{
  AngleTruth row;
  row.samples = array.samples();
  for (const analysis::ClinicalInsertion& each : insertions) {
    if (each.array != array.array) continue;
    row.simulated.values.push_back(inDegrees(each.apical));
    row.simulated.sharedFriction.push_back(each.sharedFriction);
  }
  if (row.simulated.values.size() < 2) return row;
  const PooledSample pool = pooled(row.samples, betweenCenters_deg);
  row.betweenCenters = pool.betweenCenters;
  row.slope = compare(pool, row.simulated).slope;
  for (std::size_t i = 0; i < row.simulated.values.size(); ++i)
    row.residual.push_back(row.simulated.values[i] - row.slope * row.simulated.sharedFriction[i]);
  return row;
}

}  // namespace

Result<PerfectModel> perfectModel(const std::vector<analysis::ClinicalInsertion>& insertions)
{
  const auto arrays = publishedArrays();
  if (!arrays) return arrays.error();
  const auto rates = clinicalRates();
  if (!rates) return rates.error();
  std::vector<AngleTruth> angles;
  std::vector<double> frictions;
  for (const PublishedArray& array : *arrays) {
    AngleTruth row = angleTruth(array, insertions);
    if (row.residual.empty()) continue;
    frictions = row.simulated.sharedFriction;
    angles.push_back(std::move(row));
  }
  std::vector<RateTruth> counts;
  for (const ClinicalRate& rate : *rates) {
    RateTruth row{rate, {}};
    for (const analysis::ClinicalInsertion& each : insertions)
      if (rate.array == "all" || each.array == rate.array)
        row.outcomes.push_back(rate.counts(each));
    if (rate.confidence != "low" && !row.outcomes.empty()) counts.push_back(std::move(row));
  }

  PerfectModel perfect;
  perfect.rows = static_cast<int>(angles.size() + counts.size());
  perfect.exactly.assign(static_cast<std::size_t>(perfect.rows) + 1, 0.0);
  if (frictions.empty()) return perfect;
  for (int number = 0; number < replicates; ++number) {
    const auto stream = [&](PerfectDraw draw) {
      return RandomStream(perfectSeed, static_cast<std::uint64_t>(number),
                          static_cast<std::uint64_t>(draw));
    };
    RandomStream friction = stream(PerfectDraw::friction), clinics = stream(PerfectDraw::clinics);
    RandomStream again = stream(PerfectDraw::insertions);
    const double truth = frictions[anyOf(friction, frictions.size())];
    // the same patients for all arrays
    const auto chosen = [&](std::size_t count) {
      std::vector<std::size_t> some(count);
      for (std::size_t& each : some) each = anyOf(again, count);
      return some;
    };
    const std::vector<std::size_t> patients = chosen(frictions.size());
    std::size_t hits = 0;
    for (const AngleTruth& row : angles) hits += row.isHit(patients, truth, clinics) ? 1 : 0;
    for (const RateTruth& row : counts)
      hits +=
          row.isHit(row.outcomes.size() == patients.size() ? patients : chosen(row.outcomes.size()),
                    clinics)
              ? 1
              : 0;
    perfect.exactly[hits] += 1.0 / replicates;
  }
  for (std::size_t hits = 0; hits < perfect.exactly.size(); ++hits)
    perfect.expected += static_cast<double>(hits) * perfect.exactly[hits];
  perfect.all = perfect.exactly.back();
  return perfect;
}

}  // namespace perilymph::validation

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicResistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

using planning::frictionShifts;
using planning::ResistanceCells;
using planning::stopShifts;

namespace {

/// Least likelihood of an outcome under a cell (choice, high): where no simulation explains one, as with a
/// wrong reason, the posterior stays finite.
constexpr double minLikelihood = 1e-6;

double normalDensity(double deviate)
{
  return exponential(-0.5 * deviate * deviate) / std::sqrt(2.0 * std::numbers::pi);
}

/// Probability of an outcome under a distribution on the grid.
double expected(const ResistanceCells& cells, const ResistanceCells& likelihood)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) sum += cells[i] * likelihood[i];
  return sum;
}

}  // namespace

Evidence evidenceOf(const Surgery& surgery, bool isDisplaced)
{
  if (isDisplaced || surgery.attempts.value_or(1) > 1) return Evidence::none;
  switch (surgery.stopReason) {
    case StopReason::resistance:
      return Evidence::resisted;
    case StopReason::mark:
    case StopReason::hearing:
    case StopReason::bleeding:
      return Evidence::censored;
    case StopReason::unknown:
    case StopReason::buckling:
    case StopReason::other:
      break;
  }
  return Evidence::none;
}

ResistanceCells likelihoodOf(const InsertedLength& inserted, const planning::StopDraws& draws)
{
  ResistanceCells likelihood;
  likelihood.fill(1.0);
  if (inserted.evidence == Evidence::none || draws.draws.empty()) return likelihood;
  const double s = std::sqrt(inserted.sd_mm * inserted.sd_mm + modelSd_mm * modelSd_mm);
  const std::size_t count = draws.draws.size();
  std::vector<std::array<double, stopShifts>> one(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t g = 0; g < stopShifts; ++g) {
      const double beyond = (draws.draws[k].stop_mm[g] - inserted.length_mm) / s;
      one[k][g] = inserted.evidence == Evidence::resisted
                      ? (std::isfinite(beyond) ? normalDensity(beyond) / s : 0.0)
                      : planning::normalBelow(beyond);
    }
  for (std::size_t f = 0; f < frictionShifts; ++f) {
    const std::vector<double> weights = planning::frictionWeights(draws, f);
    for (std::size_t g = 0; g < stopShifts; ++g) {
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k) sum += weights[k] * one[k][g];
      if (inserted.evidence == Evidence::resisted)
        sum = (1.0 - strayShare) * sum + strayShare / inserted.insertable_mm;
      likelihood[f * stopShifts + g] = std::max(sum, minLikelihood);
    }
  }
  return likelihood;
}

ResistancePosterior::ResistancePosterior()
    : cells_(planning::resistancePrior()), prior_(planning::resistancePrior())
{
}

ResistanceScore ResistancePosterior::add(const InsertedLength& inserted,
                                         const planning::StopDraws& draws)
{
  ResistanceScore score;
  score.isOffered = isOffered();
  score.percentile =
      planning::depthsIn(cells_, draws).percentile(inserted.length_mm, inserted.sd_mm);
  score.shippedPercentile =
      planning::depthsIn(prior_, draws).percentile(inserted.length_mm, inserted.sd_mm);
  if (inserted.year > 0) {
    firstYear_ = firstYear_ == 0 ? inserted.year : std::min(firstYear_, inserted.year);
    lastYear_ = std::max(lastYear_, inserted.year);
  }
  if (inserted.evidence == Evidence::none) {
    ++uninformative_;
    return score;
  }
  ++(inserted.evidence == Evidence::resisted ? resisted_ : censored_);
  const ResistanceCells likelihood = likelihoodOf(inserted, draws);
  score.logClinic = logarithm(expected(cells_, likelihood));
  score.logShipped = logarithm(expected(prior_, likelihood));
  logScore_ += score.logClinic - score.logShipped;
  double sum = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    sum += cells_[i] *= power(likelihood[i], tempering);
  for (double& cell : cells_) cell /= sum;
  return score;
}

double ResistancePosterior::meanFrictionShift() const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    sum += cells_[i] * planning::frictionShift(i / stopShifts);
  return sum;
}

double ResistancePosterior::meanStopShift() const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    sum += cells_[i] * planning::stopShift(i % stopShifts);
  return sum;
}

bool ResistancePosterior::isOffered() const noexcept
{
  return resisted_ >= fewestResisted && logScore_ >= minGain;
}

std::size_t ResistancePosterior::count(Evidence evidence) const noexcept
{
  return evidence == Evidence::resisted   ? resisted_
         : evidence == Evidence::censored ? censored_
                                          : uninformative_;
}

planning::ClinicResistance ResistancePosterior::resistance(double friction) const
{
  return {cells_, friction, resisted_, censored_, uninformative_, logScore_, firstYear_, lastYear_};
}

void AngleOffset::add(double difference_deg, double sd)
{
  const double prior = 1.0 / (sd_deg * sd_deg), own = 1.0 / (sd * sd);
  mean_deg = (prior * mean_deg + own * difference_deg) / (prior + own);
  sd_deg = std::sqrt(1.0 / (prior + own));
}

}  // namespace perilymph::outcome

// SPDX-License-Identifier: BSD-3-Clause

// How well the insertions meet the predicted forces of the experiment.

#include <algorithm>
#include <cmath>

#include "perilymph/validation/Validation.h"

namespace perilymph::validation {

double chiSquareTail(double chiSquare, int degreesOfFreedom)
{
  if (degreesOfFreedom <= 0) return 1.0;
  const double half = 0.5 * chiSquare;
  // Q(x, k + 2) = Q(x, k) + (x/2)^(k/2) exp(-x/2) / Gamma(k/2 + 1)
  const bool isOdd = degreesOfFreedom % 2 == 1;
  double tail = isOdd ? std::erfc(std::sqrt(half)) : std::exp(-half);
  for (int k = isOdd ? 1 : 2; k < degreesOfFreedom; k += 2) {
    const double power = 0.5 * k;
    tail += std::pow(half, power) * std::exp(-half) / std::tgamma(power + 1.0);
  }
  return std::min(tail, 1.0);
}

double chiSquareExceededBy(double probability, int degreesOfFreedom)
{
  double low = 0.0, high = 1.0;
  while (chiSquareTail(high, degreesOfFreedom) > probability) high *= 2.0;
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (chiSquareTail(middle, degreesOfFreedom) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Range deviationsBehind(double deviation, double insertions)
{
  if (!(insertions >= 2.0)) return {};
  const int degreesOfFreedom = static_cast<int>(std::lround(insertions)) - 1;
  const auto at = [&](double probability) {
    return deviation *
           std::sqrt(degreesOfFreedom / chiSquareExceededBy(probability, degreesOfFreedom));
  };
  return {at(0.025), at(0.975)};
}

Agreement agreementOf(const ValidationResult& result)
{
  Agreement agreement;
  const auto add = [&](double difference, double standardError) {
    agreement.largest = std::max(agreement.largest, std::fabs(difference));
    if (!(standardError > 0.0)) return;
    agreement.chiSquare += difference * difference / (standardError * standardError);
    ++agreement.degreesOfFreedom;
  };
  for (const AnchorComparison& anchor : result.anchors) {
    if (anchor.experiment.feature != fittedFeature)
      add(anchor.difference.mean, anchor.difference.standardError);
  }
  for (const IntervalComparison& interval : result.intervals)
    add(interval.difference, interval.standardError);
  agreement.pValue = chiSquareTail(agreement.chiSquare, agreement.degreesOfFreedom);
  return agreement;
}

}  // namespace perilymph::validation

// SPDX-License-Identifier: BSD-3-Clause
#include "PlanComparison.h"

#include <algorithm>
#include <cmath>

#include "PlannedValues.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/planning/PlanSummary.h"

namespace perilymph::planning {

AtMedianFriction atMedianFriction(const std::vector<const PlannedInsertion*>& all)
{
  std::vector<double> logs;
  for (const PlannedInsertion* each : all) logs.push_back(logarithm(each->friction));
  const auto count = static_cast<double>(std::max<std::size_t>(all.size(), 1));
  double meanLog = 0.0, square = 0.0;
  for (const double log : logs) meanLog += log / count;
  for (const double log : logs) square += (log - meanLog) * (log - meanLog);
  const auto band = [&](double (*value)(const PlannedInsertion&)) {
    double product = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) product += (logs[i] - meanLog) * value(*all[i]);
    const double slope = square > 0.0 ? product / square : 0.0;
    std::vector<double> corrected;
    for (std::size_t i = 0; i < all.size(); ++i)
      corrected.push_back(std::max(0.0, value(*all[i]) - slope * logs[i]));
    return bandOf(std::move(corrected));
  };
  return {band(angleOf), band(depthOf), band(peakOf), band(endOf)};
}

std::vector<ArrayDifference> differencesOf(std::size_t arrays,
                                           const std::vector<PlannedInsertion>& insertions)
{
  std::vector<ArrayDifference> differences;
  for (std::size_t first = 0; first < arrays; ++first)
    for (std::size_t second = first + 1; second < arrays; ++second) {
      std::vector<double> angles, depths, peaks;
      for (std::size_t draw = 0; (draw + 1) * arrays <= insertions.size(); ++draw) {
        const PlannedInsertion& one = insertions[draw * arrays + first];
        const PlannedInsertion& other = insertions[draw * arrays + second];
        if (!isRun(one) || !isRun(other)) continue;
        angles.push_back(angleOf(one) - angleOf(other));
        depths.push_back(depthOf(one) - depthOf(other));
        peaks.push_back(peakOf(one) - peakOf(other));
      }
      const auto above = [](const std::vector<double>& values) {
        const auto hits = std::ranges::count_if(values, [](double value) { return value > 0.0; });
        return analysis::proportionOf(static_cast<std::size_t>(hits), values.size());
      };
      differences.push_back({first, second, angles.size(), bandOf(angles), bandOf(depths),
                             bandOf(peaks), above(angles), above(peaks)});
    }
  return differences;
}

}  // namespace perilymph::planning

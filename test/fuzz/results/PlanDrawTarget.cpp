// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes one insertion in a plan's file of draws with any text, and summarizes it among others.

#include <cmath>

#include "FuzzTarget.h"
#include "PlanFile.h"
#include "perilymph/planning/PlanSummary.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  std::vector<Bytes> texts;
  for (const auto& insertion : test::syntheticInsertions(2)) {
    const std::string text = planning::contentOf(insertion);
    texts.emplace_back(text.begin(), text.end());
  }
  return texts;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static const auto others = test::syntheticInsertions(8);
  static const planning::Plan plan = test::syntheticPlan(8);
  const auto insertion =
      planning::insertionIn(std::string(reinterpret_cast<const char*>(data), size));
  if (!insertion) return 0;
  const auto again = planning::insertionIn(planning::contentOf(*insertion));
  fuzz::promise(again && planning::contentOf(*again) == planning::contentOf(*insertion),
                "an insertion is kept");
  auto all = others;
  all.push_back(*insertion);
  const auto arrays =
      planning::summarize(plan.request, test::plannedArrays(), plan.thresholds, all);
  for (const auto& array : arrays)
    fuzz::promise(std::isfinite(array.angle_deg.high) && std::isfinite(array.peak_mN.high),
                  "bands are numbers");
  return 0;
}

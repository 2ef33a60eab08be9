// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the plan.json of a plan with any text, and makes tables and figures of it.

#include <cmath>

#include "FuzzTarget.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::fuzz {

namespace {

void checkBand(const planning::Band& band)
{
  promise(std::isfinite(band.low) && std::isfinite(band.high), "quantiles are numbers");
  promise(band.low <= band.lowerQuartile && band.lowerQuartile <= band.median &&
              band.median <= band.upperQuartile && band.upperQuartile <= band.high,
          "quantiles do not decrease");
}

void checkArray(const planning::ArrayPlan& array)
{
  for (const auto& each : planning::planQuantities()) checkBand(array.*each.band);
  for (const auto& each : planning::planProbabilities()) {
    const analysis::Estimate& estimate = array.*each.estimate;
    const bool isStated =
        !std::isnan(estimate.value) || !std::isnan(estimate.low) || !std::isnan(estimate.high);
    if (!each.isInFirstVersions && !isStated) continue;  // in former versions' files
    promise(estimate.low >= 0.0 && estimate.low <= estimate.value &&
                estimate.value <= estimate.high && estimate.high <= 1.0,
            "a probability within its interval");
  }
  promise(array.force.size() <= planning::maxStoredRows &&
              array.contacts.size() <= planning::maxStoredRows,
          "a bounded number of rows");
}

}  // namespace

std::vector<Bytes> seeds()
{
  const auto text = planning::planJson(test::syntheticPlan(20));
  promise(static_cast<bool>(text), "a plan has a report");
  return {Bytes(text->begin(), text->end())};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const auto stored =
      planning::planIn(std::string(reinterpret_cast<const char*>(data), size), "plan.json");
  if (!stored) {
    fuzz::promise(!stored.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::promise(!stored->plan.arrays.empty(), "a plan has an array");
  fuzz::promise(static_cast<bool>(anatomy::checkPatient(stored->plan.request.patient)),
                "its patient is possible");
  for (const auto& array : stored->plan.arrays) fuzz::checkArray(array);
  fuzz::promise(!planning::arraysCsv(stored->plan).empty(), "a table");
  planning::contactsCsv(stored->plan);
  planning::planFigures(stored->plan);
  return 0;
}

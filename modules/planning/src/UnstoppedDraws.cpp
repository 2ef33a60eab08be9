// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/UnstoppedDraws.h"

#include <utility>

#include "PlanSetup.h"
#include "perilymph/foundation/InParallel.h"

namespace perilymph::planning {

Result<std::vector<UnstoppedDraw>> unstoppedDraws(const PlanRequest& request, std::size_t array,
                                                  std::size_t first, std::size_t count,
                                                  const analysis::RunProgress& progress,
                                                  const std::stop_token& stop)
{
  if (array >= request.arrays.size())
    return Error{"The plan has no array %1; it has %2. Choose one of them.", array + 1,
                 request.arrays.size()};
  const auto setup = preparePlan(request);
  if (!setup) return setup.error();
  std::vector<UnstoppedDraw> draws(count);
  const auto work = [&](std::size_t piece, const std::stop_token& ending) -> Result<void> {
    auto run = runWithoutStop(request, *setup, array, first + piece, ending);
    if (!run) return run.error();
    draws[piece] = *std::move(run);
    return {};
  };
  const auto ran = doInParallel(
      count, request.jobs, work,
      [&](std::size_t done) {
        if (progress) progress(done, count);
      },
      stop);
  if (!ran) return ran.error();
  return draws;
}

}  // namespace perilymph::planning

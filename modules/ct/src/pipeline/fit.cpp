// SPDX-License-Identifier: BSD-3-Clause

// Second stage of the measurement: the fit, and its correction by landmarks.

#include <vector>

#include "pipeline/Pipeline.h"

namespace perilymph::ct {
namespace {

constexpr std::size_t someVoxels = 8000, manyVoxels = 14000;

// Landmarks that raise the misfit by more are contradicted by the voxels: those at their true places
// changed that of wrong fits of phantoms by -0.17 to +0.013.
constexpr double contradictedMisfit = 0.03;

}  // namespace

Result<FitResult> Pipeline::refined(FitResult best) const
{
  for (int round = 0; round < 4; ++round) {
    if (isStopped()) return canceled();
    const auto voxels = observe(volume_, family_, best.state, 1.3,
                                round < 2 ? someVoxels : manyVoxels, Threads::all);
    const FitSettings settings = round == 0   ? FitSettings{Freedom::shape, 12, 0.4, 1.0}
                                 : round == 1 ? FitSettings{Freedom::everything, 12, 0.25, 1.0}
                                              : FitSettings{Freedom::everything, 16, 0.0, 1.0};
    best = fit_.run(best.state, voxels, settings, Threads::all);
    report(0.5 + 0.1 * round);
  }
  return best;
}

FitResult Pipeline::corrected(FitResult free) const
{
  FitResult fit = steered(free, GrossError::possible);
  if (fit.misfit > free.misfit + contradictedMisfit) fit = steered(free, GrossError::excluded);
  return fit;
}

FitResult Pipeline::steered(const FitResult& free, GrossError grossError) const
{
  FitResult best = free;
  std::vector<double> precisions;
  for (int round = 0; round < 3; ++round) {
    // Floor and apex refer to the present wall; the precisions stay those of the free fit.
    auto marks = constraintsOf(request_.marks, family_, best.state.pose, best.state.shape, axis_W_);
    if (marks.empty() || isStopped()) return best;
    if (round == 0) {
      setPrecisions(marks, family_, free.state.pose, free.state.shape, free.posterior, grossError);
      for (const MarkConstraint& mark : marks) precisions.push_back(mark.precision);
    }
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i].precision = precisions[i];
    auto observations = observe(volume_, family_, best.state, 1.3, manyVoxels, Threads::all);
    observations.marks = std::move(marks);
    best = fit_.run(best.state, observations, {Freedom::everything, 16, 0.0, 1.0}, Threads::all);
  }
  return best;
}

}  // namespace perilymph::ct

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One row of the contact table: a library's query of the cloud, timed and checked.

#include <benchmark/benchmark.h>

#include <vector>

#include "Cloud.h"

namespace perilymph::bench {

/// Writes the time per query and the deviation from the project's lumen into a row. The row fails
/// if the library's result is not the distance to the wall.
///
/// @param answers  For each center of the cloud, the distance to the facets [m].
void report(benchmark::State& state, const Facets& wall, const std::vector<double>& answers);

/// Times a library. `Peer` is built from the facets in millimeters, which suit single precision and
/// fixed margins, and has `double distance(const Eigen::Vector3d& center_mm)` in millimeters,
/// negative if there is no wall within `reach`.
template <class Peer>
void nearestWallBy(benchmark::State& state)
{
  if (!builtMean()) return state.SkipWithError(builtMean().error().message.c_str());
  const Facets& wall = facets(static_cast<int>(state.range(0)));
  Peer peer(wall.surface_mm);
  std::vector<Eigen::Vector3d> centers_mm;
  for (const Eigen::Vector3d& center_W : cloud().centers_W) centers_mm.push_back(1e3 * center_W);

  std::vector<double> answers(centers_mm.size(), 0.0);
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(centers_mm.size()))) {
    for (std::size_t i = 0; i < centers_mm.size(); ++i)
      answers[i] = 1e-3 * peer.distance(centers_mm[i]);
    benchmark::ClobberMemory();
  }
  report(state, wall, answers);
}

/// The surface sizes used for every library.
inline void sizes(benchmark::internal::Benchmark* row)
{
  row->ArgName("triangles")->Arg(2000)->Arg(20000)->Arg(200000)->Unit(benchmark::kNanosecond);
}

}  // namespace perilymph::bench

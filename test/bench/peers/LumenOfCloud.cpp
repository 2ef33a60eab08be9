// SPDX-License-Identifier: BSD-3-Clause

// The project's lumen on the same query, for comparison.

#include "Peer.h"

namespace {

using namespace perilymph;

void nearestWallByLumen(benchmark::State& state)
{
  if (!bench::builtMean()) return state.SkipWithError(bench::builtMean().error().message.c_str());
  const bench::Cloud& cloud = bench::cloud();
  const std::vector<double> reach(cloud.centers_W.size(), bench::reach);
  std::vector<anatomy::LumenTrack> tracks = cloud.tracks;
  std::vector<anatomy::WallPoint> walls(cloud.centers_W.size());
  const anatomy::ScalaTympani& scala = bench::meanScala();
  const auto queries = static_cast<benchmark::IterationCount>(walls.size());
  while (state.KeepRunningBatch(queries)) {
    scala.nearestWall(cloud.centers_W, reach, tracks, walls);
    benchmark::DoNotOptimize(walls.data());
    benchmark::ClobberMemory();
  }

  // Compared with the finest facets, like the others.
  std::vector<double> answers;
  for (const anatomy::WallPoint& wall : walls) answers.push_back(wall.isNear ? wall.distance : -1);
  bench::report(state, bench::facets(200000), answers);
  state.counters.erase("triangles");
}

BENCHMARK(nearestWallByLumen)->Name("lumen/own/cloud:1000")->Unit(benchmark::kNanosecond);

}  // namespace

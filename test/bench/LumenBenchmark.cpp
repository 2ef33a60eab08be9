// SPDX-License-Identifier: BSD-3-Clause

// Time of the wall query for all nodes of an array, the inner loop of contact, and of the building of a
// cochlea and of the table that the query reads.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "Percentiles.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaVestibuli.h"

namespace {

using namespace perilymph;

/// Points along the duct near its outer wall, like an inserted array, each with its turn.
struct Batch {
  Batch(const anatomy::ScalaTympani& scala, std::size_t count)
      : reach(count, 1e-3), tracks(count), walls(count)
  {
    // Up to two thirds of the length, at 0.8 of the distance from the center to the wall: in
    // contact range.
    const double last = 2.0 / 3.0 * scala.lastAngle().si();
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = last * static_cast<double>(i + 1) / static_cast<double>(count);
      const Eigen::Vector3d center_W = scala.center_W(angle);
      points_W.push_back(center_W + 0.8 * (scala.wall_W(angle, 0.0) - center_W));
      tracks[i].angle = angle;
      tracks[i].direction[0] = std::cos(angle);
      tracks[i].direction[1] = std::sin(angle);
    }
  }

  std::vector<Eigen::Vector3d> points_W;
  std::vector<double> reach;
  std::vector<anatomy::LumenTrack> tracks;
  std::vector<anatomy::WallPoint> walls;
};

void nearestWall(benchmark::State& state)
{
  const auto scala = anatomy::buildPublished(anatomy::Patient(), millimeters(1));
  Batch batch(*scala, static_cast<std::size_t>(state.range(0)));
  bench::Percentiles percentiles(static_cast<std::size_t>(state.max_iterations));
  for (auto _ : state) {
    percentiles.time([&] {
      scala->nearestWall(batch.points_W, batch.reach, batch.tracks, batch.walls);
      benchmark::DoNotOptimize(batch.walls.data());
      benchmark::ClobberMemory();
    });
  }
  for (const anatomy::WallPoint& wall : batch.walls)
    if (!wall.isNear) {
      state.SkipWithError("A point near the wall did not find it.");
      return;
    }
  percentiles.report(state);
  const benchmark::IterationCount points = state.iterations() * state.range(0);
  state.SetItemsProcessed(points);
  using benchmark::Counter;
  state.counters["per_query_s"] =
      Counter(static_cast<double>(points), Counter::kIsRate | Counter::kInvert);
}

BENCHMARK(nearestWall)->Name("lumen")->ArgName("batch")->Arg(100)->Unit(benchmark::kMicrosecond);

/// The mean cochlea scaled to A, B and H of a patient.
std::shared_ptr<const anatomy::ScalaTympani> measuredCochlea()
{
  const anatomy::BasalTurn turn{millimeters(9.1), millimeters(6.9), millimeters(3.9)};
  return *anatomy::buildMean("", turn, millimeters(1));
}

/// As for each simulation of a plan: with the sections above the partition.
void buildCochlea(benchmark::State& state)
{
  for (auto _ : state) {
    const auto scala = measuredCochlea();
    benchmark::DoNotOptimize(anatomy::vestibuliOf(*scala).get());
    benchmark::DoNotOptimize(anatomy::bothScalaeOf(*scala).get());
  }
}
BENCHMARK(buildCochlea)->Name("cochlea/build")->Unit(benchmark::kMillisecond);

void prepareTable(benchmark::State& state)
{
  for (auto _ : state) {
    state.PauseTiming();
    const auto scala = measuredCochlea();
    state.ResumeTiming();
    scala->prepare();
  }
}
BENCHMARK(prepareTable)->Name("cochlea/table")->Unit(benchmark::kMillisecond);

}  // namespace

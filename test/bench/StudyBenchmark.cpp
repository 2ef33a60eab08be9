// SPDX-License-Identifier: BSD-3-Clause

// Insertions per second of a study: 100 nodes, steps of 5 ms, 16.5 mm at 2 mm/s, with one and two
// threads. Every cochlea is built for its four insertions.

#include <benchmark/benchmark.h>

#include "perilymph/study/StudyRun.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

constexpr const char* text = R"(
title = "speed"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
virtual = 8
[vary]
dt_ms = [5.0]
stop_travel_mm = [16.5]
speed_mm_s = [2.0]
friction = ["soap-10"]
approach_tilt_deg = [-1.0, 0.0, 1.0, 2.0]
)";

void insertions(benchmark::State& state)
{
  const auto study = study::parseStudy(text, "study.toml");
  if (!study) {
    state.SkipWithError(study.error().message.c_str());
    return;
  }
  const auto shard = study::shardOf(study->size(), 1, 1);
  for (auto _ : state) {
    const test::TemporaryFolder folder;
    const auto done =
        study::runShard(*study, shard, folder.path(), static_cast<unsigned>(state.range(0)), {});
    if (!done) state.SkipWithError(done.error().message.c_str());
  }
  state.counters["insertions_per_s"] = benchmark::Counter(
      static_cast<double>(study->size()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}
BENCHMARK(insertions)
    ->Name("study/insertions")
    ->ArgName("jobs")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace perilymph

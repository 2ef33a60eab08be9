// SPDX-License-Identifier: BSD-3-Clause

// Time of a tick of the published point set, and the number of points with which it is stable.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "BuiltOnce.h"
#include "Percentiles.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/session/Scenario.h"

namespace {

using namespace perilymph;

/// A run with a larger force is unstable: seven times the maximum force published for the model,
/// 0.1389 N (Todd and Naghdy, section III).
constexpr double maxForce = 1.0;  // [N]

/// The published experiment with the array as a set of points.
struct PublishedPoints {
  explicit PublishedPoints(int points)
  {
    const auto found = session::loadScenario(
        "contour-published", {{"model", "points"}, {"nodes", std::to_string(points)}});
    if (!found) return;
    scenario = *found;
    static const auto scala =
        session::buildAnatomy(scenario);  // the same for every number of points
    if (!scala) return;
    const auto built = session::buildModel(scenario, *scala);
    if (built) model = *built;
  }
  bool isReady() const { return model != nullptr; }
  int ticks() const
  {
    return static_cast<int>(
        std::ceil(scenario.stopTravel().si() / (scenario.speed().si() * model->timeStep)));
  }
  mechanics::Drive driveAt(int tick) const
  {
    mechanics::Drive drive;
    drive.handAxis_W = model->startAxis_W;
    drive.handCurl_W = model->startCurl_W;
    const double travel = scenario.speed().si() * model->timeStep * tick;
    drive.handPosition_W = model->startBase_W + travel * model->startAxis_W;
    return drive;
  }
  session::Scenario scenario;
  std::shared_ptr<const mechanics::InsertionModel> model;
};

/// Whether the published run is stable with this number of points: no point reaches its limit of
/// motion, and the force at the hand has the published order of magnitude.
bool isStable(int points)
{
  const PublishedPoints run(points);
  if (!run.isReady()) return false;
  mechanics::InsertionState state(*run.model);
  for (int tick = 1; tick <= run.ticks(); ++tick) {
    mechanics::advance(*run.model, state, run.driveAt(tick));
    const bool isBounded = std::fabs(state.readings.axialForce) < maxForce;
    if (!isBounded || state.points.atBounds > 0) return false;
  }
  return true;
}

void tickOfPoints(benchmark::State& benchmark)
{
  static bench::BuiltOnce<std::int64_t, PublishedPoints> runs;
  const PublishedPoints& run = runs.of(benchmark.range(0), [](std::int64_t points) {
    return PublishedPoints(static_cast<int>(points));
  });
  if (!run.isReady()) return benchmark.SkipWithError("The published point set was not built.");
  mechanics::InsertionState state(*run.model);
  const int ticks = run.ticks();
  // A batch is a whole insertion, from the first to the last contact.
  bench::Percentiles percentiles(static_cast<std::size_t>(benchmark.max_iterations + ticks));
  while (benchmark.KeepRunningBatch(ticks)) {
    state.reset(*run.model);
    for (int tick = 1; tick <= ticks; ++tick) {
      const mechanics::Drive drive = run.driveAt(tick);
      percentiles.time([&] { mechanics::advance(*run.model, state, drive); });
    }
  }
  percentiles.report(benchmark);
}

void twelve(benchmark::internal::Benchmark* row)
{
  row->ArgName("nodes")->Arg(12)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(tickOfPoints)->Name("tick/points")->Apply(twelve);
// Two simultaneous insertions with one model, each with its own thread and state.
BENCHMARK(tickOfPoints)->Name("tick/points")->Apply(twelve)->Threads(2);

/// Increases the number of points from two until a published run is unstable.
void largestStableNumber(benchmark::State& benchmark)
{
  int largest = 0;
  for (auto unused : benchmark) {
    static_cast<void>(unused);
    largest = 0;
    for (int points = 2; points <= mechanics::maxPoints && isStable(points); ++points)
      largest = points;
  }
  benchmark.counters["largest_stable"] = largest;
  benchmark.counters["published"] = 12;
}

BENCHMARK(largestStableNumber)
    ->Name("stability/points/at_1_kHz")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace

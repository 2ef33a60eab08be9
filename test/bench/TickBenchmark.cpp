// SPDX-License-Identifier: BSD-3-Clause

// Time of one haptic tick, from the hand's sample to the published snapshot, over whole insertions
// of the published experiment.

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>

#include "BuiltOnce.h"
#include "Percentiles.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace {

using namespace perilymph;

constexpr const char* scenarioName = "contour-published";

/// Ticks of 16.5 mm at 2 mm/s in steps of 1 ms: the whole insertion, from few contacts to all.
constexpr int ticksOfInsertion = 8250;

/// One insertion in virtual time.
class Run {
public:
  Run(const session::Scenario& scenario, std::shared_ptr<const mechanics::InsertionModel> model)
      : hand_(scenario.speed().si(), scenario.timeStep().si()),
        isOpen_(static_cast<bool>(hand_.open())),
        loop_(hand_,
              std::make_unique<haptics::InsertionEngine>(std::move(model), scenario.engine()))
  {
    loop_.send({.kind = haptics::Command::Kind::arm});
    loop_.runOnce();
    hand_.move(device::ScriptedDevice::Motion::insert);
    takeRecords();
  }

  void tick() { loop_.runOnce(); }

  /// Takes the records like a recorder.
  void takeRecords()
  {
    while (loop_.take(last_)) {
    }
  }

  /// The last tick is beyond nine tenths of the stop travel, and there was no fault.
  bool wentIn(const session::Scenario& scenario) const
  {
    return isOpen_ && last_.output.workflow != haptics::Workflow::fault &&
           last_.output.travel > 0.9 * scenario.stopTravel().si();
  }

private:
  device::ScriptedDevice hand_;
  bool isOpen_;
  haptics::HapticLoop loop_;
  haptics::TickRecord last_;
};

/// The published experiment and its model, shared by all threads of a row.
struct Experiment {
  session::Scenario scenario;
  std::shared_ptr<const mechanics::InsertionModel> model;
};

Result<Experiment> build(std::int64_t nodes)
{
  const auto scenario = session::loadScenario(scenarioName, {{"nodes", std::to_string(nodes)}});
  if (!scenario) return scenario.error();
  const auto scala = session::buildAnatomy(*scenario);
  if (!scala) return Error{"The anatomy could not be built."};
  const auto model = session::buildModel(*scenario, *scala);
  if (!model) return model.error();
  return Experiment{*scenario, *model};
}

void tickOfWholeInsertion(benchmark::State& state)
{
  static bench::BuiltOnce<std::int64_t, Result<Experiment>> experiments;
  const Result<Experiment>& experiment = experiments.of(state.range(0), build);
  if (!experiment) return state.SkipWithError(experiment.error().message.c_str());

  // A batch is a whole insertion and an iteration is a tick, so that rows are comparable.
  bench::Percentiles percentiles(static_cast<std::size_t>(state.max_iterations) + ticksOfInsertion);
  while (state.KeepRunningBatch(ticksOfInsertion)) {
    state.PauseTiming();
    Run run(experiment->scenario, experiment->model);
    state.ResumeTiming();
    for (int i = 0; i < ticksOfInsertion; ++i) {
      percentiles.time([&run] { run.tick(); });
      run.takeRecords();
    }
    if (!run.wentIn(experiment->scenario)) {
      state.SkipWithError("The array did not go in: no tick of this run tells anything.");
      return;
    }
  }
  percentiles.report(state);
}

void sizes(benchmark::internal::Benchmark* row)
{
  row->ArgName("nodes")->Arg(100)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(tickOfWholeInsertion)->Name("tick/rod")->Apply(sizes);
// Two simultaneous insertions with one model, each with its own thread and state.
BENCHMARK(tickOfWholeInsertion)->Name("tick/rod")->Apply(sizes)->Threads(2);

}  // namespace

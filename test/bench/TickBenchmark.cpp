// How long one haptic tick takes, from the hand's sample to the published picture, over whole
// insertions of the published experiment.

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>

#include "Percentiles.h"
#include "perilymph/device/ScriptedHand.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace {

using namespace perilymph;

constexpr const char* scenarioName = "contour-published";

/// Of 16.5 mm at 2 mm/s, 1 ms each; the whole insertion, from few contacts to all of them.
constexpr int ticksOfInsertion = 8250;

/// One insertion in virtual time.
class Run {
public:
  Run(const session::Scenario& scenario, std::shared_ptr<const mechanics::InsertionModel> model)
      : hand_(scenario.speed.si(), scenario.timeStep.si()),
        isOpen_(static_cast<bool>(hand_.open())),
        loop_(hand_, std::make_unique<haptics::InsertionEngine>(std::move(model), scenario.engine))
  {
    loop_.send({.kind = haptics::Command::Kind::arm});
    loop_.runOnce();
    hand_.move(device::ScriptedHand::Motion::insert);
    takeRecords();
  }

  void tick() { loop_.runOnce(); }

  /// Takes the records, as a recorder would.
  void takeRecords()
  {
    while (loop_.take(last_)) {
    }
  }

  /// The last tick lies at least nine tenths of the stop travel in, and nothing failed.
  bool wentIn(const session::Scenario& scenario) const
  {
    return isOpen_ && last_.output.workflow != haptics::Workflow::fault &&
           last_.output.travel > 0.9 * scenario.stopTravel.si();
  }

private:
  device::ScriptedHand hand_;
  bool isOpen_;
  haptics::HapticLoop loop_;
  haptics::TickRecord last_;
};

void tickOfWholeInsertion(benchmark::State& state)
{
  const auto scenario =
      session::loadScenario(scenarioName, {{"nodes", std::to_string(state.range(0))}});
  if (!scenario) return state.SkipWithError(scenario.error().message.c_str());
  const auto scala = session::buildAnatomy(*scenario);
  if (!scala) return state.SkipWithError("The anatomy could not be built.");
  const auto model = session::buildModel(*scenario, *scala);
  if (!model) return state.SkipWithError(model.error().message.c_str());

  // A batch is a whole insertion and one iteration is a tick: rows of different length compare.
  bench::Percentiles percentiles(static_cast<std::size_t>(state.max_iterations) + ticksOfInsertion);
  while (state.KeepRunningBatch(ticksOfInsertion)) {
    state.PauseTiming();
    Run run(*scenario, *model);
    state.ResumeTiming();
    for (int i = 0; i < ticksOfInsertion; ++i) {
      percentiles.time([&run] { run.tick(); });
      run.takeRecords();
    }
    if (!run.wentIn(*scenario)) {
      state.SkipWithError("The array did not go in: no tick of this run tells anything.");
      return;
    }
  }
  percentiles.report(state);
}

BENCHMARK(tickOfWholeInsertion)
    ->Name("tick/rod")
    ->ArgName("nodes")
    ->Arg(100)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);

}  // namespace

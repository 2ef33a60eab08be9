// SPDX-License-Identifier: BSD-3-Clause

// Time of one haptic tick, from the hand's sample to the published snapshot, over whole insertions:
// the published experiment and back out, an everyday array on tissue, and a precurved array against
// bone.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "BuiltOnce.h"
#include "Percentiles.h"
#include "Work.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace {

using namespace perilymph;

/// A whole insertion in steps of 1 ms, from few contacts to all.
struct Row {
  const char* scenario;
  session::Overrides overrides;
  int ticks;
  bool isTimedOnTheWayOut = false;                    ///< Goes in untimed, then out again.
  void (*change)(electrode::ArrayDesign&) = nullptr;  ///< Changes its array.
};

const Row& published()
{
  static const Row row{"contour-published", {}, 8250};  // 16.5 mm at 2 mm/s
  return row;
}

/// The published insertion with an array and a friction that relax.
const Row& relaxing()
{
  static const Row row{"contour-published",
                       {{"relaxation_fraction", "[0.13, 0.28]"},
                        {"relaxation_time_s", "[0.3, 6]"},
                        {"film_relaxation_fraction", "0.4"},
                        {"film_relaxation_time_s", "0.5"}},
                       8250};
  return row;
}

/// Lets the Contour yield: 22 wires of 250 MPa, and a stylet that just holds the carrier.
void letYield(electrode::ArrayDesign& array)
{
  electrode::Wires& wires = array.wires.emplace();
  wires.number = {{millimeters(1), millimeters(25)}, {1.0, 22.0}};
  wires.diameter = millimeters(0.025);
  wires.modulus = megapascals(168e3);
  wires.coupling = 0.9;
  wires.yieldStress.value = megapascals(250);
  array.stylet.yieldStress.value = megapascals(1500);
}

/// The published insertion with all of it: relaxing, and an array that yields.
const Row& inelastic()
{
  static const Row row{"contour-published", relaxing().overrides, 8250, false, letYield};
  return row;
}

/// With the friction of tissue, by hand, to 17.5 mm at 0.66 mm/s.
const Row& tissueFlex28()
{
  static const Row row{
      "surgery-flex28", {{"stop_travel_mm", "16.5"}, {"friction", "tissue"}}, 25'000};
  return row;
}

/// Against bone under a thin lining, 16.5 mm at 2 mm/s.
const Row& stiffWall()
{
  static const Row row{"mean-contour", {}, 8250};
  return row;
}

/// Out of the published cochlea again, as fast as it went in.
const Row& withdrawal()
{
  static const Row row{"contour-published", {}, 8250, true};
  return row;
}

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

  void withdraw() { hand_.move(device::ScriptedDevice::Motion::withdraw); }

  /// Takes the records like a recorder.
  void takeRecords()
  {
    while (loop_.take(last_)) {
    }
  }

  const mechanics::Readings& readings() const { return loop_.engine().state().readings; }

  /// The last tick is beyond nine tenths of the stop travel, and there was no fault.
  bool wentIn(const session::Scenario& scenario) const
  {
    return isWell() && last_.output.travel > 0.9 * scenario.stopTravel().si();
  }
  /// The last tick is before a tenth of it.
  bool wentOut(const session::Scenario& scenario) const
  {
    return isWell() && last_.output.travel < 0.1 * scenario.stopTravel().si();
  }

private:
  bool isWell() const { return isOpen_ && last_.output.workflow != haptics::Workflow::fault; }

  device::ScriptedDevice hand_;
  bool isOpen_;
  haptics::HapticLoop loop_;
  haptics::TickRecord last_;
};

/// A scenario and its model, shared by all threads of a row.
struct Experiment {
  session::Scenario scenario;
  std::shared_ptr<const mechanics::InsertionModel> model;
};

Result<Experiment> build(const Row& row, std::int64_t nodes)
{
  session::Overrides overrides = row.overrides;
  overrides.emplace_back("nodes", std::to_string(nodes));
  const auto scenario = session::loadScenario(row.scenario, overrides);
  if (!scenario) return scenario.error();
  const auto scala = session::buildAnatomy(*scenario);
  if (!scala) return Error{"The anatomy could not be built."};
  const auto model = session::buildModel(*scenario, *scala);
  if (!model) return model.error();
  if (row.change == nullptr) return Experiment{*scenario, *model};
  mechanics::ModelParts parts = (*model)->parts;
  row.change(parts.array);
  return Experiment{*scenario, mechanics::InsertionModel::build(std::move(parts))};
}

void tickOfWholeInsertion(benchmark::State& state, const Row& row)
{
  static bench::BuiltOnce<std::pair<const Row*, std::int64_t>, Result<Experiment>> experiments;
  const Result<Experiment>& experiment = experiments.of(
      {&row, state.range(0)}, [](const auto& key) { return build(*key.first, key.second); });
  if (!experiment) return state.SkipWithError(experiment.error().message.c_str());

  // A batch is a whole insertion and an iteration is a tick, so that rows are comparable.
  bench::Percentiles percentiles(static_cast<std::size_t>(state.max_iterations) +
                                 static_cast<std::size_t>(row.ticks));
  bench::Work work;
  while (state.KeepRunningBatch(row.ticks)) {
    state.PauseTiming();
    Run run(experiment->scenario, experiment->model);
    if (row.isTimedOnTheWayOut) {
      for (int i = 0; i < row.ticks; ++i) run.tick(), run.takeRecords();
      run.withdraw();
    }
    state.ResumeTiming();
    for (int i = 0; i < row.ticks; ++i) {
      percentiles.time([&run] { run.tick(); });
      run.takeRecords();
      work.add(run.readings());
    }
    if (!(row.isTimedOnTheWayOut ? run.wentOut(experiment->scenario)
                                 : run.wentIn(experiment->scenario))) {
      state.SkipWithError("The array did not go all the way: no tick of this run tells anything.");
      return;
    }
  }
  percentiles.report(state);
  work.report(state);
}

void sizes(benchmark::internal::Benchmark* row)
{
  row->ArgName("nodes")->Arg(100)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(tickOfWholeInsertion, published, published())->Name("tick/rod")->Apply(sizes);
// Two simultaneous insertions with one model, each with its own thread and state.
BENCHMARK_CAPTURE(tickOfWholeInsertion, published, published())
    ->Name("tick/rod")
    ->Apply(sizes)
    ->Threads(2);
BENCHMARK_CAPTURE(tickOfWholeInsertion, tissueFlex28, tissueFlex28())
    ->Name("tick/tissue_flex28")
    ->Apply(sizes);
BENCHMARK_CAPTURE(tickOfWholeInsertion, relaxing, relaxing())->Name("tick/relaxing")->Apply(sizes);
BENCHMARK_CAPTURE(tickOfWholeInsertion, inelastic, inelastic())
    ->Name("tick/inelastic")
    ->Apply(sizes);
BENCHMARK_CAPTURE(tickOfWholeInsertion, stiffWall, stiffWall())
    ->Name("tick/stiff_wall")
    ->Apply(sizes);
BENCHMARK_CAPTURE(tickOfWholeInsertion, withdrawal, withdrawal())
    ->Name("tick/withdrawal")
    ->Apply(sizes);

}  // namespace

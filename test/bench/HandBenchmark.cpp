// SPDX-License-Identifier: BSD-3-Clause

// Time of one step of the mechanics under hands without skill, in settings of test/physics/robust:
// against rough bone on a spring, and at the round window, on whose rim an array folds.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>

#include "../physics/robust/RandomHand.h"
#include "../physics/robust/TrialSettings.h"
#include "Percentiles.h"
#include "Work.h"
#include "perilymph/mechanics/advance.h"

namespace {

using namespace perilymph;

constexpr int ticksOfOneHand = 20'000;
/// Length of a run whose instructions are counted: valgrind takes fifty times as long (test/bench/instructions).
constexpr int countedTicks = 2'000;

test::Setting settingOf(const std::string& name, std::int64_t nodes)
{
  for (test::Setting setting : test::settings())
    if (setting.name == name) {
      setting.nodes = static_cast<int>(nodes);
      return setting;
    }
  return {};
}

void stepUnderHands(benchmark::State& state, const char* name, int ticks)
{
  const test::Setting setting = settingOf(name, state.range(0));
  if (setting.name.empty()) return state.SkipWithError("There is no setting of this name.");
  const auto model = test::build(setting);
  bench::Percentiles percentiles(static_cast<std::size_t>(state.max_iterations + ticks));
  bench::Work work;
  std::uint64_t seed = 1;
  while (state.KeepRunningBatch(ticks)) {
    mechanics::InsertionState array(*model);
    test::RandomHand hand(*model, setting.hand, setting.stylet, seed++);
    for (int i = 0; i < ticks; ++i) {
      mechanics::Drive drive = hand.next(array);
      drive.coupling = setting.coupling;
      drive.couplingStiffness = 441.0;
      drive.couplingDamping = 1.0;
      percentiles.time([&] { mechanics::advance(*model, array, drive); });
      work.add(array.readings);
    }
    if (!array.readings.isFinite) return state.SkipWithError("A number overflowed.");
  }
  percentiles.report(state);
  work.report(state);
}

void sizes(benchmark::internal::Benchmark* row)
{
  row->ArgName("nodes")->Arg(100)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(stepUnderHands, rough_bone, "rough_bone_on_a_spring", ticksOfOneHand)
    ->Name("tick/random_hand")
    ->Apply(sizes);
BENCHMARK_CAPTURE(stepUnderHands, round_window, "straight_through_the_round_window", ticksOfOneHand)
    ->Name("tick/rim_fold")
    ->Apply(sizes);
BENCHMARK_CAPTURE(stepUnderHands, counted, "rough_bone_on_a_spring", countedTicks)
    ->Name("count/random_hand/nodes:100")
    ->Arg(100);
BENCHMARK_CAPTURE(stepUnderHands, counted_rim, "straight_through_the_round_window", countedTicks)
    ->Name("count/rim_fold/nodes:100")
    ->Arg(100);

}  // namespace

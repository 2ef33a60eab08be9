// SPDX-License-Identifier: BSD-3-Clause

// The haptic loop on this machine's clock: how many ticks of the published insertion took place in
// some seconds, and how many began late. Says whether the thread had real-time priority.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace {

using namespace perilymph;

void loopByTheClock(benchmark::State& state)
{
  const double period = 1e-6 * static_cast<double>(state.range(0));  // [s]
  const auto scenario = session::loadScenario(
      "contour-published", {{"nodes", "100"}, {"dt_ms", std::to_string(1e3 * period)}});
  if (!scenario) return state.SkipWithError(scenario.error().message.c_str());
  const auto scala = session::buildAnatomy(*scenario);
  if (!scala) return state.SkipWithError("The anatomy could not be built.");
  const auto model = session::buildModel(*scenario, *scala);
  if (!model) return state.SkipWithError(model.error().message.c_str());
  for (auto _ : state) {
    device::ScriptedDevice hand(scenario->speed().si(), period);
    if (!hand.open()) return state.SkipWithError("The script did not open.");
    haptics::HapticLoop loop(
        hand, std::make_unique<haptics::InsertionEngine>(*model, scenario->engine()));
    loop.send({.kind = haptics::Command::Kind::arm});
    loop.start();
    hand.move(device::ScriptedDevice::Motion::insert);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(state.range(1));
    haptics::TickRecord record;
    while (std::chrono::steady_clock::now() < end) {
      while (loop.take(record)) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    loop.stop();
    const haptics::LoopStatistics found = loop.statistics();
    const auto seconds = static_cast<double>(state.range(1));
    const auto ticks = static_cast<double>(std::max<std::uint64_t>(found.ticks, 1));
    state.counters["ticks_per_s"] = static_cast<double>(found.ticks) / seconds;
    state.counters["late_percent"] = 100.0 * static_cast<double>(found.lateTicks) / ticks;
    state.counters["missed"] = static_cast<double>(found.missedTicks);
    state.counters["lost_records"] = static_cast<double>(found.lostRecords);
    state.counters["p50_us"] = 1e6 * found.tickTimeMedian;
    state.counters["p99_us"] = 1e6 * found.tickTimeP99;
    state.counters["max_us"] = 1e6 * found.tickTimeMax;
    state.counters["real_time_priority"] = found.hasRealTimePriority ? 1.0 : 0.0;
  }
}

BENCHMARK(loopByTheClock)
    ->Name("loop")
    ->ArgNames({"period_us", "seconds"})
    ->Args({1000, 10})
    ->Args({100, 60})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace

// SPDX-License-Identifier: BSD-3-Clause

// Time to list a library of ten thousand recordings: the first time, and with an index.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;

/// Copies of one short insertion as separate files.
std::string fill(const fs::path& folder, int sessions)
{
  const auto scenario =
      session::loadScenario("contour-published", {{"nodes", "30"}, {"stop_travel_mm", "0.2"}});
  if (!scenario) return scenario.error().message;
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      folder / "00000.insertion");
  if (!insertion) return insertion.error().message;
  if (const auto run = (*insertion)->runToEnd(nullptr); !run) return run.error().message;
  (*insertion).reset();
  for (int i = 1; i < sessions; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%05d.insertion", i);
    std::error_code failure;
    fs::create_hard_link(folder / "00000.insertion", folder / name, failure);
    if (failure) return "No link can be made: " + failure.message();
  }
  return {};
}

void library(benchmark::State& state, bool isKnown)
{
  const test::TemporaryFolder folder;
  const int sessions = static_cast<int>(state.range(0));
  if (const std::string error = fill(folder.path(), sessions); !error.empty())
    return state.SkipWithError(error.c_str());
  if (isKnown) static_cast<void>(session::listSessions(folder.path()));
  for (auto _ : state) {
    if (!isKnown) {
      state.PauseTiming();
      std::error_code ignored;
      fs::remove_all(session::libraryCache(folder.path()), ignored);
      state.ResumeTiming();
    }
    const auto listed = session::listSessions(folder.path());
    if (!listed || static_cast<int>(listed->size()) != sessions)
      return state.SkipWithError("The library was not listed whole.");
  }
}

BENCHMARK_CAPTURE(library, first, false)
    ->ArgName("sessions")
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(library, known, true)
    ->ArgName("sessions")
    ->Arg(10'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);

}  // namespace
}  // namespace perilymph

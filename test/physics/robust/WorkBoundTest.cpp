// SPDX-License-Identifier: BSD-3-Clause

// The bound of the work of a tick, under hands without skill in the settings whose ticks are longest,
// with the nodes of the loop: every tick stays within it. Times are the thread's own and are printed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "TrialSettings.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/realtime/ThreadTime.h"

namespace perilymph::test {
namespace {

struct Row {
  const char* setting;
  int nodes;
  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.setting << row.nodes; }
};

class WorkOfATick : public testing::TestWithParam<Row> {};

TEST_P(WorkOfATick, StaysWithinItsBound)
{
  const auto found = std::find_if(settings().begin(), settings().end(), [](const Setting& each) {
    return each.name == GetParam().setting;
  });
  ASSERT_NE(found, settings().end());
  Setting setting = *found;
  setting.nodes = GetParam().nodes;
  const auto model = build(setting);
  const mechanics::SolverParameters& solver = model->parts.solver;

  constexpr long ticksOfOneHand = 20'000;
  int evaluations = 0, factorizations = 0;
  std::vector<double> times_us;
  times_us.reserve(WORK_TICKS);
  for (std::uint64_t seed = 1; times_us.size() < WORK_TICKS; ++seed) {
    mechanics::InsertionState state(*model);
    RandomHand hand(*model, setting.hand, setting.stylet, seed);
    for (long i = 0; i < ticksOfOneHand && times_us.size() < WORK_TICKS; ++i) {
      mechanics::Drive drive = hand.next(state);
      drive.coupling = setting.coupling;
      drive.couplingStiffness = 441.0;
      drive.couplingDamping = 1.0;
      const std::int64_t began = realtime::threadNanoseconds();
      mechanics::advance(*model, state, drive);
      times_us.push_back(1e-3 * static_cast<double>(realtime::threadNanoseconds() - began));
      ASSERT_TRUE(state.readings.isFinite);
      evaluations = std::max(evaluations, state.readings.evaluations);
      factorizations = std::max(factorizations, state.readings.factorizations);
    }
  }
  EXPECT_LE(evaluations, solver.maxEvaluations);
  EXPECT_LE(factorizations, solver.maxFactorizations);

  std::sort(times_us.begin(), times_us.end());
  const auto at = [&times_us](double part) {
    return times_us[static_cast<std::size_t>(part * static_cast<double>(times_us.size() - 1))];
  };
  const long late =
      times_us.end() - std::upper_bound(times_us.begin(), times_us.end(), 1e6 * model->timeStep);
  std::printf(
      "%s, %d nodes: %zu ticks, at most %d evaluations and %d factorizations; thread time median "
      "%.0f, "
      "99 %% %.0f, 99.9 %% %.0f, largest %.0f us, %ld above the period\n",
      setting.name.c_str(), setting.nodes, times_us.size(), evaluations, factorizations, at(0.5),
      at(0.99), at(0.999), times_us.back(), late);
}

INSTANTIATE_TEST_SUITE_P(, WorkOfATick,
                         testing::Values(Row{"rough_bone_on_a_spring", 100},
                                         Row{"straight_through_the_round_window", 100},
                                         Row{"rough_bone_on_a_spring", 300},
                                         Row{"straight_through_the_round_window", 300}));

}  // namespace
}  // namespace perilymph::test

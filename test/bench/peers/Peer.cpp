// SPDX-License-Identifier: BSD-3-Clause
#include "Peer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace perilymph::bench {
namespace {

/// The project's lumen smooths ridges of the wall over one grid step. Its distances may differ from
/// the true wall by this much [m] (modules/anatomy/README.md, wall query): all, and nine tenths.
constexpr double maxFieldError = 39e-6;
constexpr double usualFieldError = 1.3e-6;

}  // namespace

void report(benchmark::State& state, const Facets& wall, const std::vector<double>& answers)
{
  std::vector<double> apart;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i] < 0.0) return state.SkipWithError("A wall within reach was not found.");
    apart.push_back(std::fabs(answers[i] - cloud().distances[i]));
  }
  std::sort(apart.begin(), apart.end());
  const double nineTenths = apart[apart.size() * 9 / 10];

  state.SetItemsProcessed(state.iterations());
  state.counters["triangles"] = static_cast<double>(wall.surface_mm.triangles.size());
  state.counters["facets_um"] = 1e6 * wall.surfaceDistance;
  state.counters["apart_p90_um"] = 1e6 * nineTenths;
  state.counters["apart_max_um"] = 1e6 * apart.back();
  if (apart.back() <= wall.surfaceDistance + maxFieldError &&
      nineTenths <= wall.surfaceDistance + usualFieldError)
    return;
  const std::string message = "The answers lie up to " + std::to_string(1e6 * apart.back()) +
                              " um from our own, nine tenths up to " +
                              std::to_string(1e6 * nineTenths) + "; the facets explain " +
                              std::to_string(1e6 * wall.surfaceDistance) + ".";
  state.SkipWithError(message.c_str());
}

}  // namespace perilymph::bench

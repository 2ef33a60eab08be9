// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/RenamedKeys.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace perilymph {
namespace {

struct RenamedKey {
  std::string_view before, now;
};

/// Keys of device profiles, arrays, calibrations, scenarios, variabilities and of the metadata of
/// recordings.
constexpr std::array<RenamedKey, 10> renamedKeys = {{
    {"dead_share", "dead_zone"},
    {"gain_share", "gain_fraction"},
    {"most_current_A", "max_current_A"},
    {"most_damping_N_s_m", "max_damping_N_s_m"},
    {"most_force_N", "max_force_N"},
    {"most_stiffness_N_m", "max_stiffness_N_m"},
    {"residual_curvature_share", "residual_curvature_fraction"},
    {"residual_sd_share", "residual_sd_fraction"},
    {"sd_share", "sd_fraction"},
    {"speed_sd_share", "speed_sd_fraction"},
}};

struct Warnings {
  std::mutex mutex;
  WarningHandler handler;
  std::vector<std::string> waiting;  ///< Issued before there was a handler.
  std::set<std::string> known;
};

Warnings& warnings()
{
  static Warnings instance;
  return instance;
}

}  // namespace

std::string_view currentKey(std::string_view key) noexcept
{
  const auto found = std::find_if(renamedKeys.begin(), renamedKeys.end(),
                                  [key](const RenamedKey& each) { return each.before == key; });
  return found == renamedKeys.end() ? key : found->now;
}

std::string RenamedKeyUse::warning() const
{
  return place + "the key '" + path + "' is now called '" + now +
         "'; the old name is read until version 1.0. Rename it.";
}

void setWarningHandler(WarningHandler handler)
{
  Warnings& all = warnings();
  const std::lock_guard lock(all.mutex);
  all.handler = std::move(handler);
  if (!all.handler) return;
  for (const std::string& warning : all.waiting) all.handler(warning);
  all.waiting.clear();
}

void warn(const std::string& warning)
{
  Warnings& all = warnings();
  const std::lock_guard lock(all.mutex);
  if (!all.known.insert(warning).second) return;
  if (all.handler)
    all.handler(warning);
  else
    all.waiting.push_back(warning);
}

}  // namespace perilymph

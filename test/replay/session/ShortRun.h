// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A short insertion of the published scenario into a file.

#include <gtest/gtest.h>

#include <filesystem>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::test {

/// An array whose wires yield from the first bend on.
inline const session::Overrides yieldingArray = {{"array", "slim-straight"},
                                                 {"wire_yield_MPa", "150"}};

inline std::unique_ptr<session::Insertion> shortRun(const std::filesystem::path& file,
                                                    session::Overrides more = {})
{
  session::Overrides overrides = {{"nodes", "40"}, {"stop_travel_mm", "1.0"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  const auto scenario = session::loadScenario("contour-published", overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      file);
  EXPECT_TRUE(insertion) << insertion.error().message;
  return std::move(*insertion);
}

}  // namespace perilymph::test

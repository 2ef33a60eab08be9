// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A short scenario: few nodes, a fraction of a millimeter.

#include <gtest/gtest.h>

#include "perilymph/session/Scenario.h"

namespace perilymph::test {

inline session::Scenario shortScenario(session::Overrides more = {})
{
  session::Overrides overrides = {{"nodes", "20"}, {"stop_travel_mm", "0.2"}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  auto scenario = session::loadScenario("contour-published", overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  return *scenario;
}

}  // namespace perilymph::test

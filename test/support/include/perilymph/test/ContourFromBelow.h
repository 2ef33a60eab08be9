// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An insertion that goes through the cochlear partition.

#include "perilymph/session/Scenario.h"

namespace perilymph::test {

/// Changes of the scenario surgery-flex28: a Contour with its stylet in, tilted upward. With 0.042 N
/// it goes through at 57 degrees; with 0 N the partition holds.
inline session::Overrides contourFromBelow(const char* strength_N = "0.042")
{
  return {{"array", "contour"},
          {"stop_travel_mm", "17"},
          {"friction", "soap-10"},
          {"approach_tilt_deg", "15"},
          {"speed_mm_s", "2"},
          {"dt_ms", "2"},
          {"partition_strength_N", strength_N}};
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force that a plan expects at a travel.

namespace perilymph::charts {

/// Median and band of the axial force at one travel.
struct ExpectedForce {
  double travel_mm = 0.0;
  double low_mN = 0.0, median_mN = 0.0, high_mN = 0.0;
};

}  // namespace perilymph::charts

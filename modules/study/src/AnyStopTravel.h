// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace perilymph::study {

/// Value of `stop_travel_mm` that every array allows, for a scenario that is read before the array's
/// full depth is known and replaces it.
inline constexpr const char* anyStopTravel = "0.1";

}  // namespace perilymph::study

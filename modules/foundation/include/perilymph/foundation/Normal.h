// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace perilymph {

/// Half width of the 95 % interval of a normal distribution, in standard deviations.
inline constexpr double halfWidth95 = 1.96;

}  // namespace perilymph

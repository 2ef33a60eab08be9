// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The ways in which the window stops a device.

#include <array>

namespace perilymph::hidstack {

/// Names of the measures, in the order of the scene.
inline constexpr std::array stopWays{"pause",      "escape",        "stop_button", "page_left",
                                     "focus_away", "screen_locked", "quit"};

/// Time without focus after which the window stops the device [s].
inline constexpr double focusTime = 1.0;

/// Force of the hand into the wall, close to the maximum of the virtual handle (3.2 N) [N].
inline constexpr double strongPush = 3.0;

}  // namespace perilymph::hidstack

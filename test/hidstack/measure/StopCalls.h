// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the window calls in each of the ways in which it stops a device.

#include <array>

#include "StopWays.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/SafetyStop.h"

namespace perilymph::hidstack {

using StopCall = void (*)(gui::InsertionControl&, gui::SafetyStop&);

/// In the order of stopWays.
inline constexpr std::array<StopCall, stopWays.size()> stopCalls{
    [](auto& control, auto&) { control.pause(); },
    [](auto&, auto& safety) { safety.stopDevice(); },
    [](auto&, auto& safety) { safety.stopDevice(); },
    [](auto&, auto& safety) { safety.onPageHidden(); },
    [](auto&, auto& safety) { safety.loseKeyboard(); },
    [](auto&, auto& safety) { safety.stopDevice(); },
    [](auto&, auto& safety) { safety.end(); }};

}  // namespace perilymph::hidstack

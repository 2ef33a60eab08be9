// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Why a library is refused by the process that loads it. The sentences cross a pipe as text; the
// program recognizes them by these phrases, so that the window can translate them.

#include <array>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::device::plugin::refusals {

inline constexpr Phrase cannotBeLoaded{"it cannot be loaded: %1. Build it for this machine."};
inline constexpr Phrase isNoPlugin{"it exports no %1. It is not a device plug-in."};
inline constexpr Phrase givesNothing{"%1() gives nothing."};
inline constexpr Phrase isOfAnotherVersion{
    "it is built for version %1 of PluginApi.h, this program for version %2. Build it with the "
    "header of this program."};
inline constexpr Phrase isIncomplete{
    "one of its functions is missing. Fill in all of PerilymphDeviceV1."};
inline constexpr Phrase findsNoDevice{"it finds no device. Plug the device in and try again."};
inline constexpr Phrase tellsNoTraits{"it does not tell its traits."};

/// Not from the process that loads it, but from the program that waits for it.
inline constexpr Phrase isTooSlow{
    "it did not answer within %1 s while it was loaded, and was ended. Tell its maker."};

inline constexpr std::array all{cannotBeLoaded, isNoPlugin,    givesNothing, isOfAnotherVersion,
                                isIncomplete,   findsNoDevice, tellsNoTraits};

}  // namespace perilymph::device::plugin::refusals

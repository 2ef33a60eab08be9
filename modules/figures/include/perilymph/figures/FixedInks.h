// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Colors that no color scheme changes: of reports on paper, and of marks on the pictures of a CT. Those of
// figures are in Figure.h, those of the screen in Palette.h.

#include <array>

#include "perilymph/figures/Drawing.h"

namespace perilymph::figures {

/// On white paper.
namespace ink {
inline constexpr Ink quiet{{0x4A, 0x56, 0x61}, 1.0};  ///< Quiet text of reports.
inline constexpr Ink bone{{0x6B, 0x5D, 0x42}, 1.0}, lumen{{0xE9, 0xDC, 0xC0}, 110.0 / 255.0};
inline constexpr Ink silicone{{0x8A, 0x99, 0xA4}, 1.0}, platinum{{0x2F, 0x3B, 0x44}, 1.0};
/// Electrode arrays of one report, distinguishable without red and green (Okabe and Ito 2008).
inline constexpr std::array<Ink, 6> arrays{{{{0x00, 0x72, 0xB2}, 1.0},
                                            {{0xD5, 0x5E, 0x00}, 1.0},
                                            {{0x00, 0x9E, 0x73}, 1.0},
                                            {{0xCC, 0x79, 0xA7}, 1.0},
                                            {{0x5A, 0x4F, 0x1E}, 1.0},
                                            {{0x3D, 0x9B, 0xD1}, 1.0}}};
}  // namespace ink

/// On the gray pictures of a CT. Each plane is also named.
namespace onCt {
inline constexpr Ink ground{{0, 0, 0}, 1.0};  ///< Where there is no picture.
inline constexpr Ink mark{{255, 255, 255}, 1.0};
inline constexpr Ink shadow{{0, 0, 0}, 176.0 / 255.0};  ///< Below lines and text.
inline constexpr Ink outline{{0x45, 0xC4, 0xB0}, 1.0};  ///< The measured wall; a mark that is held.
inline constexpr Ink array{{0xFF, 0xE0, 0x8A}, 1.0};
inline constexpr Ink markup{{0xF4, 0xA6, 0xD7}, 1.0};    ///< Distances, angles, notes, structures.
inline constexpr Ink approach{{0xFF, 0x9E, 0x5E}, 1.0};  ///< Line of approach.
inline constexpr std::array<Ink, 3> planes{
    {{{0xE6, 0x9F, 0x00}, 1.0}, {{0x56, 0xB4, 0xE9}, 1.0}, {{0x9F, 0xD4, 0x5F}, 1.0}}};
}  // namespace onCt

/// Over the surface of bone, which is light in both schemes.
namespace onBone {
inline constexpr Ink markup{{0xB4, 0x2A, 0x86}, 1.0};  ///< The hue of onCt::markup.
}  // namespace onBone

}  // namespace perilymph::figures

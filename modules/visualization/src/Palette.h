#pragma once

// Colors of what is seen in the operation view.

#include <array>

namespace perilymph::visualization {

/// Red, green, blue, opacity; each 0 to 255.
using Rgba = std::array<unsigned char, 4>;

namespace palette {

inline constexpr Rgba bone{0xE9, 0xDC, 0xC0, 255};
inline constexpr Rgba membrane{0xC7, 0x80, 0x8B, 255};
inline constexpr Rgba silicone{0xDC, 0xE4, 0xE9, 255};
inline constexpr Rgba platinum{0x7C, 0x8A, 0x94, 255};
inline constexpr Rgba platinumRim{0xF4, 0xF7, 0xF9, 255};
inline constexpr Rgba rib{0xB9, 0xC4, 0xCB, 255};
inline constexpr Rgba steel{0x9A, 0xA7, 0xB0, 255};
inline constexpr Rgba outline{0x0B, 0x0F, 0x12, 255};
inline constexpr Rgba arrow{0xE6, 0x9F, 0x00, 255};
inline constexpr Rgba frictionArrow{0x56, 0xB4, 0xE9, 255};
inline constexpr Rgba forceLow{0xF5, 0xC2, 0x4B, 255};
inline constexpr Rgba forceHigh{0xD5, 0x44, 0x2E, 255};
inline constexpr Rgba ground{0x12, 0x16, 0x1A, 255};
inline constexpr Rgba groundLight{0x25, 0x31, 0x38, 255};
inline constexpr Rgba text{0xE8, 0xEC, 0xEF, 255};
inline constexpr Rgba quietText{0x93, 0xA1, 0xAC, 255};

}  // namespace palette

constexpr Rgba withOpacity(Rgba color, double opacity)
{
  color[3] = static_cast<unsigned char>(opacity * 255.0 + 0.5);
  return color;
}

}  // namespace perilymph::visualization

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Palette.h"

namespace perilymph::figures {

namespace {

constexpr Ink opaque(std::uint32_t rgb)
{
  return {{static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 0xFF),
           static_cast<std::uint8_t>(rgb & 0xFF)},
          1.0};
}

constexpr double lumenOpacity = 0.13;

}  // namespace

const Palette& paletteOf(ColorScheme scheme)
{
  static constexpr Palette dark{
      .scheme = ColorScheme::dark,
      .ground = opaque(0x12161A),
      .panel = opaque(0x1A2026),
      .raised = opaque(0x26313A),
      .pressed = opaque(0x3A4854),
      .banner = opaque(0x2B2114),
      .line = opaque(0x2A323A),
      .border = opaque(0x667582),
      .ahead = opaque(0x6A7A88),
      .grid = opaque(0x2A323A),
      .zero = opaque(0x55616B),
      .text = opaque(0xE8ECEF),
      .quiet = opaque(0x93A1AC),
      .accent = opaque(0x45C4B0),
      .accentHover = opaque(0x5AD3C0),
      .onAccent = opaque(0x0B1412),
      .blue = opaque(0x56B4E9),
      .orange = opaque(0xE69F00),
      .pink = opaque(0xE38FC0),
      .warning = opaque(0xE69F00),
      .onWarning = opaque(0x14110A),
      .alarm = opaque(0xD55E00),
      .stop = opaque(0xC4161C),
      .stopPressed = opaque(0x8E0F14),
      .onStop = opaque(0xFFFFFF),
      .bone = opaque(0xE9DCC0),
      .lumen = faded(opaque(0xE9DCC0), lumenOpacity),
      .membrane = opaque(0xC7808B),
      .rupture = opaque(0xFF4D4D),
      .silicone = opaque(0xDCE4E9),
      .platinum = opaque(0x5E6C77),
      .outline = opaque(0x0B0F12),
      .litSilicone = opaque(0xDCE4E9),
      .litPlatinum = opaque(0x7C8A94),
      .platinumRim = opaque(0xF4F7F9),
      .rib = opaque(0xB9C4CB),
      .steel = opaque(0x9AA7B0),
      .forceLow = opaque(0xB83624),
      .forceHigh = opaque(0xFFE26E),
      .sceneGround = opaque(0x12161A),
      .sceneGroundLight = opaque(0x253138),
      .ghost = opaque(0x2F7FBF),
  };
  // the same hues, dark enough for a white background; bone and membrane so that their edges stand out
  static constexpr Palette light{
      .scheme = ColorScheme::light,
      .ground = opaque(0xFFFFFF),
      .panel = opaque(0xF1F4F6),
      .raised = opaque(0xDFE6EA),
      .pressed = opaque(0xAEBBC4),
      .banner = opaque(0xFFF1D6),
      .line = opaque(0xC9D3DA),
      .border = opaque(0x7C8A95),
      .ahead = opaque(0x76848F),
      .grid = opaque(0xD8DFE4),
      .zero = opaque(0x8A96A0),
      .text = opaque(0x141B21),
      .quiet = opaque(0x4A5661),
      .accent = opaque(0x086B5D),
      .accentHover = opaque(0x0A5C50),
      .onAccent = opaque(0xFFFFFF),
      .blue = opaque(0x00629B),
      .orange = opaque(0x8F5500),
      .pink = opaque(0x9B2F72),
      .warning = opaque(0x7A4C00),
      .onWarning = opaque(0xFFFFFF),
      .alarm = opaque(0xA93A00),
      .stop = opaque(0xC4161C),
      .stopPressed = opaque(0x8E0F14),
      .onStop = opaque(0xFFFFFF),
      .bone = opaque(0x8A774F),
      .lumen = faded(opaque(0x8A774F), lumenOpacity),
      .membrane = opaque(0xA8475A),
      .rupture = opaque(0xB00020),
      .silicone = opaque(0x8496A1),
      .platinum = opaque(0x46535D),
      .outline = opaque(0x0B0F12),
      .litSilicone = opaque(0xC3CED6),
      .litPlatinum = opaque(0x56636D),
      .platinumRim = opaque(0xFFFFFF),
      .rib = opaque(0x8496A1),
      .steel = opaque(0x66737C),
      .forceLow = opaque(0xF5C24B),
      .forceHigh = opaque(0x9E1F12),
      .sceneGround = opaque(0xE6ECEF),
      .sceneGroundLight = opaque(0xFFFFFF),
      .ghost = opaque(0x004B78),
  };
  return scheme == ColorScheme::light ? light : dark;
}

}  // namespace perilymph::figures

// SPDX-License-Identifier: BSD-3-Clause
#include "SceneColors.h"

namespace perilymph::visualization {

SceneColors::SceneColors(const figures::Palette& palette)
    : scheme(palette.scheme),
      bone(rgbaOf(palette.bone)),
      membrane(rgbaOf(palette.membrane)),
      silicone(rgbaOf(palette.litSilicone)),
      platinum(rgbaOf(palette.litPlatinum)),
      platinumRim(rgbaOf(palette.platinumRim)),
      rib(rgbaOf(palette.rib)),
      steel(rgbaOf(palette.steel)),
      outline(rgbaOf(palette.outline)),
      arrow(rgbaOf(palette.orange)),
      frictionArrow(rgbaOf(palette.blue)),
      forceLow(rgbaOf(palette.forceLow)),
      forceHigh(rgbaOf(palette.forceHigh)),
      lumen(rgbaOf(palette.accent)),
      // lit, on either ground
      solidBone(rgbaOf(figures::paletteOf(figures::ColorScheme::dark).bone)),
      ground(rgbaOf(palette.sceneGround)),
      groundLight(rgbaOf(palette.sceneGroundLight)),
      text(rgbaOf(palette.text)),
      quietText(rgbaOf(palette.quiet)),
      rupture(rgbaOf(palette.rupture)),
      ghost(rgbaOf(palette.ghost))
{
}

const SceneColors& sceneColorsOf(figures::ColorScheme scheme)
{
  static const SceneColors dark(figures::paletteOf(figures::ColorScheme::dark));
  static const SceneColors light(figures::paletteOf(figures::ColorScheme::light));
  return scheme == figures::ColorScheme::light ? light : dark;
}

}  // namespace perilymph::visualization

#pragma once

// Colors of what is seen in the operation view.

#include <array>
#include <cmath>

namespace perilymph::visualization {

/// Red, green, blue, opacity; each 0 to 255.
using Rgba = std::array<unsigned char, 4>;

namespace palette {

struct Colors {
  Rgba bone, membrane, silicone, platinum, platinumRim, rib, steel, outline, arrow, frictionArrow,
      forceLow, forceHigh, ground, groundLight, text, quietText;
};

/// The colors of the shown scheme. The object stays where it is when the scheme changes.
const Colors& shown();

inline const Rgba& bone = shown().bone;
inline const Rgba& membrane = shown().membrane;
inline const Rgba& silicone = shown().silicone;
inline const Rgba& platinum = shown().platinum;
inline const Rgba& platinumRim = shown().platinumRim;
inline const Rgba& rib = shown().rib;
inline const Rgba& steel = shown().steel;
inline const Rgba& outline = shown().outline;
inline const Rgba& arrow = shown().arrow;
inline const Rgba& frictionArrow = shown().frictionArrow;
inline const Rgba& forceLow = shown().forceLow;
inline const Rgba& forceHigh = shown().forceHigh;
inline const Rgba& ground = shown().ground;
inline const Rgba& groundLight = shown().groundLight;
inline const Rgba& text = shown().text;
inline const Rgba& quietText = shown().quietText;

}  // namespace palette

inline Rgba withOpacity(Rgba color, double opacity)
{
  color[3] = static_cast<unsigned char>(std::lround(opacity * 255.0));
  return color;
}

}  // namespace perilymph::visualization

#include "SheetInk.h"

namespace perilymph::charts::ink {

namespace {

// in functions, because views may be asked before this file's constants are there
const Inks& dark()
{
  static const Inks inks{
      .panel = {{0x1A, 0x20, 0x26}, 1.0},
      .ground = {{0x12, 0x16, 0x1A}, 1.0},
      .grid = {{0x2A, 0x32, 0x3A}, 1.0},
      .zero = {{0x55, 0x61, 0x6B}, 1.0},
      .text = {{0xE8, 0xEC, 0xEF}, 1.0},
      .quiet = {{0x93, 0xA1, 0xAC}, 1.0},
      .accent = {{0x45, 0xC4, 0xB0}, 1.0},
      .orange = {{0xE6, 0x9F, 0x00}, 1.0},
      .bone = {{0xE9, 0xDC, 0xC0}, 1.0},
      .lumen = {{0xE9, 0xDC, 0xC0}, 0.13},
      .membrane = {{0xC7, 0x80, 0x8B}, 1.0},
      .silicone = {{0xDC, 0xE4, 0xE9}, 1.0},
      .platinum = {{0x5E, 0x6C, 0x77}, 1.0},
  };
  return inks;
}

// the same hues, dark enough to be read on white
const Inks& light()
{
  static const Inks inks{
      .panel = {{0xF1, 0xF4, 0xF6}, 1.0},
      .ground = {{0xFF, 0xFF, 0xFF}, 1.0},
      .grid = {{0xD8, 0xDF, 0xE4}, 1.0},
      .zero = {{0x8A, 0x96, 0xA0}, 1.0},
      .text = {{0x14, 0x1B, 0x21}, 1.0},
      .quiet = {{0x4A, 0x56, 0x61}, 1.0},
      .accent = {{0x08, 0x6B, 0x5D}, 1.0},
      .orange = {{0x8F, 0x55, 0x00}, 1.0},
      .bone = {{0x8A, 0x77, 0x4F}, 1.0},
      .lumen = {{0x8A, 0x77, 0x4F}, 0.13},
      .membrane = {{0xA8, 0x47, 0x5A}, 1.0},
      .silicone = {{0x84, 0x96, 0xA1}, 1.0},
      .platinum = {{0x46, 0x53, 0x5D}, 1.0},
  };
  return inks;
}

Inks& current()
{
  static Inks inks = dark();
  return inks;
}

}  // namespace

const Inks& shown() { return current(); }

void show(ColorScheme look) { current() = look == ColorScheme::light ? light() : dark(); }

}  // namespace perilymph::charts::ink

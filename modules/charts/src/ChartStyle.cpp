#include "ChartStyle.h"

#include "SheetInk.h"

namespace perilymph::charts {

namespace style {
namespace {

// in functions, because charts may be created before this file's constants are initialized
const Colors& dark()
{
  static const Colors colors{
      {0x1A, 0x20, 0x26, 255}, {0x12, 0x16, 0x1A, 255}, {0x2A, 0x32, 0x3A, 255},
      {0x55, 0x61, 0x6B, 255}, {0xE8, 0xEC, 0xEF, 255}, {0x93, 0xA1, 0xAC, 255},
      {0x45, 0xC4, 0xB0, 255}, {0x56, 0xB4, 0xE9, 255}, {0xE6, 0x9F, 0x00, 255}};
  return colors;
}

// the same hues, dark enough for a white background
const Colors& light()
{
  static const Colors colors{
      {0xF1, 0xF4, 0xF6, 255}, {0xFF, 0xFF, 0xFF, 255}, {0xD8, 0xDF, 0xE4, 255},
      {0x8A, 0x96, 0xA0, 255}, {0x14, 0x1B, 0x21, 255}, {0x4A, 0x56, 0x61, 255},
      {0x08, 0x6B, 0x5D, 255}, {0x00, 0x62, 0x9B, 255}, {0x8F, 0x55, 0x00, 255}};
  return colors;
}

Colors& current()
{
  static Colors colors = dark();
  return colors;
}

}  // namespace

const Colors& shown() { return current(); }

}  // namespace style

void setColorScheme(ColorScheme look)
{
  style::current() = look == ColorScheme::light ? style::light() : style::dark();
  ink::show(look);
}

}  // namespace perilymph::charts

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace perilymph::figures {
namespace {

/// Relative luminance, WCAG 2.1.
double luminance(const Ink& ink)
{
  const auto linear = [](std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(ink.rgb[0]) + 0.7152 * linear(ink.rgb[1]) + 0.0722 * linear(ink.rgb[2]);
}

double contrast(const Ink& one, const Ink& other)
{
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST(ColorScheme, LabelsHaveAContrastOf4Point5OnBothGrounds)
{
  for (const ColorScheme scheme : {ColorScheme::dark, ColorScheme::light}) {
    const Palette& inks = paletteOf(scheme);
    for (const Ink& ground : {inks.ground, inks.panel})
      for (const Ink& label : {inks.text, inks.quiet, inks.accent, inks.orange, inks.blue})
        EXPECT_GE(contrast(label, ground), 4.5);
  }
}

TEST(ColorScheme, DarkIsDarkerThanLight)
{
  EXPECT_LT(luminance(paletteOf(ColorScheme::dark).ground), 0.1);
  EXPECT_GT(luminance(paletteOf(ColorScheme::light).ground), 0.9);
}

}  // namespace
}  // namespace perilymph::figures

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Polygon rasterization with antialiasing.

#include <array>
#include <cstdint>
#include <vector>

#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// A white RGB page. Positions are pixels from the upper left corner.
class Canvas {
public:
  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Adds a polygon to the stencil: even-odd rule within each polygon, union of all of them.
  void outline(const std::vector<figures::PagePoint>& polygon);
  /// Paints the stencil and clears it.
  void paint(const figures::Ink& ink);
  /// Paints one pixel partially.
  void blend(int x, int y, const figures::Ink& ink, double fraction);

  const std::uint8_t* row(int y) const;

private:
  static constexpr int fine = 4;  // subpixels in each direction

  int width_, height_;
  std::vector<std::uint8_t> pixels_;
  std::vector<std::uint8_t> stencil_;  // subpixels, 1 inside
  int firstRow_, lastRow_;             // subpixel rows in use
};

}  // namespace perilymph::charts

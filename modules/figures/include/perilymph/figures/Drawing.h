// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A drawing of lines, areas, disks and text.

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace perilymph::figures {

/// A point on the page [1/72 inch], from the upper left corner.
struct PagePoint {
  double x = 0.0, y = 0.0;
};

struct Ink {
  std::array<std::uint8_t, 3> rgb{0, 0, 0};
  double opacity = 1.0;

  friend bool operator==(const Ink&, const Ink&) = default;
};

/// A polyline.
struct Stroke {
  std::vector<PagePoint> points;
  Ink ink;
  double width = 1.0;
  double dash = 0.0;  ///< Length of dashes and gaps; 0: solid.
};

/// A filled polygon.
struct Area {
  std::vector<PagePoint> points;
  Ink ink;
};

/// A filled circle, with an outline of another color.
struct Disk {
  PagePoint center;
  double radius = 3.0;
  Ink fill, outline;
};

enum class Anchor { start, middle, end };
enum class Direction { across, upward };

/// Text, positioned by its base line.
struct Label {
  PagePoint at;
  std::string text;
  double size = 9.0;
  Ink ink;
  Anchor anchor = Anchor::start;
  Direction direction = Direction::across;
  bool isBold = false;
};

using Mark = std::variant<Area, Stroke, Disk, Label>;

/// The content of a drawing in painting order, on white.
struct Drawing {
  double width = 480.0, height = 320.0;
  std::vector<Mark> marks;
};

}  // namespace perilymph::figures

// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include <algorithm>
#include <cmath>

namespace perilymph::charts {

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 255),
      stencil_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * fine * fine, 0),
      firstRow_(height * fine),
      lastRow_(-1)
{
}

void Canvas::outline(const std::vector<figures::PagePoint>& polygon)
{
  if (polygon.size() < 3) return;
  double low = polygon.front().y, high = low;
  for (const figures::PagePoint& point : polygon) {
    low = std::min(low, point.y);
    high = std::max(high, point.y);
  }
  const int first = std::max(0, static_cast<int>(std::floor(low * fine)));
  const int last = std::min(height_ * fine - 1, static_cast<int>(std::ceil(high * fine)));
  firstRow_ = std::min(firstRow_, first);
  lastRow_ = std::max(lastRow_, last);

  const int columns = width_ * fine;
  std::vector<double> crossings;
  for (int row = first; row <= last; ++row) {
    const double y = (row + 0.5) / fine;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const figures::PagePoint& a = polygon[i];
      const figures::PagePoint& b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= y) != (b.y <= y))
        crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int from = std::clamp(static_cast<int>(std::lround(crossings[i] * fine)), 0, columns);
      const int to = std::clamp(static_cast<int>(std::lround(crossings[i + 1] * fine)), 0, columns);
      std::fill(stencil_.begin() + static_cast<std::ptrdiff_t>(start) + from,
                stencil_.begin() + static_cast<std::ptrdiff_t>(start) + std::max(from, to),
                std::uint8_t{1});
    }
  }
}

void Canvas::paint(const figures::Ink& ink)
{
  const std::size_t columns = static_cast<std::size_t>(width_) * fine;
  for (int y = std::max(0, firstRow_ / fine); y <= lastRow_ / fine && y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      int inside = 0;
      for (int part = 0; part < fine; ++part) {
        const std::size_t start = static_cast<std::size_t>(y * fine + part) * columns +
                                  static_cast<std::size_t>(x) * fine;
        for (std::size_t k = 0; k < fine; ++k) inside += stencil_[start + k];
      }
      if (inside > 0) blend(x, y, ink, inside / static_cast<double>(fine * fine));
    }
    const auto begin = stencil_.begin() + static_cast<std::ptrdiff_t>(columns) * y * fine;
    std::fill(begin, begin + static_cast<std::ptrdiff_t>(columns) * fine, std::uint8_t{0});
  }
  firstRow_ = height_ * fine;
  lastRow_ = -1;
}

void Canvas::blend(int x, int y, const figures::Ink& ink, double fraction)
{
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const double cover = std::clamp(ink.opacity * fraction, 0.0, 1.0);
  std::uint8_t* pixel =
      pixels_.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x)) *
                           3;
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] =
        static_cast<std::uint8_t>(std::lround((1.0 - cover) * pixel[c] + cover * ink.rgb[c]));
}

const std::uint8_t* Canvas::row(int y) const
{
  return pixels_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) * 3;
}

}  // namespace perilymph::charts

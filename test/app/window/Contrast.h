// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Relative luminance and contrast as WCAG 2.1 defines them.

#include <QColor>
#include <algorithm>
#include <cmath>

namespace perilymph::test {

inline double linear(double channel)
{
  return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

inline double luminance(const QColor& color)
{
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

inline double contrast(const QColor& a, const QColor& b)
{
  const double high = std::max(luminance(a), luminance(b));
  const double low = std::min(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

}  // namespace perilymph::test

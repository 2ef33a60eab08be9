// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/TrustRadius.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace perilymph::anatomy {
namespace {

constexpr std::size_t levels = std::size(trustRadii);

/// Sum of the squared third derivatives at each coefficient of a section [1/m^4]: the squared
/// Frobenius norm, which bounds the derivative in every direction.
void thirdDerivatives(const float* d, std::size_t across, double width, double height,
                      float* squared)
{
  const auto perP = static_cast<float>(1.0 / width), perQ = static_cast<float>(1.0 / height);
  const float ppp = perP * perP * perP, ppq = perP * perP * perQ, pqq = perP * perQ * perQ,
              qqq = perQ * perQ * perQ;
  // beyond the last differences the table is extrapolated and not trusted
  std::fill_n(squared, across * across, 1e30f);
  for (std::size_t i = 0; i + 3 < across; ++i)
    for (std::size_t j = 0; j + 3 < across; ++j) {
      const float* c = d + i * across + j;
      const float* c1 = c + across;
      const float* c2 = c1 + across;
      const float* c3 = c2 + across;
      const float byPpp = ppp * ((c3[0] - c[0]) - 3.0f * (c2[0] - c1[0]));
      const float byQqq = qqq * ((c[3] - c[0]) - 3.0f * (c[2] - c[1]));
      const float byPpq = ppq * ((c2[1] - 2.0f * c1[1] + c[1]) - (c2[0] - 2.0f * c1[0] + c[0]));
      const float byPqq = pqq * ((c1[2] - 2.0f * c1[1] + c1[0]) - (c[2] - 2.0f * c[1] + c[0]));
      squared[i * across + j] =
          byPpp * byPpp + 3.0f * (byPpq * byPpq + byPqq * byPqq) + byQqq * byQqq;
    }
}

/// The maximum over each window of six along a line: four coefficients of a cell and one cell to each
/// side. Lines of `width` values side by side are computed together.
void maxOfSix(const float* from, std::size_t length, std::size_t step, std::size_t width, float* to)
{
  for (std::size_t k = 0; k < length; ++k) {
    const std::size_t first = k > 0 ? k - 1 : 0, last = std::min(k + 4, length - 1);
    float* const row = to + k * step;
    std::copy_n(from + first * step, width, row);
    for (std::size_t m = first + 1; m <= last; ++m) {
      const float* const other = from + m * step;
      for (std::size_t i = 0; i < width; ++i) row[i] = row[i] < other[i] ? other[i] : row[i];
    }
  }
}

}  // namespace

std::uint8_t trustLevel(double thirdDerivative) noexcept
{
  std::uint8_t level = 0;
  while (level + 1u < levels) {
    const double r = trustRadii[level + 1];
    if (!(thirdDerivative * (r * r * r) <= 6.0 * trustError)) break;
    ++level;
  }
  return level;
}

std::vector<std::uint8_t> trustLevels(const std::vector<float>& distance, std::size_t across,
                                      const std::vector<double>& cellWidth,
                                      const std::vector<double>& cellHeight)
{
  const std::size_t page = across * across, sections = cellWidth.size();
  // the squares at which the next smaller radius is taken
  float bounds[levels];
  for (std::size_t k = 1; k < levels; ++k) {
    const double third = 6.0 * trustError / (trustRadii[k] * trustRadii[k] * trustRadii[k]);
    bounds[k] = static_cast<float>(third * third);
    // the last value that is not beyond
    if (static_cast<double>(bounds[k]) > third * third) bounds[k] = std::nextafter(bounds[k], 0.0f);
  }
  std::vector<std::uint8_t> inSection(sections * page), all(sections * page);
  std::vector<float> squared(page), wide(page), turned(page);
  std::vector<std::int32_t> level(page);
  for (std::size_t s = 0; s < sections; ++s) {
    thirdDerivatives(distance.data() + s * page, across, cellWidth[s], cellHeight[s],
                     squared.data());
    maxOfSix(squared.data(), across, across, across, wide.data());
    for (std::size_t i = 0; i < across; ++i)
      for (std::size_t j = 0; j < across; ++j) turned[j * across + i] = wide[i * across + j];
    maxOfSix(turned.data(), across, across, across, wide.data());
    // the bounds decrease
    const float* const largest = wide.data();
    std::int32_t* const to = level.data();
    std::fill_n(to, page, 0);
    for (std::size_t m = 1; m < levels; ++m)
      for (std::size_t k = 0; k < page; ++k) to[k] += largest[k] <= bounds[m] ? 1 : 0;
    for (std::size_t i = 0; i < across; ++i)
      for (std::size_t j = 0; j < across; ++j)
        inSection[s * page + i * across + j] = static_cast<std::uint8_t>(to[j * across + i]);
  }
  for (std::size_t s = 0; s < sections; ++s) {
    std::uint8_t* to = all.data() + s * page;
    const std::size_t first = s > 0 ? s - 1 : 0, last = std::min(s + 4, sections - 1);
    std::copy_n(inSection.data() + first * page, page, to);
    for (std::size_t m = first + 1; m <= last; ++m) {
      const std::uint8_t* from = inSection.data() + m * page;
      for (std::size_t k = 0; k < page; ++k) to[k] = std::min(to[k], from[k]);
    }
  }
  return all;
}

}  // namespace perilymph::anatomy

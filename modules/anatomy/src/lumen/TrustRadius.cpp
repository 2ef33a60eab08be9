// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/TrustRadius.h"

#include <algorithm>
#include <iterator>

namespace perilymph::anatomy {
namespace {

constexpr std::size_t levels = std::size(trustRadii);

/// Sum of the squared third derivatives at each coefficient of a section [1/m^4]: the squared
/// Frobenius norm, which bounds the derivative in every direction.
void thirdDerivatives(const float* d, std::size_t across, double width, double height,
                      std::vector<float>& squared)
{
  const auto perP = static_cast<float>(1.0 / width), perQ = static_cast<float>(1.0 / height);
  const float ppp = perP * perP * perP, ppq = perP * perP * perQ, pqq = perP * perQ * perQ,
              qqq = perQ * perQ * perQ;
  // beyond the last differences the table is extrapolated and not trusted
  std::fill(squared.begin(), squared.end(), 1e30f);
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

/// The maximum over each window of six rows or columns: four coefficients of a cell and one cell to
/// each side.
void maxOfSix(const std::vector<float>& from, std::size_t lines, std::size_t length,
              std::size_t lineStep, std::size_t step, std::vector<float>& to)
{
  for (std::size_t line = 0; line < lines; ++line)
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t first = k > 0 ? k - 1 : 0, last = std::min(k + 4, length - 1);
      float largest = 0.0f;
      for (std::size_t m = first; m <= last; ++m)
        largest = std::max(largest, from[line * lineStep + m * step]);
      to[line * lineStep + k * step] = largest;
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
  double bounds[levels];
  for (std::size_t k = 1; k < levels; ++k) {
    const double third = 6.0 * trustError / (trustRadii[k] * trustRadii[k] * trustRadii[k]);
    bounds[k] = third * third;
  }
  std::vector<std::uint8_t> inSection(sections * page), all(sections * page);
  std::vector<float> squared(page), wide(page);
  for (std::size_t s = 0; s < sections; ++s) {
    thirdDerivatives(distance.data() + s * page, across, cellWidth[s], cellHeight[s], squared);
    maxOfSix(squared, across, across, across, 1, wide);
    maxOfSix(wide, across, across, 1, across, squared);
    for (std::size_t k = 0; k < page; ++k) {
      std::uint8_t level = 0;
      while (level + 1u < levels && squared[k] <= bounds[level + 1]) ++level;
      inSection[s * page + k] = level;
    }
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

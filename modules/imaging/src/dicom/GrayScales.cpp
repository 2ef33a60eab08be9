// SPDX-License-Identifier: BSD-3-Clause
#include "GrayScales.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "../statements/Warnings.h"

namespace perilymph::imaging {
namespace {

using Scale = std::pair<double, double>;  // slope and intercept

/// Changes of gray values below this are rounding [HU].
constexpr double rounding_HU = 1.0;
/// A change is seen where it is this part of the difference between neighbors.
constexpr double seenFraction = 0.5;

std::string digitsOfScale(double value)
{
  std::array<char, 40> text{};
  const auto done =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 10);
  return {text.data(), done.ptr};
}

std::string scaleText(const Scale& scale)
{
  return "slope " + digitsOfScale(scale.first) + " and intercept " + digitsOfScale(scale.second);
}

/// How a slice joins its neighbor with its own scale, and with its neighbor's.
struct Join {
  double own = 0.0, other = 0.0;       ///< Mean difference to the neighbor [HU].
  double change = 0.0, maximum = 0.0;  ///< What the other scale changes: mean and maximum [HU].
};

Join joinOf(std::span<const std::int16_t> slice, std::span<const std::int16_t> neighbor,
            const Scale& own, const Scale& other)
{
  Join join;
  const double ratio = other.first / own.first;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < slice.size(); ++i) {
    if (slice[i] == ct::unmeasured || neighbor[i] == ct::unmeasured) continue;
    ++measured;
    const double value = slice[i];
    const double scaled = ratio * (value - own.second) + other.second;
    const double change = std::fabs(scaled - value);
    join.own += std::fabs(value - neighbor[i]);
    join.other += std::fabs(scaled - neighbor[i]);
    join.change += change;
    join.maximum = std::max(join.maximum, change);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(measured, 1));
  join.own /= count;
  join.other /= count;
  join.change /= count;
  return join;
}

bool contradicts(const Join& join, bool isOneScaleUsual)
{
  if (join.maximum < rounding_HU || join.own < join.other) return false;
  return isOneScaleUsual || join.change > seenFraction * join.other;
}

}  // namespace

Result<std::vector<Sentence>> checkScales(const DicomSeries& series, const Grid& grid)
{
  const auto& places = series.stack->places;
  const auto frameAt = [&](std::size_t k) -> const DicomFrame& {
    const SliceSource& slice = series.slices[places[k].front()];
    return series.headers[slice.header].frames[slice.frame];
  };
  const auto scaleAt = [&](std::size_t k) { return Scale(frameAt(k).slope, frameAt(k).intercept); };
  std::map<Scale, std::size_t> uses;
  for (std::size_t k = 0; k < places.size(); ++k) ++uses[scaleAt(k)];
  if (uses.size() < 2) return std::vector<Sentence>{};
  const auto usual = std::max_element(
      uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const bool isOneScaleUsual = 2 * usual->second > places.size();
  const std::size_t perSlice =
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  const auto voxelsAt = [&](std::size_t k) {
    return std::span<const std::int16_t>(grid.voxels).subspan(k * perSlice, perSlice);
  };
  std::size_t rarest = 0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (scaleAt(k) == scaleAt(k + 1)) continue;
    // of two neighbors, the one with the less usual scale is asked
    const bool isFirstUsual = uses[scaleAt(k)] >= uses[scaleAt(k + 1)];
    const std::size_t odd = isFirstUsual ? k + 1 : k, other = isFirstUsual ? k : k + 1;
    rarest = odd;
    const Join join = joinOf(voxelsAt(odd), voxelsAt(other), scaleAt(odd), scaleAt(other));
    if (!contradicts(join, isOneScaleUsual)) continue;
    const SliceSource& slice = series.slices[places[odd].front()];
    return Error{
        "The gray values of slice %1 of %2 (%3) do not join those of the next one: its file states "
        "%4, the next one %5. Export the series again as original images.",
        odd + 1,
        places.size(),
        nameOf(series.headers[slice.header]),
        scaleText(scaleAt(odd)),
        scaleText(scaleAt(other))};
  }
  const SliceSource& slice = series.slices[places[rarest].front()];
  const Scale odd = scaleAt(rarest);
  return std::vector<Sentence>{Sentence(
      warnings::scales,
      {digitsOfScale(odd.first), digitsOfScale(odd.second), nameOf(series.headers[slice.header]),
       digitsOfScale(usual->first.first), digitsOfScale(usual->first.second)})};
}

}  // namespace perilymph::imaging

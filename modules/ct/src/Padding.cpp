// SPDX-License-Identifier: BSD-3-Clause
#include "Padding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace perilymph::ct {
namespace {

constexpr double searched_mm = 20.0;
constexpr std::size_t fewestVoxels = 64;
/// Darker than bone: as far from the darkest to the brightest voxels.
constexpr double darkFraction = 0.55;
/// An end is abrupt if the median of the steps to the voxels behind it is as large [contrast].
constexpr double abruptFraction = 0.1;
/// Clipped air has the lowest intensity, too, but behind its edge the intensity goes on rising: at
/// the end of padding the first step is so many times the second one.
constexpr double firstToSecond = 2.0;

double medianStep(std::vector<int>& values)
{
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A box of voxels, by the first and the last one along every axis.
struct VoxelBox {
  std::array<int, 3> first{}, last{};
};

VoxelBox boxAround(const CtVolume& volume, const std::optional<Eigen::Vector3d>& center_P)
{
  VoxelBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) box.last[axis] = volume.size()[axis] - 1;
  if (!center_P) return box;
  const Eigen::Vector3d center = volume.toIndex(*center_P), spacing = volume.spacing_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const int middle = static_cast<int>(std::lround(center[a]));
    const int reach = static_cast<int>(std::ceil(searched_mm / spacing[a]));
    box.first[axis] = std::clamp(middle - reach, 0, box.last[axis]);
    box.last[axis] = std::clamp(middle + reach, 0, box.last[axis]);
  }
  return box;
}

/// Searches a box for regions of one intensity, and marks them in a copy of its volume.
class PaddingSearch {
public:
  PaddingSearch(const CtVolume& volume, const VoxelBox& box)
      : voxels_(volume.voxels().begin(), volume.voxels().end()),
        box_(box),
        strides_{1, static_cast<std::size_t>(volume.size()[0]),
                 static_cast<std::size_t>(volume.size()[0]) *
                     static_cast<std::size_t>(volume.size()[1])},
        isVisited_(voxels_.size()),
        brightest_(quantile(volume, 0.99)),
        contrast_(brightest_ - quantile(volume, 0.02)),
        lowest_(quantile(volume, 0.0))
  {
  }

  /// Whether a face of the box has four neighbors of one intensity that padding may have.
  bool isPossible() const
  {
    bool isAny = false;
    eachOnBorder([&](const Place& place, std::size_t axis) {
      if (isAny || !isDark(at(place))) return;
      const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
      if (place[b] == box_.last[b] || place[c] == box_.last[c]) return;
      const std::size_t here = indexOf(place);
      isAny = voxels_[here] == voxels_[here + strides_[b]] &&
              voxels_[here] == voxels_[here + strides_[c]] &&
              voxels_[here] == voxels_[here + strides_[b] + strides_[c]];
    });
    return isAny;
  }

  /// True if padding was marked.
  bool mark()
  {
    std::vector<std::size_t> padding;
    eachOnBorder([&](const Place& place, std::size_t) {
      if (!isVisited_[indexOf(place)] && isDark(at(place))) grow(place, padding);
    });
    for (const std::size_t each : padding) voxels_[each] = unmeasured;
    return !padding.empty();
  }

  std::vector<std::int16_t> takeVoxels() { return std::move(voxels_); }

private:
  using Place = std::array<int, 3>;

  std::size_t indexOf(const Place& place) const
  {
    return static_cast<std::size_t>(place[0]) + strides_[1] * static_cast<std::size_t>(place[1]) +
           strides_[2] * static_cast<std::size_t>(place[2]);
  }
  std::int16_t at(const Place& place) const { return voxels_[indexOf(place)]; }
  bool isDark(std::int16_t value) const
  {
    return value != unmeasured && value < brightest_ - (1.0 - darkFraction) * contrast_;
  }

  template <class Function>
  void eachOnBorder(Function&& function) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {box_.first[axis], box_.last[axis]}) {
        const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
        Place place{};
        place[axis] = side;
        for (place[c] = box_.first[c]; place[c] <= box_.last[c]; ++place[c])
          for (place[b] = box_.first[b]; place[b] <= box_.last[b]; ++place[b])
            function(place, axis);
      }
  }

  /// The connected region of one intensity; it and its surface are added if it is padding.
  void grow(const Place& start, std::vector<std::size_t>& padding)
  {
    const std::int16_t value = at(start);
    std::vector<Place> open{start};
    std::vector<std::size_t> region, surface;
    std::vector<int> steps, secondSteps;
    isVisited_[indexOf(start)] = true;
    while (!open.empty()) {
      const Place place = open.back();
      open.pop_back();
      region.push_back(indexOf(place));
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int by : {-1, 1}) {
          Place next = place;
          next[axis] += by;
          if (next[axis] < box_.first[axis] || next[axis] > box_.last[axis]) continue;
          const std::size_t index = indexOf(next);
          if (voxels_[index] == value) {
            if (!isVisited_[index]) open.push_back(next);
            isVisited_[index] = true;
          } else if (voxels_[index] != unmeasured) {
            surface.push_back(index);
            steps.push_back(std::abs(voxels_[index] - value));
            next[axis] += by;
            if (next[axis] >= box_.first[axis] && next[axis] <= box_.last[axis])
              secondSteps.push_back(std::abs(at(next) - voxels_[index]));
          }
        }
    }
    if (region.size() < fewestVoxels || steps.empty()) return;
    const double step = medianStep(steps);
    if (step < abruptFraction * contrast_) return;
    if (value == lowest_ && step < firstToSecond * medianStep(secondSteps)) return;
    padding.insert(padding.end(), region.begin(), region.end());
    padding.insert(padding.end(), surface.begin(), surface.end());
  }

  std::vector<std::int16_t> voxels_;
  VoxelBox box_;
  std::array<std::size_t, 3> strides_;
  std::vector<bool> isVisited_;
  double brightest_, contrast_, lowest_;
};

}  // namespace

std::optional<CtVolume> withPaddingMarked(const CtVolume& volume,
                                          const std::optional<Eigen::Vector3d>& center_P)
{
  PaddingSearch search(volume, boxAround(volume, center_P));
  if (!search.isPossible() || !search.mark()) return std::nullopt;
  auto marked = CtVolume::make(volume.size(), volume.lpsFromIndex(), search.takeVoxels(),
                               volume.provenance());
  if (!marked) return std::nullopt;
  return *std::move(marked);
}

double quantile(const CtVolume& volume, double fraction)
{
  std::vector<std::uint32_t> histogram(65536);
  std::uint64_t total = 0;
  for (const std::int16_t value : volume.voxels())
    if (value != unmeasured) {
      ++histogram[static_cast<std::size_t>(value + 32768)];
      ++total;
    }
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    below += histogram[i];
    if (below > 0 && static_cast<double>(below) >= fraction * static_cast<double>(total))
      return static_cast<double>(i) - 32768.0;
  }
  return 32767.0;
}

}  // namespace perilymph::ct

// SPDX-License-Identifier: BSD-3-Clause
#include "Region.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace perilymph::ct {
namespace {

constexpr std::size_t bins = 256;

/// Otsu's threshold: the bin that splits a histogram into two classes of minimum variance.
std::size_t otsu(const std::array<double, bins>& histogram)
{
  double total = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < bins; ++i) {
    total += histogram[i];
    sum += histogram[i] * static_cast<double>(i);
  }
  double below = 0.0, sumBelow = 0.0, best = -1.0;
  std::size_t threshold = bins / 2;
  for (std::size_t i = 0; i + 1 < bins; ++i) {
    below += histogram[i];
    sumBelow += histogram[i] * static_cast<double>(i);
    if (below <= 0.0 || total - below <= 0.0) continue;
    const double apart = sumBelow / below - (sum - sumBelow) / (total - below);
    const double between = below * (total - below) * apart * apart;
    if (between > best) {
      best = between;
      threshold = i;
    }
  }
  return threshold;
}

/// Intensities above this belong to metal, which would stretch the histogram: half as far above the
/// bright voxels as these are above the dark ones. Bone, clipped or not, stays below.
float brightest(std::vector<float> values)
{
  const auto at = [&](std::size_t percent) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * percent / 100);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const float dark = at(2), bright = at(98);
  return bright + 0.5F * (bright - dark);
}

}  // namespace

Region::Region(const CtVolume& volume, const Eigen::Vector3d& center_P, double radius_mm)
    : count_(2 * static_cast<int>(std::ceil(radius_mm / step)) + 1)
{
  corner_P_ = center_P - Eigen::Vector3d::Constant(0.5 * step * (count_ - 1));
  const auto n = static_cast<std::size_t>(count_);
  values_.resize(n * n * n);
  known_.resize(n * n * n);
  for (int k = 0; k < count_; ++k)
    for (int j = 0; j < count_; ++j)
      for (int i = 0; i < count_; ++i)
        if (const auto value = volume.sample(point_P(i, j, k))) {
          values_[index(i, j, k)] = static_cast<float>(*value);
          known_[index(i, j, k)] = 1;
        }
  // One pass of (1 2 1)/4 along every axis, to reduce noise.
  for (const std::size_t stride : {std::size_t{1}, n, n * n}) {
    std::vector<float> smooth = values_;
    for (std::size_t at = stride; at + stride < values_.size(); ++at)
      if (known_[at - stride] != 0 && known_[at] != 0 && known_[at + stride] != 0)
        smooth[at] = 0.25F * (values_[at - stride] + values_[at + stride]) + 0.5F * values_[at];
    values_.swap(smooth);
  }
}

Levels findLevels(const Region& region, const Eigen::Vector3d& center_P, double radius_mm)
{
  std::vector<float> all;
  std::vector<float> homogeneous;
  const int n = region.count();
  float low = 1e9F, high = -1e9F;
  std::vector<std::pair<float, float>> valueAndRange;
  for (int k = 1; k + 1 < n; ++k)
    for (int j = 1; j + 1 < n; ++j)
      for (int i = 1; i + 1 < n; ++i) {
        const std::size_t at = region.index(i, j, k);
        if (!region.isKnown(at) || (region.point_P(i, j, k) - center_P).norm() > radius_mm)
          continue;
        const float value = region.value(at);
        float minimum = value, maximum = value;
        for (const std::size_t other :
             {region.index(i - 1, j, k), region.index(i + 1, j, k), region.index(i, j - 1, k),
              region.index(i, j + 1, k), region.index(i, j, k - 1), region.index(i, j, k + 1)}) {
          minimum = std::min(minimum, region.value(other));
          maximum = std::max(maximum, region.value(other));
        }
        low = std::min(low, value);
        high = std::max(high, value);
        all.push_back(value);
        valueAndRange.emplace_back(value, maximum - minimum);
      }
  Levels levels;
  if (all.size() < 100 || high <= low) return levels;
  high = std::min(high, brightest(all));
  for (float& value : all) value = std::min(value, high);
  const double binWidth = (static_cast<double>(high) - low) / (bins - 1);
  const auto bin = [&](float value) {
    return static_cast<std::size_t>((static_cast<double>(value) - low) / binWidth);
  };
  std::array<double, bins> histogram{};
  for (const float value : all) histogram[bin(value)] += 1.0;
  const double threshold = low + binWidth * (static_cast<double>(otsu(histogram)) + 0.5);
  std::vector<float> bone;
  for (const float value : all)
    if (value > threshold) bone.push_back(value);
  std::nth_element(bone.begin(), bone.begin() + static_cast<std::ptrdiff_t>(bone.size() * 6 / 10),
                   bone.end());
  levels.bone = static_cast<double>(bone[bone.size() * 6 / 10]);

  // Peaks among homogeneous points below the threshold.
  const double contrast = levels.bone - low;
  std::array<double, bins> quiet{};
  double counted = 0.0;
  for (const auto& [value, range] : valueAndRange)
    if (value < threshold && range < 0.22 * contrast) {
      quiet[bin(value)] += 1.0;
      counted += 1.0;
    }
  std::array<double, bins> smooth{};
  constexpr int halfWidth = 8;
  for (int i = 0; i < static_cast<int>(bins); ++i)
    for (int d = -halfWidth; d <= halfWidth; ++d)
      if (i + d >= 0 && i + d < static_cast<int>(bins))
        smooth[static_cast<std::size_t>(i)] +=
            (halfWidth + 1 - std::abs(d)) * quiet[static_cast<std::size_t>(i + d)];
  std::vector<std::size_t> peaks;
  for (std::size_t i = 0; i < bins; ++i) {
    const std::size_t from = i > 12 ? i - 12 : 0, to = std::min(bins - 1, i + 12);
    const double maximum = *std::max_element(smooth.begin() + static_cast<std::ptrdiff_t>(from),
                                             smooth.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    if (smooth[i] >= maximum && smooth[i] > 0.15 * counted) peaks.push_back(i);
  }
  std::sort(peaks.begin(), peaks.end(),
            [&](std::size_t a, std::size_t b) { return smooth[a] > smooth[b]; });
  for (const std::size_t peak : peaks) {
    const double level = low + binWidth * (static_cast<double>(peak) + 0.5);
    const bool isNew =
        std::none_of(levels.candidates.begin(), levels.candidates.end(),
                     [&](double other) { return std::fabs(other - level) < 0.15 * contrast; });
    if (isNew && levels.candidates.size() < 2) levels.candidates.push_back(level);
  }
  return levels;
}

}  // namespace perilymph::ct

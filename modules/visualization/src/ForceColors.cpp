// SPDX-License-Identifier: BSD-3-Clause
#include "ForceColors.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace perilymph::visualization {
namespace {

constexpr int steps = 256;

/// Linear value of one sRGB channel, IEC 61966-2-1.
double linearLight(unsigned char channel)
{
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

unsigned char channelOf(double light)
{
  light = std::clamp(light, 0.0, 1.0);
  const double value =
      light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * value));
}

// Oklab (B. Ottosson, 2020): perceptually uniform.
Eigen::Matrix3d toCones()
{
  return (Eigen::Matrix3d() << 0.4122214708, 0.5363325363, 0.0514459929,  //
          0.2119034982, 0.6806995451, 0.1073969566,                       //
          0.0883024619, 0.2817188376, 0.6299787005)
      .finished();
}

Eigen::Matrix3d toLab()
{
  return (Eigen::Matrix3d() << 0.2104542553, 0.7936177850, -0.0040720468,  //
          1.9779984951, -2.4285922050, 0.4505937099,                       //
          0.0259040371, 0.7827717662, -0.8086757660)
      .finished();
}

Eigen::Vector3d okLab(const Rgba& color)
{
  const Eigen::Vector3d light(linearLight(color[0]), linearLight(color[1]), linearLight(color[2]));
  return toLab() * (toCones() * light).unaryExpr([](double x) { return std::cbrt(x); });
}

Rgba fromOkLab(const Eigen::Vector3d& lab)
{
  const Eigen::Vector3d root = toLab().inverse() * lab;
  const Eigen::Vector3d light =
      toCones().inverse() * root.unaryExpr([](double x) { return x * x * x; });
  return {channelOf(light.x()), channelOf(light.y()), channelOf(light.z()), 255};
}

std::array<Rgba, steps> makeTable(figures::ColorScheme scheme)
{
  std::array<Rgba, steps> table;
  const SceneColors& palette = sceneColorsOf(scheme);
  const Eigen::Vector3d low = okLab(palette.forceLow), high = okLab(palette.forceHigh);
  for (int i = 0; i < steps; ++i) {
    const double fraction = static_cast<double>(i) / (steps - 1);
    // transparent to the low color over the first fifth, then to the high one
    const double toHigh = std::clamp((fraction - 0.2) / 0.8, 0.0, 1.0);
    const double opacity = 0.92 * std::min(1.0, fraction / 0.2);
    table[static_cast<std::size_t>(i)] =
        withOpacity(fromOkLab(low + toHigh * (high - low)), opacity);
  }
  return table;
}

}  // namespace

Rgba forceColor(double force_mN_mm, figures::ColorScheme scheme)
{
  static const std::array<Rgba, steps> dark = makeTable(figures::ColorScheme::dark);
  static const std::array<Rgba, steps> light = makeTable(figures::ColorScheme::light);
  const std::array<Rgba, steps>& table = scheme == figures::ColorScheme::light ? light : dark;
  const double fraction = std::clamp(force_mN_mm / maxWallForce_mN_mm, 0.0, 1.0);
  return table[static_cast<std::size_t>(std::lround(fraction * (steps - 1)))];
}

}  // namespace perilymph::visualization

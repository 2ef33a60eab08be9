// SPDX-License-Identifier: BSD-3-Clause

// The check of Todd and Naghdy, section II.B: the published spiral compared with two others, a
// helico-spiral (Yoo et al. 2000) and an Archimedean spiral (Ketten et al. 1998).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::anatomy {
namespace {

/// Distance from the axis and height of a path over the angle [mm].
struct Path {
  std::function<double(double)> radius, height;
};

double length(const Path& path, double from_deg, double to_deg)
{
  constexpr int pieces = 4000;
  const auto place = [&](int i) {
    const double angle = degrees(from_deg + (to_deg - from_deg) * i / pieces).si();
    return Eigen::Vector3d(path.radius(angle) * std::cos(angle),
                           path.radius(angle) * std::sin(angle), path.height(angle));
  };
  double sum = 0.0;
  for (int i = 1; i <= pieces; ++i) sum += (place(i) - place(i - 1)).norm();
  return sum;
}

struct Samples {
  std::vector<double> angle, value;
};

/// a e^(b t) by least squares: the best a for every b; the best b by interval search.
std::function<double(double)> exponentialFit(const Samples& samples)
{
  double bestA = 0.0, bestB = 0.0, minimum = 1e300;
  double middle = 0.0, span = 2.0;
  for (int level = 0; level < 30; ++level, span *= 0.5) {
    const double center = middle;
    for (int k = -20; k <= 20; ++k) {
      const double b = center + span * k / 20.0;
      double up = 0.0, down = 0.0;
      for (std::size_t i = 0; i < samples.angle.size(); ++i) {
        const double e = std::exp(b * samples.angle[i]);
        up += e * samples.value[i];
        down += e * e;
      }
      double squares = 0.0;
      for (std::size_t i = 0; i < samples.angle.size(); ++i) {
        const double off = up / down * std::exp(b * samples.angle[i]) - samples.value[i];
        squares += off * off;
      }
      if (squares >= minimum) continue;
      minimum = squares;
      bestA = up / down;
      bestB = middle = b;
    }
  }
  return [=](double t) { return bestA * std::exp(bestB * t); };
}

/// a + b t by least squares.
std::function<double(double)> lineFit(const Samples& samples)
{
  const auto n = static_cast<double>(samples.angle.size());
  double t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
  for (std::size_t i = 0; i < samples.angle.size(); ++i) {
    t += samples.angle[i];
    y += samples.value[i];
    tt += samples.angle[i] * samples.angle[i];
    ty += samples.angle[i] * samples.value[i];
  }
  const double b = (n * ty - t * y) / (n * tt - t * t);
  const double a = (y - b * t) / n;
  return [=](double angle) { return a + b * angle; };
}

TEST(PublishedSpiral, IsAsLongAsHelicoSpiralAndArchimedeanSpiralSay)
{
  const auto scala = buildPublished({}, millimeters(0));
  const SectionTables& tables = scala->tables();
  Samples radii, heights;
  for (std::size_t i = 0; i < tables.planRadius.size(); ++i) {
    const double angle = tables.step * static_cast<double>(i);
    radii.angle.push_back(angle);
    radii.value.push_back(1e3 * tables.planRadius[i]);
    heights.angle.push_back(angle);
    heights.value.push_back(1e3 * tables.centerHeight[i]);
  }
  const auto between = [&](const Samples& samples) {
    return [&samples, step = tables.step](double angle) {
      const std::size_t i =
          std::min(static_cast<std::size_t>(angle / step), samples.value.size() - 2);
      const double fraction = angle / step - static_cast<double>(i);
      return samples.value[i] + fraction * (samples.value[i + 1] - samples.value[i]);
    };
  };
  const Path published{between(radii), between(heights)};
  const Path helico{exponentialFit(radii), exponentialFit(heights)};
  const Path archimedean{lineFit(radii), lineFit(heights)};

  const double end_deg = inDegrees(scala->lastAngle());
  std::printf("| length [mm] | published | helico-spiral | Archimedean |\n");
  for (const double to_deg : {180.0, 360.0, 720.0, end_deg})
    std::printf("| to %.0f | %.2f | %.2f | %.2f |\n", to_deg, length(published, 0, to_deg),
                length(helico, 0, to_deg), length(archimedean, 0, to_deg));
  const double whole = length(published, 0.0, end_deg);
  EXPECT_NEAR(length(helico, 0.0, end_deg), whole, 0.03 * whole);
  EXPECT_NEAR(length(archimedean, 0.0, end_deg), whole, 0.05 * whole);
}

}  // namespace
}  // namespace perilymph::anatomy

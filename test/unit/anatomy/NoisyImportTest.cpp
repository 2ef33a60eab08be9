// SPDX-License-Identifier: BSD-3-Clause

// Surfaces with noise, as after segmentation or rounding of coordinates.

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>

#include "perilymph/anatomy/ImportedScala.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::anatomy {
namespace {

/// The published scala with a lead-in of 1 mm, and the measured mean one.
std::vector<Surface> surfaces()
{
  const auto published = buildPublished(Patient{}, millimeters(1));
  const auto mean = buildMean(millimeters(1));
  EXPECT_TRUE(mean);
  return {wallSurface(*published, 20'000), wallSurface(**mean, 20'000)};
}

/// A copy whose corners are displaced by normally distributed noise along each axis [m].
Surface noisy(Surface surface, double deviation, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, deviation);
  for (auto& point : surface.points)
    for (double& coordinate : point) coordinate += noise(random);
  return surface;
}

#ifdef IMPORT_ALL_NOISES  // 0.4 s an import: a stage of test/run --long
constexpr auto noises_um = {0.1, 1.0, 10.0};
constexpr auto seeds = {1u, 2u, 3u};
#else
constexpr auto noises_um = {10.0};
constexpr auto seeds = {1u, 2u};
#endif

TEST(AnImportWithNoiseOnItsCorners, KeepsItsMeasures)
{
  for (const Surface& surface : surfaces()) {
    const auto exact = importScala(surface);
    ASSERT_TRUE(exact) << exact.error().message;
    for (const double noise_um : noises_um)
      for (const unsigned seed : seeds) {
        const auto read = importScala(noisy(surface, 1e-6 * noise_um, seed));
        ASSERT_TRUE(read) << read.error().message;
        const std::string place = std::to_string(noise_um) + " um, seed " + std::to_string(seed) +
                                  ", lead-in " + std::to_string(inMillimeters(read->leadIn)) +
                                  " mm for " + std::to_string(inMillimeters(exact->leadIn));
        EXPECT_NEAR(inMillimeters(read->a), inMillimeters(exact->a), 0.05) << place;
        // an error of 0.3 mm in the duct length from A alone (Alexiades: 4.16 A)
        EXPECT_NEAR(4.16 * inMillimeters(read->a), 4.16 * inMillimeters(exact->a), 0.3) << place;
      }
  }
}

}  // namespace
}  // namespace perilymph::anatomy

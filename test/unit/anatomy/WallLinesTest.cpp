// SPDX-License-Identifier: BSD-3-Clause

// The distance that fills the lumen's table: the same bits with every instruction set, and to a round
// duct that of a torus.

#include "lumen/WallLines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/foundation/Four.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

/// Increasing places on both sides of a section, far beyond its walls, at uneven steps.
std::vector<double> unevenPlaces(std::size_t count, std::mt19937& random)
{
  std::uniform_real_distribution<double> places(-1.8e-3, 1.8e-3);
  std::vector<double> all(count);
  for (double& each : all) each = places(random);
  std::sort(all.begin(), all.end());
  return all;
}

// Grids of all sizes, fine and coarse, so that no block of the search is special.
TEST(WallLinesOfASection, GiveAGridTheBitsOfEveryPointByItself)
{
  std::mt19937 random(12);
  const std::shared_ptr<const ScalaTympani> mean = *buildMean(millimeters(1));
  const std::shared_ptr<const ScalaTympani> ducts[] = {buildPublished({}, millimeters(1)), mean,
                                                       vestibuliOf(*mean), bothScalaeOf(*mean)};
  for (const auto& duct : ducts)
    for (const double angle_deg : {0.0, 10.0, 95.0, 400.0, 660.0, 720.0, 880.0}) {
      const double angle = std::min(degrees(angle_deg).si(), duct->lastAngle().si());
      const WallLines lines(*duct, angle);
      for (const std::size_t count : {std::size_t{1}, std::size_t{5}, std::size_t{46}}) {
        const std::vector<double> u = unevenPlaces(count, random),
                                  v = unevenPlaces(count + 2, random);
        std::vector<double> found(u.size() * v.size());
        lines.distances(u, v, found.data());
        for (std::size_t i = 0; i < u.size(); ++i)
          for (std::size_t j = 0; j < v.size(); ++j)
            ASSERT_EQ(found[i * v.size() + j], lines.distance(u[i], v[j]))
                << angle_deg << " " << u[i] << " " << v[j];
      }
    }
}

TEST(WallLinesOfASection, HaveTheSameBitsWithEveryInstructionSet)
{
  const auto scala = buildPublished({}, millimeters(1));
  std::mt19937 random(11);
  const std::vector<double> u = unevenPlaces(46, random), v = unevenPlaces(46, random);
  for (const double angle_deg : {0.0, 95.0, 400.0, 720.0}) {
    const WallLines lines(*scala, degrees(angle_deg).si());
    std::vector<double> expected(u.size() * v.size()), found(expected.size());
    kernelInstructions = Instructions::everywhere;
    lines.distances(u, v, expected.data());
    kernelInstructions = machineInstructions();
    lines.distances(u, v, found.data());
    ASSERT_EQ(found, expected) << angle_deg;
  }
}

/// A round duct of 1 mm around a circle of 4 mm: a torus.
ScalaTympani torus()
{
  SectionTables tables;
  tables.name = "torus";
  tables.step = degrees(5).si();
  tables.directions = 32;
  for (int i = 0; i <= 60; ++i) {
    tables.centerRadius.push_back(4e-3);
    tables.centerHeight.push_back(0.0);
    tables.wallRadius.insert(tables.wallRadius.end(), 32, 0.5e-3);
    tables.membraneInner.push_back(-0.1e-3);
    tables.membraneOuter.push_back(0.1e-3);
    tables.membraneHeight.push_back(0.45e-3);
    tables.planRadius.push_back(4e-3);
  }
  return ScalaTympani(tables);
}

// From every direction, so that every point of the outline is the nearest or a neighbor of it once.
TEST(WallLinesOfASection, GiveTheDistanceToATorus)
{
  const ScalaTympani scala = torus();
  const WallLines lines(scala, degrees(150).si());
  for (int k = 0; k < 360; ++k) {
    const double direction = degrees(k).si();
    for (const double off : {0.1e-3, 0.3e-3, 0.45e-3, 0.55e-3, 0.8e-3})
      EXPECT_NEAR(lines.distance(off * std::cos(direction), off * std::sin(direction)),
                  std::fabs(0.5e-3 - off), test::tolerance(2e-6, "parabola through three points"))
          << k << " " << off;
  }
}

}  // namespace
}  // namespace perilymph::anatomy

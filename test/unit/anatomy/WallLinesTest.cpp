// SPDX-License-Identifier: BSD-3-Clause

// The distance that fills the lumen's table: the same bits with every instruction set, and to a round
// duct that of a torus.

#include "lumen/WallLines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Four.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

TEST(WallLinesOfASection, HaveTheSameBitsWithEveryInstructionSet)
{
  const auto scala = buildPublished({}, millimeters(1));
  const Instructions machine = machineInstructions();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> places(-1.5e-3, 1.5e-3);
  for (const double angle_deg : {0.0, 95.0, 400.0, 720.0}) {
    const WallLines lines(*scala, degrees(angle_deg).si());
    for (int i = 0; i < 500; ++i) {
      const double u = places(random), v = places(random);
      kernelInstructions = Instructions::sse2;
      const double expected = lines.distance(u, v);
      kernelInstructions = machine;
      ASSERT_EQ(lines.distance(u, v), expected) << angle_deg << " " << u << " " << v;
    }
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

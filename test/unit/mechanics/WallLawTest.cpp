// SPDX-License-Identifier: BSD-3-Clause

// The compliant wall against its closed form (WallLaw in InsertionModel.h).

#include <gtest/gtest.h>

#include <cmath>

#include "contact/Contact.h"

namespace perilymph::mechanics {
namespace {

constexpr double k = 40'000.0, t = 60e-6;  // [N/m], [m]

TEST(WallLaw, IsAQuadraticLiningOverALinearWall)
{
  EXPECT_EQ(normalForce(0.0, k, t).force, 0.0);
  EXPECT_EQ(normalForce(-1e-6, k, t).force, 0.0);
  EXPECT_NEAR(normalForce(30e-6, k, t).force, k * 30e-6 * 30e-6 / (2.0 * t), 1e-12);
  EXPECT_NEAR(normalForce(t, k, t).force, 0.5 * k * t, 1e-12);
  EXPECT_NEAR(normalForce(100e-6, k, t).force, k * (100e-6 - 0.5 * t), 1e-12);
}

TEST(WallLaw, ForceAndStiffnessAreTheDerivativesOfItsEnergy)
{
  constexpr double step = 1e-8;  // [m]
  for (double p = 0.5e-6; p < 200e-6; p += 1.3e-6) {
    const double force = (energyOf(p + step, k, t) - energyOf(p - step, k, t)) / (2.0 * step);
    const double slope =
        (normalForce(p + step, k, t).force - normalForce(p - step, k, t).force) / (2.0 * step);
    EXPECT_NEAR(normalForce(p, k, t).force, force, 1e-6) << p;
    EXPECT_NEAR(normalForce(p, k, t).slope, slope, 2.0 * k * step / t) << p;
  }
}

TEST(WallLaw, ReturnsTheEnergyThatPressedIt)
{
  // work along a cycle in and out, by trapezoids
  double work = 0.0;
  constexpr int steps = 2000;
  const auto at = [](int i) { return 150e-6 * std::sin(3.14159265358979 * i / steps); };
  for (int i = 0; i < steps; ++i)
    work += 0.5 * (normalForce(at(i), k, t).force + normalForce(at(i + 1), k, t).force) *
            (at(i + 1) - at(i));
  EXPECT_NEAR(work, 0.0, 1e-6 * energyOf(150e-6, k, t));
}

TEST(BoneWall, IsTwoToSevenThousandNewtonsPerMeterAtTheForcesOfInsertions)
{
  const WallLaw bone = boneWall();
  const auto stiffnessAt = [&](double force) {
    const double p = std::sqrt(2.0 * force * bone.lining.si() / bone.perSamplePoint.si());
    return normalForce(p, bone.perSamplePoint.si(), bone.lining.si()).slope;
  };
  EXPECT_NEAR(stiffnessAt(0.008), 2000.0, 50.0);
  EXPECT_NEAR(stiffnessAt(0.1), 7'070.0, 50.0);
  // The rim and the membrane have no lining of their own.
  EXPECT_EQ(bone.bareOnset(), millimeters(0.01));
  EXPECT_EQ(bone.rimStiffness(), newtonsPerMeter(441));
  EXPECT_EQ(WallLaw{}.rimStiffness(), newtonsPerMeter(441));
}

}  // namespace
}  // namespace perilymph::mechanics

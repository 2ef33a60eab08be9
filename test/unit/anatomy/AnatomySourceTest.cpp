// SPDX-License-Identifier: BSD-3-Clause

// The table of anatomies: consistent with itself and with the shapes built from it.

#include "perilymph/anatomy/AnatomySource.h"

#include <gtest/gtest.h>

#include <set>

namespace perilymph::anatomy {
namespace {

Patient withBasalTurn()
{
  Patient patient;
  patient.basalTurn = {millimeters(8.9), millimeters(6.6), std::nullopt};
  return patient;
}

double outerDiameter(const ScalaTympani& scala)
{
  return scala.section(0.0).outerRadius + scala.section(degrees(180).si()).outerRadius;
}

TEST(AnatomySources, AreFoundByTheirNames)
{
  std::set<std::string> names;
  for (const AnatomySourceTraits& traits : anatomySources()) {
    EXPECT_EQ(anatomySourceNamed(traits.name), traits.source);
    EXPECT_STREQ(nameOf(traits.source), traits.name);
    EXPECT_STRNE(traits.title, "");
    names.insert(traits.name);
  }
  EXPECT_EQ(names.size(), anatomySources().size());
  EXPECT_FALSE(anatomySourceNamed("banana"));
  EXPECT_FALSE(anatomySourceNamed(""));
}

TEST(AnatomySources, BuildAScalaWithoutAPatient)
{
  for (const AnatomySourceTraits& traits : anatomySources()) {
    const auto scala = buildAnatomy({traits.source, {}, millimeters(2)}, "test");
    ASSERT_TRUE(scala) << scala.error().message;
    EXPECT_EQ((*scala)->leadIn(), millimeters(2)) << traits.name;
    // human cochleae have about two and a half turns, plus or minus a quarter
    EXPECT_NEAR(inDegrees((*scala)->lastAngle()), 900.0, 100.0) << traits.name;
  }
}

TEST(AnatomySources, AreScaledByTheMeasuresTheyTakeAndByNoOthers)
{
  // A scales the outer wall of the anatomies that take it
  for (const AnatomySourceTraits& traits : anatomySources()) {
    const bool isScaled = isScaledBy(traits.source, withBasalTurn());
    if (traits.takes != PatientMeasures::basalTurn) continue;
    EXPECT_TRUE(isScaled) << traits.name;
    const auto scala = buildAnatomy({traits.source, withBasalTurn()}, "test");
    ASSERT_TRUE(scala) << scala.error().message;
    EXPECT_NEAR(outerDiameter(**scala), 8.9e-3, 0.02e-3) << traits.name;
  }
  EXPECT_TRUE(isScaledBy(AnatomySource::published, {}));
  EXPECT_FALSE(isScaledBy(AnatomySource::mean, {}));
  EXPECT_FALSE(isScaledBy(AnatomySource::clark, withBasalTurn()));
}

TEST(AnatomySources, OfAPatientFollowFromTheMeasuresKnown)
{
  EXPECT_EQ(sourceScaledBy(measuresOf({})), AnatomySource::published);
  EXPECT_EQ(sourceScaledBy(measuresOf(withBasalTurn())), AnatomySource::mean);
}

TEST(AnatomySources, NameTheCochleaThatCannotBeBuilt)
{
  const auto scala = buildAnatomy({AnatomySource::published, {}, millimeters(-1)}, "somebody");
  ASSERT_FALSE(scala);
  EXPECT_EQ(scala.error().message.rfind("The cochlea of somebody cannot be built: ", 0), 0u);
}

}  // namespace
}  // namespace perilymph::anatomy

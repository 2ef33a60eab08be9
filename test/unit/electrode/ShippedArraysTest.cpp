// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/electrode/ArrayText.h"
#include "perilymph/foundation/Resources.h"

// Every shipped array against published data that its file does not contain.

namespace perilymph::electrode {
namespace {

struct Facts {
  double insertable_mm;
  std::size_t contacts;
  double fromFirstToLast_mm;  ///< Between the centers of the outermost contacts.
  double tip_mm, base_mm;     ///< Maximum diameters.
  bool isPrecurved;
};

/// Published lengths and counts; where the length over all contacts is published, one contact's
/// length is subtracted.
const std::map<std::string, Facts>& knownArrays()
{
  static const std::map<std::string, Facts> arrays = {
      {"contour", {22.0, 22, 15.0 - 0.3, 0.5, 0.8, true}},
      {"contour-advance", {19.0, 22, 15.0 - 0.3, 0.5, 0.8, true}},
      {"slim-straight", {25.0, 22, 19.1 - 0.3, 0.3, 0.6, false}},
      {"slim-modiolar", {18.0, 22, 14.0, 0.4, 0.5, true}},
      {"hybrid-l24", {16.0, 22, 14.5 - 0.3, 0.35, 0.55, false}},
      {"nucleus-straight", {25.0, 22, 21 * 0.75, 0.4, 0.6, false}},
      {"flex20", {20.0, 12, 15.4, 0.5, 0.8, false}},
      {"flex24", {24.0, 12, 20.9, 0.5, 0.8, false}},
      {"flex26", {26.0, 12, 20.9, 0.5, 0.8, false}},
      {"flex28", {28.0, 12, 23.1, 0.5, 0.8, false}},
      {"flexsoft", {31.5, 12, 26.4, 0.5, 1.3, false}},
      {"medel-standard", {31.5, 12, 26.4, 0.5, 1.3, false}},
      {"medel-medium", {24.0, 12, 20.9, 0.5, 0.8, false}},
      {"medel-compressed", {15.0, 12, 12.1, 0.5, 0.7, false}},
      {"hifocus-slimj", {23.0, 16, 15 * 1.3, 0.25, 0.7, false}},
      {"hifocus-mid-scala", {18.5, 16, 15.0, 0.5, 0.7, true}},
      {"evo", {25.0, 20, 19 * 1.2, 0.4, 0.5, false}},
  };
  return arrays;
}

ArrayDesign shipped(const std::string& name)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  if (!file) throw std::runtime_error(file.error().message);
  const Result<ArrayDesign> design = loadArray(*file);
  if (!design) throw std::runtime_error(design.error().message);
  return *design;
}

/// One case per file in the folder, so that new files are tested automatically.
class ShippedArray : public testing::TestWithParam<std::string> {
protected:
  const ArrayDesign array = shipped(GetParam());
};

TEST_P(ShippedArray, HasASourceForEveryTableAndSaysThatItIsNoDeviceLabeling)
{
  EXPECT_NE(array.note.find("not device labeling"), std::string::npos);
  EXPECT_GE(array.provenance.size(), 5u);
  for (const auto& [table, provenance] : array.provenance)
    EXPECT_GT(provenance.source.size(), 10u) << table;
}

TEST_P(ShippedArray, CarriesAllItsContactsIntoTheCochlea)
{
  EXPECT_LT(array.contactsFromTip.back() + 0.5 * array.contactLength, array.insertable);
}

TEST_P(ShippedArray, NeverGetsThinnerOrSofterTowardItsBase)
{
  for (double place_mm = 0.25; place_mm <= inMillimeters(array.length); place_mm += 0.25) {
    const Length here = millimeters(place_mm), before = millimeters(place_mm - 0.25);
    EXPECT_GE(array.sectionAt(here).across, array.sectionAt(before).across) << place_mm;
    EXPECT_GE(array.sectionAt(here).within, array.sectionAt(before).within) << place_mm;
    EXPECT_GE(array.bending.at(here), array.bending.at(before)) << place_mm;
  }
}

TEST_P(ShippedArray, StatesARangeOfItsTaperWhereItsBaseFillsTheScala)
{
  // 1.25 mm: the largest circle in the mean scala tympani behind the opening, at 45 degrees
  ASSERT_EQ(array.taper.has_value(), array.diameter.at(array.length) > millimeters(1.25));
  if (!array.taper) return;
  for (const double fraction : {0.0, 0.5, 1.0}) {
    const ArrayDesign drawn = withTaper(array, fraction);
    EXPECT_EQ(drawn.diameter.at(millimeters(0)), array.diameter.at(millimeters(0)));
    EXPECT_EQ(drawn.diameter.at(array.length), array.diameter.at(array.length));
    for (double place_mm = 0.25; place_mm <= inMillimeters(array.length); place_mm += 0.25) {
      const Length here = millimeters(place_mm), before = millimeters(place_mm - 0.25);
      EXPECT_GE(drawn.sectionAt(here).across, drawn.sectionAt(before).across) << place_mm;
      EXPECT_GE(drawn.sectionAt(here).within, drawn.sectionAt(before).within) << place_mm;
      EXPECT_GE(drawn.bending.at(here), drawn.bending.at(before)) << place_mm;
      EXPECT_LE(drawn.bending.at(here), drawn.bendingAcrossAt(here)) << place_mm;
    }
  }
}

TEST_P(ShippedArray, BendsNoMoreEasilyAcrossItsPlaneOfCurlThanWithinIt)
{
  // The thinner side faces the modiolus, so the array bends more easily in the plane of the spiral.
  for (double place_mm = 0.0; place_mm <= inMillimeters(array.length); place_mm += 0.5) {
    const Length here = millimeters(place_mm);
    EXPECT_LE(array.sectionAt(here).within, array.sectionAt(here).across) << place_mm;
    EXPECT_LE(array.bending.at(here), array.bendingAcrossAt(here)) << place_mm;
  }
}

TEST_P(ShippedArray, IsNeitherSofterThanSiliconeNorStifferThanSolidPlatinumCore)
{
  // Bounds: plain silicone of 1 MPa, and all 25 um wires fused into one round platinum core,
  // doubled for the silicone and for loosely packed wires.
  for (double place_mm = 0.0; place_mm <= inMillimeters(array.length); place_mm += 0.5) {
    const Length here = millimeters(place_mm);
    const double d = array.sectionAt(here).within.si();
    const double bare = 1e6 * std::acos(-1.0) * d * d * d * d / 64.0;
    EXPECT_GT(array.bending.at(here).si(), bare) << place_mm;
    const double wires = static_cast<double>(array.contactsFromTip.size());
    const double core = 168e9 * std::acos(-1.0) * std::pow(25e-6, 4) / 64.0 * wires * wires;
    EXPECT_LT(array.bending.at(here).si(), 2.0 * core) << place_mm;
  }
}

TEST_P(ShippedArray, IsHeldStillBeforeItsStyletWouldPassTheBasalTurn)
{
  if (!array.hasStylet) return;
  ASSERT_TRUE(array.stylet.holdDepth);
  // The outer wall of the basal turn is 8 to 10 mm from the round window.
  EXPECT_GE(*array.stylet.holdDepth, millimeters(3.0));
  EXPECT_LE(*array.stylet.holdDepth, millimeters(10.0));
}

INSTANTIATE_TEST_SUITE_P(, ShippedArray, testing::ValuesIn(shippedNames("plugins/electrodes")),
                         [](const auto& about) {
                           std::string name = about.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// The arrays with published data.
class KnownArray : public testing::TestWithParam<std::string> {
protected:
  const ArrayDesign array = shipped(GetParam());
  const Facts facts = knownArrays().at(GetParam());
};

TEST_P(KnownArray, GoesInAsFarAsPublished)
{
  EXPECT_DOUBLE_EQ(inMillimeters(array.insertable), facts.insertable_mm);
}

TEST_P(KnownArray, HasItsContactsOverThePublishedLength)
{
  ASSERT_EQ(array.contactsFromTip.size(), facts.contacts);
  EXPECT_NEAR(inMillimeters(array.contactsFromTip.back() - array.contactsFromTip.front()),
              facts.fromFirstToLast_mm, 0.02);
}

TEST_P(KnownArray, IsAsThickAtTipAndBaseAsPublished)
{
  EXPECT_DOUBLE_EQ(inMillimeters(array.diameter.at(millimeters(0))), facts.tip_mm);
  EXPECT_DOUBLE_EQ(inMillimeters(array.diameter.at(array.length)), facts.base_mm);
}

TEST_P(KnownArray, CurlsOnlyIfItsKindDoes)
{
  double maximum = 0.0;
  for (const Curvature curvature : array.restCurvature.value)
    maximum = std::max(maximum, inPerMillimeter(curvature));
  EXPECT_EQ(maximum > 0.0, facts.isPrecurved);
  EXPECT_EQ(array.hasStylet, facts.isPrecurved);
}

INSTANTIATE_TEST_SUITE_P(, KnownArray, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& [name, facts] : knownArrays()) names.push_back(name);
                           return names;
                         }()),
                         [](const auto& about) {
                           std::string name = about.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ElectrodesOfTheMaker, CountFromTheBaseAtCochlearAndFromTheTipAtMedEl)
{
  // 22 is at the tip of an array of Cochlear's, and so is 1 at that of one of MED-EL's: as their fitting software says
  const ArrayDesign straight = shipped("slim-straight"), flex = shipped("flex28");
  EXPECT_EQ(straight.makerElectrode(1), 22);
  EXPECT_EQ(straight.makerElectrode(22), 1);
  EXPECT_EQ(flex.makerElectrode(1), 1);
  EXPECT_EQ(flex.makerElectrode(12), 12);
  EXPECT_EQ(shipped("evo").makerElectrode(1), std::nullopt);  // no source is known
}

TEST(ElectrodesOfTheMaker, AreWrittenAndReadAgain)
{
  for (const char* name : {"slim-straight", "flex28", "evo"}) {
    const auto read = parseArray(arrayText(shipped(name)), name);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->makerNumbering, shipped(name).makerNumbering) << name;
  }
}

TEST(StiffnessOfShippedArrays, FollowsSiliconeAndWiresWhereTheFileSaysSo)
{
  const double pi = std::acos(-1.0);
  const double oneWire = 168e9 * pi * std::pow(25e-6, 4) / 64.0;
  int seen = 0;
  for (const std::string& name : shippedNames("plugins/electrodes")) {
    const ArrayDesign array = shipped(name);
    const auto table = std::find_if(array.provenance.begin(), array.provenance.end(),
                                    [](const auto& entry) { return entry.first == "bending"; });
    const std::string& source = table->second.source;
    if (source.find("by the model of plugins/README.md") == std::string::npos) continue;
    ++seen;
    const double c = source.find("c = 0.06") != std::string::npos ? 0.06 : 1.2;
    EXPECT_EQ(c < 1.0, array.maker == "MED-EL") << name;
    // Basal to the last contact there are all wires; at the tip there is one.
    for (const auto& [place, wires] :
         {std::pair{array.insertable, static_cast<double>(array.contactsFromTip.size())},
          std::pair{array.contactsFromTip[0] - array.contactsFromTip[0], 1.0}}) {
      const double d = array.diameter.at(place).si();
      const double t = array.thickness.at(place).si();
      const double ofWires = oneWire * (wires + c * wires * wires);
      EXPECT_NEAR(array.bending.at(place).si(), 2e6 * pi * d * t * t * t / 64.0 + ofWires,
                  0.01 * array.bending.at(place).si())
          << name;
      EXPECT_NEAR(array.bendingAcrossAt(place).si(), 2e6 * pi * d * d * d * t / 64.0 + ofWires,
                  0.01 * array.bendingAcrossAt(place).si())
          << name;
    }
  }
  EXPECT_GE(seen, 14);
}

TEST(StiffnessOfShippedArrays, HasWavedWiresThatStretchByStraightening)
{
  // A wire y = a sin(q x) under the axial force T, held laterally by k y per length: its amplitude
  // changes by b such that the energy of bending and of its support, (E I q^4 + k) b^2 / 4 per
  // length, balances the work of T over the shortening q^2 a b / 2.
  const double pi = std::acos(-1.0);
  const double amplitude = 50e-6, q = 2.0 * pi / 1e-3, diameter = 25e-6, k = 2.0 * 2e6;
  const double bending = 168e9 * pi * std::pow(diameter, 4) / 64.0 * std::pow(q, 4) + k;
  const double perForce = q * q * amplitude / bending;                // b / T
  const double byStraightening = 0.5 * q * q * amplitude * perForce;  // strain / T
  const double byStretching = 1.0 / (168e9 * pi * diameter * diameter / 4.0);
  EXPECT_NEAR(1.2 * byStretching / (byStretching + byStraightening), 0.06, 0.005);
}

}  // namespace
}  // namespace perilymph::electrode

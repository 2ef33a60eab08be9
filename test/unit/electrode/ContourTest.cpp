// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"

// The shipped Nucleus 24 Contour against its published data.

namespace perilymph::electrode {
namespace {

class Contour : public testing::Test {
protected:
  void SetUp() override
  {
    const auto file = findByName("array", "plugins/electrodes", "contour");
    ASSERT_TRUE(file) << file.error().message;
    Result<ArrayDesign> design = loadArray(*file);
    ASSERT_TRUE(design) << design.error().message;
    array = std::move(*design);
  }

  ArrayDesign array;
};

TEST_F(Contour, HasTheMeasuredTipRadius)
{
  EXPECT_DOUBLE_EQ(inMillimeters(array.diameter.at(millimeters(0.0))), 2.0 * 0.25);
}

// Todd and Naghdy: the simulator goes on to 22 mm; the experiment ends after 16.5 mm of travel, from a
// start 1 to 3 mm inside, with the second rib at the opening.
TEST_F(Contour, TouchesTheOpeningWithItsSecondRibWhereTheExperimentEnds)
{
  ASSERT_EQ(array.ribsFromTip.size(), 2u);
  EXPECT_DOUBLE_EQ(inMillimeters(array.insertable), 22.0);
  // there the rib's flank touches a rim of radius 0.1 mm
  const double touches_mm = inMillimeters(array.ribsFromTip[1] - 0.5 * array.ribLength) - 0.1;
  EXPECT_GE(touches_mm, 16.5 + 1.0);
  EXPECT_LE(touches_mm, 16.5 + 3.0);
  EXPECT_LT(array.ribsFromTip[0], array.ribsFromTip[1]);
}

TEST_F(Contour, Has22ContactsOver15MillimetersWith400To800MicrometersPitch)
{
  const auto& contacts = array.contactsFromTip;
  ASSERT_EQ(contacts.size(), 22u);
  EXPECT_NEAR(inMillimeters(contacts.back() - contacts.front() + array.contactLength), 15.0, 0.01);
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    const double pitch_mm = inMillimeters(contacts[i] - contacts[i - 1]);
    EXPECT_GE(pitch_mm, 0.4 - 1e-9) << i;
    EXPECT_LE(pitch_mm, 0.8 + 1e-9) << i;
  }
}

TEST_F(Contour, HasTheStyletOfAPlatinumWireOf100To150Micrometers)
{
  const double modulus = 168e9;  // platinum [Pa]
  const auto bendingOfWire = [&](double diameter) {
    return modulus * std::acos(-1.0) * std::pow(diameter, 4) / 64.0;
  };
  ASSERT_TRUE(array.hasStylet);
  EXPECT_GT(array.stylet.bending.si(), bendingOfWire(0.10e-3));
  EXPECT_LT(array.stylet.bending.si(), bendingOfWire(0.15e-3));
}

TEST_F(Contour, StiffensFromTipToBaseWithinThePhysicalBounds)
{
  BendingStiffness before = newtonSquareMeters(0.2e-6);
  for (double place_mm = 0.0; place_mm <= 25.0; place_mm += 0.25) {
    const BendingStiffness here = array.bending.at(millimeters(place_mm));
    EXPECT_GE(here.si(), before.si()) << place_mm;
    before = here;
  }
  EXPECT_LE(before.si(), 3.0e-6 * (1 + 1e-12));
}

TEST_F(Contour, CurlsMoreTightlyTowardItsTip)
{
  const AlongArray<Curvature>& rest = array.restCurvature;
  const auto tightest = std::max_element(rest.value.begin(), rest.value.end()) - rest.value.begin();
  EXPECT_NEAR(inPerMillimeter(rest.value[static_cast<std::size_t>(tightest)]), 1.0 / 1.5, 0.01);
  EXPECT_LT(rest.fromTip[static_cast<std::size_t>(tightest)], millimeters(3.0));
  for (std::size_t i = static_cast<std::size_t>(tightest) + 1; i < rest.value.size(); ++i)
    EXPECT_LE(inPerMillimeter(rest.value[i]), inPerMillimeter(rest.value[i - 1])) << i;
}

TEST_F(Contour, IsStraightBehindItsContacts)
{
  for (const double place_mm : {18.0, 20.0, 25.0})
    EXPECT_EQ(array.restCurvature.at(millimeters(place_mm)).si(), 0.0) << place_mm;
}

TEST_F(Contour, NamesASourceForEveryTable)
{
  std::set<std::string> tables;
  for (const auto& [table, provenance] : array.provenance) {
    tables.insert(table);
    EXPECT_FALSE(provenance.source.empty()) << table;
  }
  EXPECT_EQ(tables, (std::set<std::string>{"length", "insertable", "diameter", "bending",
                                           "rest_curvature", "contacts", "ribs", "stylet"}));
}

TEST_F(Contour, SaysThatItIsNoDeviceLabeling)
{
  EXPECT_NE(array.note.find("not device labeling"), std::string::npos);
}

}  // namespace
}  // namespace perilymph::electrode

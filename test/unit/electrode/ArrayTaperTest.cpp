// SPDX-License-Identifier: BSD-3-Clause

// The range of an array's taper: in its file, and what an array with another one is.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"

namespace perilymph::electrode {
namespace {

using testing::HasSubstr;

/// A shipped array after some replacements in its text.
class TaperOfAnArray : public testing::Test {
protected:
  using Changes = std::vector<std::pair<std::string, std::string>>;

  Result<ArrayDesign> load(const std::string& name, const Changes& changes = {})
  {
    test::copyChanged(resource("plugins/electrodes/med-el/" + name + ".toml"), folder_ / "a.toml",
                      changes);
    return loadArray(folder_ / "a.toml");
  }
  std::string refused(const std::string& from, const std::string& to)
  {
    const auto array = load("medel-standard", {{from, to}});
    return array ? "accepted" : array.error().message;
  }

private:
  const test::TemporaryFolder folder_;
};

double width_mm(const ArrayDesign& array, double place_mm)
{
  return inMillimeters(array.sectionAt(millimeters(place_mm)).across);
}

TEST_F(TaperOfAnArray, IsStraightFromTheTipToTheLastContactAndFromThereToTheBase)
{
  const auto array = load("medel-standard");
  ASSERT_TRUE(array) << array.error().message;
  // tip 0.5 mm; last contact at 27.4 mm; base 1.3 mm at 31.5 mm
  const ArrayDesign thin = withTaper(*array, 0.0);
  EXPECT_NEAR(width_mm(thin, 0.0), 0.5, 1e-12);
  EXPECT_NEAR(width_mm(thin, 13.7), 0.65, 1e-12);
  EXPECT_NEAR(width_mm(thin, 27.4), 0.8, 1e-12);
  EXPECT_NEAR(width_mm(thin, 29.45), 1.05, 1e-12);
  EXPECT_NEAR(width_mm(thin, 33.0), 1.3, 1e-12);
  EXPECT_NEAR(width_mm(withTaper(*array, 1.0), 13.7), 0.9, 1e-12);
  EXPECT_TRUE(thin.isRound());
}

TEST_F(TaperOfAnArray, ChangesTheStiffnessOfTheSiliconeAlone)
{
  const auto array = load("medel-standard");
  ASSERT_TRUE(array) << array.error().message;
  const ArrayDesign thin = withTaper(*array, 0.0);
  // at 27.4 mm: 2 MPa pi / 64 (1.195873^4 - 0.8^4) mm^4 = 1.606e-7 N m^2
  const Length last = millimeters(27.4);
  EXPECT_NEAR((array->bending.at(last) - thin.bending.at(last)).si(), 1.606e-7, 1e-10);
  EXPECT_NEAR((array->bendingAcross.at(last) - thin.bendingAcross.at(last)).si(), 1.606e-7, 1e-10);
  for (const double place_mm : {0.0, 31.5, 34.5})
    EXPECT_NEAR(thin.bending.at(millimeters(place_mm)).si(),
                array->bending.at(millimeters(place_mm)).si(), 1e-20);
}

TEST_F(TaperOfAnArray, IsThatOfTheFileAtTheWidthOfItsStraightLine)
{
  const auto array = load("flexsoft");
  ASSERT_TRUE(array) << array.error().message;
  const double line_mm = 0.5 + 0.8 * 27.4 / 31.5;
  const ArrayDesign straight = withTaper(*array, (line_mm - 0.8) / 0.5);
  for (const double place_mm : {0.0, 10.0, 27.4, 29.0, 34.0}) {
    const Length place = millimeters(place_mm);
    EXPECT_NEAR(straight.sectionAt(place).across.si(), array->sectionAt(place).across.si(), 1e-15);
    EXPECT_NEAR(straight.sectionAt(place).within.si(), array->sectionAt(place).within.si(), 1e-15);
    EXPECT_NEAR(straight.bending.at(place).si(), array->bending.at(place).si(), 1e-19);
  }
}

TEST_F(TaperOfAnArray, KeepsTheRatioOfThicknessToWidth)
{
  const auto array = load("flexsoft");
  ASSERT_TRUE(array) << array.error().message;
  const Length last = millimeters(27.4);
  const Section thin = withTaper(*array, 0.0).sectionAt(last), line = array->sectionAt(last);
  EXPECT_NEAR(inMillimeters(thin.across), 0.8, 1e-12);
  EXPECT_NEAR(thin.within / thin.across, line.within / line.across, 1e-12);
}

TEST_F(TaperOfAnArray, IsNoOtherWhereTheFileStatesNone)
{
  const auto array = load("flex28");
  ASSERT_TRUE(array) << array.error().message;
  EXPECT_EQ(withTaper(*array, 0.0).diameter.value, array->diameter.value);
  EXPECT_EQ(withTaper(*array, 0.0).bending.value, array->bending.value);
}

TEST_F(TaperOfAnArray, IsRefusedWhereItIsNotPossible)
{
  EXPECT_EQ(refused("[taper]", "[taper]"), "accepted");
  for (const char* widths : {"[1.2, 0.9]", "[0.4, 1.3]", "[0.8, 1.4]", "[0.8, 1.0, 1.3]"})
    EXPECT_THAT(refused("[0.8, 1.3]", widths),
                HasSubstr("last_contact_mm must be two widths at the most basal contact, the "
                          "smaller first, between the tip's 0.5 mm and the base's 1.3 mm."))
        << widths;
  EXPECT_THAT(refused("[0.0, 31.5, 34.5]\ndiameter_mm = [0.5, 1.3, 1.3]",
                      "[0.0, 25.0]\ndiameter_mm = [0.5, 1.3]"),
              HasSubstr("give [diameter] a place behind the most basal contact, at 27.4 mm."));
  // at the tip 4 MPa pi / 64 0.5^4 mm^4 = 1.2272e-8 N m^2, more than all of the array
  EXPECT_THAT(refused("carrier_MPa = 2.0", "carrier_MPa = 4.0"),
              HasSubstr("silicone of 4 MPa gives the section at 0 mm a bending stiffness of "
                        "1.22718463e-08 N m2, and bending_N_m2 states 9.55e-09 for the whole array "
                        "there; state a softer one."));
  EXPECT_THAT(refused("carrier_MPa = 2.0", ""), HasSubstr("key 'taper.carrier_MPa' is missing"));
}

}  // namespace
}  // namespace perilymph::electrode

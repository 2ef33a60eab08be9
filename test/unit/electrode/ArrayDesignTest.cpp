// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/ArrayDesign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::electrode {
namespace {

using testing::HasSubstr;

constexpr const char* straightArray = R"(name = "Straight"
maker = "Nobody"
note = "Made up."
[length]
value_mm = 20.0
source = "made up"
confidence = "low"
[insertable]
value_mm = 18.0
source = "made up"
confidence = "low"
[diameter]
from_tip_mm = [0.0, 10.0]
diameter_mm = [0.4, 0.6]
source = "made up"
confidence = "medium"
[bending]
from_tip_mm = [0.0, 20.0]
bending_N_m2 = [1e-7, 3e-7]
source = "made up"
confidence = "high"
[contacts]
from_tip_mm = [1.0, 2.0, 3.0]
contact_length_mm = 0.5
source = "made up"
confidence = "low"
)";

class ArrayFile : public testing::Test {
protected:
  /// Loads the straight array after one text replacement.
  Result<ArrayDesign> load(const std::string& passage = "", const std::string& change = "")
  {
    std::string text = straightArray;
    const std::size_t place = text.find(passage);
    EXPECT_NE(place, std::string::npos) << passage;
    text.replace(place, passage.size(), change);
    std::ofstream(file_) << text;
    return loadArray(file_);
  }

  /// The error message after the replacement, without the folder.
  std::string error(const std::string& passage, const std::string& change)
  {
    const Result<ArrayDesign> design = load(passage, change);
    if (design) return "fine";
    const std::string folder = folder_.path().string() + "/";
    const std::string& message = design.error().message;
    return message.rfind(folder, 0) == 0 ? message.substr(folder.size()) : message;
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "a.toml";
};

TEST_F(ArrayFile, BecomesAnArrayInSi)
{
  const Result<ArrayDesign> array = load();
  ASSERT_TRUE(array) << array.error().message;
  EXPECT_EQ(array->name, "Straight");
  EXPECT_DOUBLE_EQ(array->length.si(), 0.020);
  EXPECT_DOUBLE_EQ(array->insertable.si(), 0.018);
  EXPECT_DOUBLE_EQ(array->bending.value[1].si(), 3e-7);
  EXPECT_DOUBLE_EQ(array->contactsFromTip[2].si(), 0.003);
  EXPECT_EQ(array->provenance[2].second.confidence, Confidence::medium);
}

TEST_F(ArrayFile, WithoutCurlRibsAndStyletIsStraightAndBare)
{
  const Result<ArrayDesign> array = load();
  ASSERT_TRUE(array);
  EXPECT_EQ(array->restCurvature.at(millimeters(7.0)).si(), 0.0);
  EXPECT_TRUE(array->ribsFromTip.empty());
  EXPECT_FALSE(array->hasStylet);
}

std::string withWires(const std::string& number, const std::string& stress)
{
  return "[wires]\nfrom_tip_mm = [0.0, 18.0]\nnumber = " + number +
         "\ndiameter_um = 25.0\nmodulus_GPa = 168.0\ncoupling = 0.4\n" + stress +
         "\nsource = 'x'\nconfidence = 'low'\n[contacts]";
}

constexpr const char* stress = "yield_MPa = 250.0\nyield_range_MPa = [150.0, 350.0]";

TEST_F(ArrayFile, StatesWiresApartFromTheSilicone)
{
  EXPECT_FALSE(load()->wires.has_value());
  const Result<ArrayDesign> array = load("[contacts]", withWires("[1.0, 3.0]", stress));
  ASSERT_TRUE(array) << array.error().message;
  ASSERT_TRUE(array->wires.has_value());
  // E pi d^4 / 64 = 3.2213e-9 N m2 and s d^3 / 6 = 0.65104 uN m of each of three wires
  const Wires::Branch single = array->wires->singleAt(millimeters(18));
  EXPECT_NEAR(single.bending.si(), 3 * 3.2213e-9, 1e-12);
  EXPECT_NEAR(single.moment, 3 * 0.65104e-6, 1e-10);
  const Wires::Branch bundle = array->wires->bundleAt(millimeters(18));
  EXPECT_NEAR(bundle.bending.si(), 0.4 * 9 * 3.2213e-9, 1e-12);
  EXPECT_NEAR(bundle.moment, std::pow(3 / 0.9, 1.5) * 0.65104e-6, 1e-10);
  EXPECT_EQ(inMegapascals(array->wires->yieldStress.maximum), 350.0);
  EXPECT_TRUE(array->yields());
}

TEST_F(ArrayFile, WithARangeOfTheYieldStressAloneIsElastic)
{
  const auto array =
      load("[contacts]", withWires("[1.0, 3.0]", "yield_range_MPa = [150.0, 350.0]"));
  ASSERT_TRUE(array) << array.error().message;
  EXPECT_EQ(inMegapascals(array->wires->yieldStress.minimum), 150.0);
  EXPECT_FALSE(array->yields());
}

TEST_F(ArrayFile, WithImpossibleWiresIsRefused)
{
  const auto refused = [this](const std::string& number, const std::string& of) {
    return error("[contacts]", withWires(number, of));
  };
  EXPECT_THAT(refused("[1.0, 3.0]", "yield_MPa = 250.0"), HasSubstr("yield_range_MPa"));
  EXPECT_THAT(refused("[1.0, 3.0]", "yield_MPa = 400.0\nyield_range_MPa = [150.0, 350.0]"),
              HasSubstr("yield_MPa"));
  EXPECT_THAT(refused("[1.0, 3.0]", "yield_MPa = 250.0\nyield_range_MPa = [350.0, 150.0]"),
              HasSubstr("the smallest first"));
  EXPECT_THAT(refused("[1.0, 60.0]", stress),
              HasSubstr("bending_N_m2 states 2.8e-07 for the whole array there"));
}

TEST_F(ArrayFile, RunsStraightBetweenKnotsAndStaysBeyondThem)
{
  const Result<ArrayDesign> array = load();
  ASSERT_TRUE(array);
  EXPECT_NEAR(inMillimeters(array->diameter.at(millimeters(2.5))), 0.45, 1e-12);
  EXPECT_DOUBLE_EQ(inMillimeters(array->diameter.at(millimeters(20.0))), 0.6);
  EXPECT_DOUBLE_EQ(inMillimeters(array->diameter.at(millimeters(-1.0))), 0.4);
}

TEST_F(ArrayFile, WithoutThicknessIsRoundAndBendsAlikeInEveryDirection)
{
  const Result<ArrayDesign> array = load();
  ASSERT_TRUE(array);
  EXPECT_TRUE(array->isRound());
  const Section section = array->sectionAt(millimeters(5.0));
  EXPECT_DOUBLE_EQ(inMillimeters(section.across), 0.5);
  EXPECT_DOUBLE_EQ(inMillimeters(section.within), 0.5);
  EXPECT_DOUBLE_EQ(array->bendingAcrossAt(millimeters(20.0)).si(), 3e-7);
  EXPECT_DOUBLE_EQ(inMillimeters(array->tipRadius()), 0.2);
}

TEST_F(ArrayFile, TwistsAsARoundIncompressibleRodUnlessTold)
{
  // G = E / 3 and J = 2 I
  const Result<ArrayDesign> array = load();
  ASSERT_TRUE(array);
  EXPECT_DOUBLE_EQ(array->twistingAt(millimeters(20.0)).si(), 2.0 / 3.0 * 3e-7);

  const Result<ArrayDesign> told =
      load("[1e-7, 3e-7]", "[1e-7, 3e-7]\ntwisting_N_m2 = [4e-8, 8e-8]");
  ASSERT_TRUE(told) << told.error().message;
  EXPECT_DOUBLE_EQ(told->twistingAt(millimeters(10.0)).si(), 6e-8);
}

TEST_F(ArrayFile, OfOvalSectionsTwistsAsAnEllipse)
{
  // Half axes a and b, modulus E: EI = E pi a b^3 / 4 and E pi a^3 b / 4;
  // GJ = (E / 3) pi a^3 b^3 / (a^2 + b^2).
  const double pi = std::acos(-1.0), a = 0.3e-3, b = 0.2e-3, modulus = 2e6;
  const double within = 0.25 * modulus * pi * a * b * b * b;
  const double across = 0.25 * modulus * pi * a * a * a * b;
  const double twisting = modulus / 3.0 * pi * a * a * a * b * b * b / (a * a + b * b);
  ArrayDesign array;
  array.bending = {{millimeters(0)}, {newtonSquareMeters(within)}};
  array.bendingAcross = {{millimeters(0)}, {newtonSquareMeters(across)}};
  EXPECT_NEAR(array.twistingAt(millimeters(1)).si(), twisting, 1e-12 * twisting);
}

TEST_F(ArrayFile, HoldsOvalSectionsAndTwoStiffnessesApart)
{
  const Result<ArrayDesign> array = load(
      "[0.4, 0.6]\nsource = \"made up\"\nconfidence = \"medium\"\n[bending]\n"
      "from_tip_mm = [0.0, 20.0]\nbending_N_m2 = [1e-7, 3e-7]",
      "[0.4, 0.6]\nthickness_mm = [0.3, 0.5]\nsource = \"x\"\nconfidence = \"low\"\n"
      "[bending]\nfrom_tip_mm = [0.0, 20.0]\nbending_N_m2 = [1e-7, 3e-7]\n"
      "bending_across_N_m2 = [2e-7, 6e-7]");
  ASSERT_TRUE(array) << array.error().message;
  EXPECT_FALSE(array->isRound());
  EXPECT_DOUBLE_EQ(inMillimeters(array->sectionAt(millimeters(5.0)).across), 0.5);
  EXPECT_DOUBLE_EQ(inMillimeters(array->sectionAt(millimeters(5.0)).within), 0.4);
  EXPECT_DOUBLE_EQ(inMillimeters(array->tipRadius()), 0.15);
  EXPECT_DOUBLE_EQ(array->bending.at(millimeters(20.0)).si(), 3e-7);
  EXPECT_DOUBLE_EQ(array->bendingAcrossAt(millimeters(20.0)).si(), 6e-7);
}

TEST_F(ArrayFile, WithATaperedTipWidensStraightFromItsCap)
{
  const Result<ArrayDesign> array =
      load("[bending]",
           "[tip]\nradius_mm = 0.1\ntaper_mm = 2.0\nsource = 'x'\nconfidence = 'low'\n[bending]");
  ASSERT_TRUE(array) << array.error().message;
  // From 0.2 mm at the tip to 0.44 mm, the carrier's own diameter 2 mm behind it.
  EXPECT_DOUBLE_EQ(inMillimeters(array->sectionAt(millimeters(0.0)).across), 0.2);
  EXPECT_NEAR(inMillimeters(array->sectionAt(millimeters(1.0)).across), 0.32, 1e-12);
  EXPECT_NEAR(inMillimeters(array->sectionAt(millimeters(2.0)).within), 0.44, 1e-12);
  EXPECT_NEAR(inMillimeters(array->sectionAt(millimeters(5.0)).within), 0.5, 1e-12);
}

TEST_F(ArrayFile, RefusesATipBlunterThanTheCarrier)
{
  EXPECT_EQ(
      error("[bending]", "[tip]\nradius_mm = 0.3\nsource = 'x'\nconfidence = 'low'\n[bending]"),
      "a.toml:18: tip.radius_mm is 0.3; it must be between 0.02 and 0.2.");
}

TEST_F(ArrayFile, RefusesRibsWithoutHeight)
{
  EXPECT_EQ(error("[contacts]",
                  "[ribs]\nfrom_tip_mm = [12.0]\nsource = 'x'\nconfidence = 'low'\n[contacts]"),
            "a.toml:22: key 'ribs.height_mm' is missing; it must be between 0.01 and 1.");
}

TEST_F(ArrayFile, RefusesADiameterOutOfRange)
{
  EXPECT_EQ(error("[0.4, 0.6]", "[0.4, 6.0]"),
            "a.toml:14: diameter.diameter_mm has 6 as number 2; it must be a list of at least 1 "
            "numbers, each between 0.1 and 2.");
}

TEST_F(ArrayFile, RefusesAStiffnessInTheWrongUnit)
{
  EXPECT_EQ(error("[1e-7, 3e-7]", "[0.1, 0.3]"),
            "a.toml:19: bending.bending_N_m2 has 0.1 as number 1; it must be a list of at least 1 "
            "numbers, each between 1e-09 and 0.0001.");
}

TEST_F(ArrayFile, RefusesPlacesThatDoNotGrow)
{
  EXPECT_EQ(
      error("[0.0, 20.0]", "[5.0, 5.0]"),
      "a.toml:18: from_tip_mm has 5 after 5; each place must be greater than the one before.");
}

TEST_F(ArrayFile, RefusesPlacesBeyondTheArray)
{
  EXPECT_THAT(error("[0.0, 20.0]", "[0.0, 21.0]"),
              HasSubstr("bending.from_tip_mm has 21 as number 2; it must be a list of at least 1 "
                        "numbers, each between 0 and 20."));
}

TEST_F(ArrayFile, RefusesUnequalLists)
{
  EXPECT_EQ(error("[0.4, 0.6]", "[0.4]"),
            "a.toml:14: diameter_mm has 1 numbers and from_tip_mm has 2; give one value for each "
            "place.");
}

TEST_F(ArrayFile, RefusesAnInsertableLengthBeyondTheArray)
{
  EXPECT_EQ(error("value_mm = 18.0", "value_mm = 21.0"),
            "a.toml:9: insertable.value_mm is 21; it must be between 1 and 20.");
}

TEST_F(ArrayFile, RefusesContactsThatOverlap)
{
  EXPECT_EQ(error("[1.0, 2.0, 3.0]", "[1.0, 1.4, 3.0]"),
            "a.toml:23: a contact of 0.5 mm at 1.4 mm overlaps the one at 1 mm; centers must be at "
            "least a contact's length apart.");
}

TEST_F(ArrayFile, RefusesContactsBeyondItsEnds)
{
  EXPECT_THAT(
      error("[1.0, 2.0, 3.0]", "[0.2, 2.0, 3.0]"),
      HasSubstr("a contact of 0.5 mm at 0.2 mm reaches beyond the tip; its center must be at "
                "least 0.25 mm from it."));
  EXPECT_THAT(error("[1.0, 2.0, 3.0]", "[1.0, 2.0, 19.9]"),
              HasSubstr("at 19.9 mm reaches beyond the array's 20 mm; its center must be at most "
                        "19.75 mm from the tip."));
}

TEST_F(ArrayFile, TakesContactsThatTouch)
{
  EXPECT_EQ(error("[1.0, 2.0, 3.0]", "[0.3, 0.8, 1.3]"), "fine");
}

TEST_F(ArrayFile, RefusesARibBeyondTheArray)
{
  EXPECT_THAT(error("[contacts]",
                    "[ribs]\nfrom_tip_mm = [22.0]\nheight_mm = 0.1\nlength_mm = 0.3\nsource = "
                    "'x'\nconfidence = 'low'\n[contacts]"),
              HasSubstr("ribs.from_tip_mm has 22 as number 1;"));
}

TEST_F(ArrayFile, RefusesACurlTighterThanTheCarriersRadius)
{
  // At 8 mm the radius is 1 mm: no curl of 1 per mm and more.
  const auto thickWith = [&](const std::string& curvature) {
    return error("diameter_mm = [0.4, 0.6]\nsource = \"made up\"\nconfidence = \"medium\"\n",
                 "diameter_mm = [2.0, 2.0]\nsource = \"x\"\nconfidence = \"low\"\n"
                 "[rest_curvature]\nfrom_tip_mm = [0.0, 8.0]\ncurvature_per_mm = [0.5, " +
                     curvature + "]\nsource = 'x'\nconfidence = 'low'\n");
  };
  EXPECT_EQ(thickWith("0.9"), "fine");
  EXPECT_EQ(
      thickWith("-1.5"),
      "a.toml:19: curvature_per_mm has -1.5 at 8 mm; it must be between -1 and 1, one over the "
      "carrier's radius there.");
}

TEST_F(ArrayFile, RefusesAStyletWithoutStiffness)
{
  EXPECT_EQ(
      error("[contacts]",
            "[stylet]\nfrom_tip_mm = 2.0\nsource = 'x'\nconfidence = 'low'\n[contacts]"),
      "a.toml:22: key 'stylet.bending_N_m2' is missing; it must be between 1e-09 and 0.0001.");
}

TEST_F(ArrayFile, RefusesATableWithoutSource)
{
  EXPECT_EQ(error("source = \"made up\"\nconfidence = \"medium\"", "confidence = \"medium\""),
            "a.toml:12: key 'diameter.source' is missing; it must be text.");
  EXPECT_EQ(error("confidence = \"medium\"", "confidence = \"sure\""),
            "a.toml:16: diameter.confidence is 'sure'; it must be one of high, medium, low.");
}

TEST_F(ArrayFile, RefusesAKeyWithoutUnit)
{
  EXPECT_EQ(error("diameter_mm", "diameter"),
            "a.toml:14: unknown key 'diameter.diameter'; did you mean diameter.diameter_mm?");
}

TEST_F(ArrayFile, RefusesAnUnknownTable)
{
  EXPECT_THAT(error("[contacts]", "[color]\nred = 1\n[contacts]"),
              HasSubstr("a.toml:22: unknown key 'color'"));
}

TEST_F(ArrayFile, ThatIsMissingIsNamed)
{
  const Result<ArrayDesign> array = loadArray(folder_ / "no.toml");
  ASSERT_FALSE(array);
  EXPECT_THAT(array.error().message, HasSubstr("no.toml: there is no such file"));
}

}  // namespace
}  // namespace perilymph::electrode

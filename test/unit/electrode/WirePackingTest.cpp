// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/WirePacking.h"

#include <gtest/gtest.h>

#include <map>

#include "perilymph/foundation/Resources.h"

namespace perilymph::electrode {
namespace {

ArrayDesign shipped(const std::string& name)
{
  const auto file = findByName("array", "plugins/electrodes", name);
  EXPECT_TRUE(file) << name;
  const auto array = loadArray(*file);
  EXPECT_TRUE(array) << array.error().message;
  return *array;
}

TEST(WirePacking, IsWhatTheFilesState)
{
  // c of each file's source; arrays with a stylet or sheath keep theirs
  const std::map<std::string, double> stated = {
      {"flex20", 0.06},           {"flex24", 0.06},         {"flex26", 0.06},
      {"flex28", 0.06},           {"flexsoft", 0.06},       {"medel-compressed", 0.06},
      {"medel-medium", 0.06},     {"medel-standard", 0.06}, {"hifocus-slimj", 1.2},
      {"hifocus-mid-scala", 0.0}, {"hybrid-l24", 1.2},      {"nucleus-straight", 1.2},
      {"slim-straight", 1.2},     {"slim-modiolar", 0.0},   {"evo", 1.2},
      {"contour", 0.0},           {"contour-advance", 0.0}};
  for (const std::string& name : shippedNames("plugins/electrodes")) {
    ASSERT_TRUE(stated.contains(name)) << name;
    const auto packing = wirePacking(shipped(name));
    ASSERT_EQ(packing.has_value(), stated.at(name) > 0.0) << name;
    if (packing) {
      EXPECT_NEAR(*packing, stated.at(name), 0.01 * stated.at(name)) << name;
    }
  }
}

TEST(WirePacking, IsNotDrawnForWiresThatYield)
{
  // what yielding takes is in the lower values of c already
  ArrayDesign slimJ = shipped("hifocus-slimj");
  ASSERT_TRUE(slimJ.wires);
  slimJ.wires->yieldStress.value = slimJ.wires->yieldStress.minimum;
  EXPECT_FALSE(wirePacking(slimJ));
  EXPECT_EQ(withWirePacking(slimJ, 0.3).bending.value, slimJ.bending.value);
}

TEST(WirePacking, ChangesTheWiresTermAlone)
{
  // SlimJ at the base: 16 wires of 25 um, 168 GPa: E_w I_w = 3.2213e-9 N m^2; silicone of 2 MPa and 0.7 mm:
  // 2.3572e-8 N m^2; with c = 0.3: 2.3572e-8 + 3.2213e-9 (16 + 0.3 256) = 3.2251e-7
  const ArrayDesign slimJ = shipped("hifocus-slimj");
  const auto packing = wirePacking(slimJ);
  ASSERT_TRUE(packing);
  const ArrayDesign looser = withWirePacking(slimJ, 0.3);
  EXPECT_NEAR(looser.bending.at(millimeters(23)).si(), 3.2251e-7,
              5e-9);  // the file has 1.06e-6, rounded to 0.01e-6
  EXPECT_NEAR(looser.bending.at(millimeters(0)).si(), slimJ.bending.at(millimeters(0)).si(), 4e-9);
  EXPECT_NEAR(*wirePacking(looser), 0.3, 0.003);
  // an oval array gets the same term in both directions
  const ArrayDesign flex = shipped("flex28"),
                    stiffer = withWirePacking(flex, *wirePacking(flex) + 1.14);
  const Length base = millimeters(28);
  EXPECT_NEAR((stiffer.bending.at(base) - flex.bending.at(base)).si(), 1.14 * 3.2213e-9 * 144,
              1e-11);
  EXPECT_NEAR((stiffer.bendingAcross.at(base) - flex.bendingAcross.at(base)).si(),
              1.14 * 3.2213e-9 * 144, 1e-11);
}

}  // namespace
}  // namespace perilymph::electrode

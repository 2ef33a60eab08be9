// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/CochleaStore.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace perilymph::test {
namespace {

using Built = std::shared_ptr<const anatomy::ScalaTympani>;

Built cochleaOf(gui::CochleaStore& store, const session::Overrides& overrides)
{
  const auto scenario = session::loadScenario("contour-published", overrides);
  if (!scenario) throw std::runtime_error(scenario.error().message);
  const auto built = store.cochleaOf(*scenario);
  if (!built) throw std::runtime_error(built.error().message);
  return *built;
}

session::Overrides length(int tenths_mm)
{
  return {{"patient_numbers.st_length_mm",
           std::to_string(tenths_mm / 10) + "." + std::to_string(tenths_mm % 10)},
          {"patient_numbers.rw_width_mm", "2.0"},
          {"patient_numbers.rw_height_mm", "1.8"}};
}

TEST(CochleaStore, BuildsTheSameNumbersOnce)
{
  gui::CochleaStore store;
  const Built first = cochleaOf(store, {});
  EXPECT_EQ(cochleaOf(store, {}), first);
  EXPECT_EQ(cochleaOf(store, {{"array", "flex28"}, {"speed_mm_s", "1.0"}}), first);
  EXPECT_NE(cochleaOf(store, length(331)), first);
  EXPECT_NE(cochleaOf(store, {{"anatomy", "mean"}}), first);
}

TEST(CochleaStore, KeepsThoseUsedLast)
{
  gui::CochleaStore store;
  std::vector<Built> built;
  for (int i = 0; i < int(gui::CochleaStore::capacity); ++i)
    built.push_back(cochleaOf(store, length(330 + i)));
  EXPECT_EQ(cochleaOf(store, length(330)), built[0]);  // now used last
  cochleaOf(store, length(340));                       // replaces the second
  EXPECT_EQ(cochleaOf(store, length(330)), built[0]);
  EXPECT_NE(cochleaOf(store, length(331)), built[1]);
}

TEST(MeasuresOfACochlea, AreComputedAgainWhereOnlyTheirErrorsChange)
{
  gui::CochleaStore store;
  const auto scenario = session::loadScenario("contour-published", {});
  if (!scenario) throw std::runtime_error(scenario.error().message);
  const auto& array = scenario->array();
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  const auto bandOfDuctLength = [&](double error_mm) {
    cochlea.patient.errors = anatomy::BasalTurnErrors{millimeters(error_mm), millimeters(0.1)};
    const auto found = store.measures().of(cochlea, array);
    if (!found) throw std::runtime_error(found.error().message);
    EXPECT_EQ(found->measures.at(0).key, gui::CochleaMeasures::ductLength);
    return found->bands.at(0);
  };
  // By hand, elliptic-circular: 32.88 mm, by mm of A 1.409 and of B 3.735; from A alone 33.86 mm. B has 0.1 mm.
  EXPECT_NEAR(bandOfDuctLength(0.1), 1.248, 0.03);
  EXPECT_NEAR(bandOfDuctLength(0.3), 1.472, 0.03);
  EXPECT_NEAR(bandOfDuctLength(0.1), 1.248, 0.03);
}

}  // namespace
}  // namespace perilymph::test

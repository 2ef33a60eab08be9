// SPDX-License-Identifier: BSD-3-Clause

// Bone does not yield visibly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::session {
namespace {

constexpr double bone_mm = 0.03;    // beyond the lining
constexpr double extreme_mm = 0.1;  // the same up to the largest forces measured in patients ...
constexpr double extremeForce = 0.102;  // ... [N] (Rau et al. 2024, doi 10.3389/fneur.2024.1400455)

struct Case {
  const char* scenario;
  const char* array;          // empty: the scenario's own, to its own depth
  const char* patient;        // empty: none
  const char* friction = "";  // empty: the scenario's own
};

/// An insertion to full depth, and how far nodes sank into wall and lining on the way.
struct Full {
  std::unique_ptr<Insertion> insertion;
  double wallDepth_mm = 0.0;  ///< Into wall and lining, maximum.
  double peak = 0.0;          ///< Maximum axial force [N].
  bool arrived = false;
  long iterations = 0, maxIterations = 0, ticks = 0, notConverged = 0;
};

/// Inverse of the wall's law: penetration under a force on stiffness k with lining t.
double penetrationAt(double force, double k, double t)
{
  return force < 0.5 * k * t ? std::sqrt(2.0 * force * t / k) : force / k + 0.5 * t;
}

Full runInsertion(const Case& of)
{
  Overrides overrides = {{"dt_ms", "2"}, {"speed_mm_s", "2"}};
  if (*of.patient != '\0') overrides.emplace_back("patient", of.patient);
  if (*of.friction != '\0') overrides.emplace_back("friction", of.friction);
  if (*of.array != '\0') {
    const auto design = electrode::loadArray(*findByName("array", "plugins/electrodes", of.array));
    overrides.emplace_back("array", of.array);
    overrides.emplace_back("stop_travel_mm",
                           std::to_string(inMillimeters(design->insertable) - 2.001));
  }
  const auto scenario = loadScenario(of.scenario, overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  const InsertionParameters& parameters = scenario->parameters();
  Full full;
  auto prepared = Insertion::prepare(
      parameters,
      std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()));
  EXPECT_TRUE(prepared);
  full.insertion = std::move(*prepared);
  const double lining = parameters.wall.lining.si();
  const auto each = [&](const haptics::TickRecord& record) {
    const mechanics::InsertionState& state = full.insertion->loop().engine().state();
    const mechanics::InsertionModel& model = full.insertion->model();
    for (std::size_t i = 0; i < state.normalForce.size(); ++i) {
      const double onBone = state.normalForce[i] - state.membraneForce[i];
      if (onBone <= 0.0) continue;
      full.wallDepth_mm =
          std::max(full.wallDepth_mm, 1e3 * penetrationAt(onBone, model.wallStiffness[i], lining));
    }
    full.peak = std::max(full.peak, record.output.axialForce);
    const long iterations = static_cast<long>(record.output.iterations);
    full.iterations += iterations;
    full.maxIterations = std::max(full.maxIterations, iterations);
    full.notConverged += (record.output.status & haptics::notConverged) != 0 ? 1 : 0;
    ++full.ticks;
    return *of.friction == '\0' || full.peak < extremeForce;
  };
  full.arrived = static_cast<bool>(full.insertion->runToEnd(each, 20'000));
  return full;
}

class BoneWall : public testing::TestWithParam<Case> {};

TEST_P(BoneWall, KeepsTheArrayWithin30MicrometersOfItsSurface)
{
  const Full full = runInsertion(GetParam());
  const mechanics::WallLaw& wall = full.insertion->model().parts.wall;
  EXPECT_TRUE(full.arrived);
  EXPECT_GE(wall.perSamplePoint, newtonsPerMeter(2000));
  EXPECT_LE(full.wallDepth_mm, inMillimeters(wall.lining) + bone_mm);
  EXPECT_EQ(full.notConverged, 0);
  EXPECT_LE(full.iterations, 8 * full.ticks);
  RecordProperty("peak_mN", std::to_string(1e3 * full.peak));
}

INSTANTIATE_TEST_SUITE_P(FullDepth, BoneWall,
                         testing::Values(Case{"mean-flex28", "", ""}, Case{"mean-contour", "", ""},
                                         Case{"mean-flex28", "flex28", ""},
                                         Case{"mean-flex28", "hifocus-slimj", ""},
                                         Case{"mean-contour", "contour-advance", ""},
                                         Case{"mean-contour", "nucleus-straight", ""},
                                         Case{"contour-published", "", "average"},
                                         Case{"contour-published", "", "small"},
                                         Case{"contour-published", "", "large"},
                                         Case{"contour-published", "", "left"}));

TEST(BoneWallOfTissue, KeepsArraysWithinATenthOfAMillimeterUpToTheForcesInPatients)
{
  // in tissue a MED-EL array buckles before
  for (const auto& [array, friction] :
       {std::pair("medel-standard", "endosteum"), std::pair("nucleus-straight", "tissue"),
        std::pair("hifocus-slimj", "tissue")}) {
    const Full full = runInsertion({"surgery-flex28", array, "", friction});
    EXPECT_GE(full.peak, extremeForce) << array;
    EXPECT_LE(full.wallDepth_mm,
              inMillimeters(full.insertion->model().parts.wall.lining) + extreme_mm)
        << array;
  }
}

TEST(PublishedWall, YieldsAsSiliconeOnAHardModel)
{
  const Full full = runInsertion({"contour-published", "", ""});
  EXPECT_TRUE(full.arrived);
  EXPECT_EQ(full.insertion->model().parts.wall.perSamplePoint, newtonsPerMeter(2700));
  EXPECT_GT(full.wallDepth_mm, 0.1);
}

}  // namespace
}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause

// Plans of two arrays with few nodes and long steps: not for their numbers, but for what must hold of
// any plan.

#include "perilymph/planning/Plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <tuple>

#include "PlanFile.h"
#include "PlanSetup.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/planning/PlannedDraw.h"
#include "perilymph/planning/ResistanceGrid.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

class SmallPlan : public testing::Test {
protected:
  static planning::PlanRequest smallRequest()
  {
    planning::PlanRequest request;
    request.patient = measuredPatient();
    request.arrays = {"flex24", "hifocus-slimj"};
    request.resolution = planning::Resolution{30, milliseconds(10)};
    request.draws = 3;
    return request;
  }
  /// The plan of the unchanged request, made once by one thread.
  static const planning::Plan& usual()
  {
    static const auto plan = [] {
      planning::PlanRequest request = smallRequest();
      request.jobs = 1;
      return planning::makePlan(request, {}, {});
    }();
    if (!plan) throw std::runtime_error(plan.error().message);
    return *plan;
  }
  std::filesystem::path draws() const { return folder_.path() / "draws.sqlite"; }

  /// Everything that a plan writes.
  static std::string textOf(const planning::Plan& plan)
  {
    const auto json = planning::planJson(plan);
    std::string text = json ? *json : json.error().message;
    for (const auto& each : plan.insertions) text += planning::contentOf(each) + '\n';
    return text + planning::arraysCsv(plan) + planning::contactsCsv(plan);
  }

  TemporaryFolder folder_;
  planning::PlanRequest request_ = smallRequest();
};

TEST_F(SmallPlan, IsTheSameForOneThreadAndTwoAndAfterAnInterruption)
{
  ASSERT_EQ(usual().insertions.size(), 6u);
  request_.jobs = 2;
  request_.draws = 1;
  ASSERT_TRUE(planning::makePlan(request_, draws(), {}));
  request_.draws = 3;
  std::stop_source stop;
  const auto atOnce = [&](std::size_t, std::size_t) { stop.request_stop(); };
  EXPECT_FALSE(planning::makePlan(request_, draws(), atOnce, stop.get_token()));
  const auto two = planning::makePlan(request_, draws(), {});
  ASSERT_TRUE(two) << two.error().message;
  EXPECT_EQ(textOf(usual()), textOf(*two));
}

TEST_F(SmallPlan, KeepsTheDrawsThatWereFinishedWhenItIsInterrupted)
{
  request_.jobs = 1;
  request_.draws = 3;
  std::stop_source stop;
  const auto afterOne = [&](std::size_t done, std::size_t) {
    if (done > 0) stop.request_stop();
  };
  EXPECT_FALSE(planning::makePlan(request_, draws(), afterOne, stop.get_token()));
  request_.draws = 1;
  const auto seen = planning::viewPlan(request_, draws());
  ASSERT_TRUE(seen) << seen.error().message;
  const auto made = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(textOf(*seen), textOf(*made));
}

TEST_F(SmallPlan, NamesEachArrayOnce)
{
  request_.arrays = {"flex20", "flex24", "flex20"};
  const auto made = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "The array flex20 is named twice. Name it once.");
}

TEST_F(SmallPlan, StatesTheFrictionThatItsBandsHoldFixed)
{
  request_.draws = 1;
  request_.arrays = {"flex20"};
  const auto usual = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(usual) << usual.error().message;
  EXPECT_EQ(usual->friction.low, 0.165);  // resources/friction/estimate-from-pig-tissue.toml
  EXPECT_EQ(usual->friction.high, 0.165);
  // 0.283 common to all ears and 0.2 between them
  EXPECT_NEAR(usual->frictionSpread, std::sqrt(0.283 * 0.283 + 0.2 * 0.2), 1e-12);
  EXPECT_EQ(planning::bandsHold(*usual), "1 simulation over friction 0.08 to 0.33");
  request_.friction = "paper";
  const auto other = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->friction.low, 0.0395);
  EXPECT_EQ(other->friction.high, 0.0605);
  EXPECT_EQ(other->frictionSpread, 0.0);
}

TEST(Draws, BelowSixteenAreOfferedToNobodyAndSayWhy)
{
  ::unsetenv(fewDraws);
  for (const std::size_t draws : {0u, 1u, 2u, 15u}) {
    const auto refused = planning::checkDraws(draws);
    ASSERT_FALSE(refused) << draws;
    EXPECT_EQ(refused.error().message,
              "A plan of " + std::to_string(draws) +
                  " simulations is too short: the lowest and the highest of fewer than 16 hold "
                  "less than 88 % of the insertions to come. Choose 16 to 4096.");
  }
  for (const std::size_t draws : {16u, 64u, 4096u}) EXPECT_TRUE(planning::checkDraws(draws));
  EXPECT_FALSE(planning::checkDraws(4097));
  ::setenv(fewDraws, "1", 1);
  EXPECT_TRUE(planning::checkDraws(1));
  EXPECT_FALSE(planning::checkDraws(0));
  ::unsetenv(fewDraws);
}

TEST_F(SmallPlan, InsertsAllArraysIntoTheSameCochleaByTheSameHand)
{
  const planning::Plan& plan = usual();
  for (std::size_t i = 0; i < plan.insertions.size(); i += 2) {
    const auto& a = plan.insertions[i];
    const auto& b = plan.insertions[i + 1];
    EXPECT_EQ(a.a_mm, b.a_mm);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_GT(a.insertion.apical.si(), 0.0);
    EXPECT_FALSE(a.insertion.contacts.empty());
    EXPECT_FALSE(a.insertion.profile.empty());
  }
  EXPECT_NE(plan.insertions[0].a_mm, plan.insertions[2].a_mm);
}

TEST_F(SmallPlan, TakesAnotherFrictionThanTheScenarios)
{
  request_.friction = "tissue";
  const auto scenario = planning::scenarioOf(request_, "flex24", session::anyStopTravel);
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->friction().kineticCoefficient, 0.24);
  const auto rough = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(rough) << rough.error().message;
  EXPECT_NE(rough->fingerprint, usual().fingerprint);
  for (std::size_t i = 0; i < rough->arrays.size(); ++i)
    EXPECT_LT(rough->arrays[i].angle_deg.median, usual().arrays[i].angle_deg.median);
  request_.friction = "butter";
  const auto unknown = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("butter"), std::string::npos);
}

TEST_F(SmallPlan, DeviatesFromAGivenApproachAsFromTheScenarios)
{
  request_.approach = anatomy::Approach{degrees(-6.25), degrees(11.5)};
  const auto scenario = planning::scenarioOf(request_, "flex24", session::anyStopTravel);
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_NEAR(inDegrees(scenario->approachTilt()), -6.25, 1e-9);
  EXPECT_NEAR(inDegrees(scenario->approachTurn()), 11.5, 1e-9);
  const auto oblique = planning::makePlan(request_, {}, {});
  ASSERT_TRUE(oblique) << oblique.error().message;
  EXPECT_NE(oblique->fingerprint, usual().fingerprint);
  // the same draws about another line: other forces
  for (std::size_t i = 0; i < oblique->insertions.size(); ++i) {
    EXPECT_EQ(oblique->insertions[i].tilt_deg, usual().insertions[i].tilt_deg);
    EXPECT_EQ(oblique->insertions[i].turn_deg, usual().insertions[i].turn_deg);
    EXPECT_NE(oblique->insertions[i].insertion.endForce.si(),
              usual().insertions[i].insertion.endForce.si());
  }
}

TEST_F(SmallPlan, RunsADrawAgainForAView)
{
  const planning::Plan& plan = usual();
  const std::size_t draw = planning::medianDraw(plan, 1);
  ASSERT_GE(draw, 1u);
  ASSERT_LE(draw, 3u);
  const auto shape = planning::shapeOf(plan, 1, draw, {});
  ASSERT_TRUE(shape) << shape.error().message;
  const auto& planned = plan.insertions[2 * (draw - 1) + 1].insertion;
  const auto& again = shape->insertion.insertion;
  EXPECT_EQ(again.apical.si(), planned.apical.si());
  EXPECT_EQ(again.endForce.si(), planned.endForce.si());
  EXPECT_GT(again.profile.size(), 4 * planned.profile.size());
  EXPECT_EQ(shape->end.nodes, 30u);
  EXPECT_EQ(shape->parameters.array.name, plan.arrays[1].name);
  // the tip is in the draw's cochlea, at the depth that the plan says
  const auto contacts =
      analysis::contactPositions(*shape->anatomy, shape->parameters.array, shape->end);
  EXPECT_EQ(contacts.front().angle.si(), planned.contacts.front().angle.si());
}

TEST_F(SmallPlan, KeepsTheEndsThatRepresentItsArraysOrRunsThemAgainToTheSameBits)
{
  const planning::Plan& plan = usual();
  const auto kept = planning::representativeEnds(plan, {});
  ASSERT_TRUE(kept) << kept.error().message;
  ASSERT_EQ(kept->size(), 2u);
  for (std::size_t array = 0; array < kept->size(); ++array) {
    const planning::RepresentativeEnd& end = (*kept)[array];
    EXPECT_EQ(end.draw, planning::medianDraw(plan, array));
    const auto shape = planning::shapeOf(plan, array, end.draw, {});
    ASSERT_TRUE(shape) << shape.error().message;
    ASSERT_EQ(end.node_W.size(), 30u);
    for (std::size_t node = 0; node < 30; ++node)
      EXPECT_EQ(end.node_W[node], shape->end.node_W[node]) << array << " " << node;
  }
  // as they are read from a file: without their ends
  for (const unsigned jobs : {1u, 2u}) {
    planning::Plan read = plan;
    read.request.jobs = jobs;
    for (planning::PlannedInsertion& each : read.insertions) each.end_W.clear();
    const auto again = planning::representativeEnds(read, {});
    ASSERT_TRUE(again) << again.error().message;
    for (std::size_t array = 0; array < kept->size(); ++array) {
      EXPECT_EQ((*again)[array].draw, (*kept)[array].draw);
      EXPECT_EQ((*again)[array].node_W, (*kept)[array].node_W) << array;
    }
    read.isCurrent = false;
    EXPECT_FALSE(planning::representativeEnds(read, {}));
  }
}

TEST_F(SmallPlan, HasNoShapeOfADrawThatWasNotRun)
{
  EXPECT_FALSE(planning::shapeOf(usual(), 1, 4, {}));
  EXPECT_FALSE(planning::shapeOf(usual(), 2, 1, {}));
}

TEST(MedianDraw, IsNearestToTheMediansOfAngleAndPeak)
{
  EXPECT_EQ(planning::medianDraw(syntheticPlan(101), 0), 51u);
}

TEST_F(SmallPlan, OfAPatientWithoutABasalTurnIsRefused)
{
  request_.patient.basalTurn.reset();
  const auto plan = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("has no A and B"), std::string::npos);
}

TEST_F(SmallPlan, NamesAnArrayThatIsNotThere)
{
  request_.arrays = {"flex24", "flex99"};
  const auto plan = planning::makePlan(request_, {}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("flex99"), std::string::npos) << plan.error().message;
}

TEST_F(SmallPlan, RefusesTheDrawsOfAnotherSeed)
{
  request_.draws = 1;
  ASSERT_TRUE(planning::makePlan(request_, draws(), {}));
  request_.seed = 2;
  const auto plan = planning::makePlan(request_, draws(), {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("another plan"), std::string::npos) << plan.error().message;
}

/// The shipped files, one of which can be changed.
class OwnResources {
public:
  OwnResources()
  {
    for (const char* folder :
         {"resources", "resources/planning", "resources/clinical", "resources/reference"})
      fs::create_directory(folder_ / folder);
    fs::create_directory_symlink(resource("plugins"), folder_ / "plugins");
    for (const auto& entry : fs::directory_iterator(resource("resources"))) {
      const fs::path place = folder_ / "resources" / entry.path().filename();
      if (!fs::exists(place)) fs::create_symlink(entry.path(), place);
    }
    for (const char* folder : {"resources/planning", "resources/clinical", "resources/reference"})
      fs::copy(resource(folder), folder_ / folder);
    setenv(variable, folder_.path().c_str(), 1);
  }
  ~OwnResources() { before_ ? setenv(variable, before_->c_str(), 1) : unsetenv(variable); }
  OwnResources(const OwnResources&) = delete;
  OwnResources& operator=(const OwnResources&) = delete;

  /// Replaces a number in a file.
  void change(const char* file, const std::string& from, const std::string& to) const
  {
    copyChanged(folder_ / file, folder_ / file, {{from, to}});
  }

private:
  static std::optional<std::string> valueBefore()
  {
    const char* value = std::getenv(variable);
    return value ? std::optional<std::string>(value) : std::nullopt;
  }

  static constexpr const char* variable = "PERILYMPH_RESOURCES";
  std::optional<std::string> before_ = valueBefore();
  TemporaryFolder folder_;
};

TEST_F(SmallPlan, IsViewedAsItWasMade)
{
  request_.draws = 2;
  const auto made = planning::makePlan(request_, draws(), {});
  ASSERT_TRUE(made) << made.error().message;
  const auto seen = planning::viewPlan(request_, draws());
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_TRUE(seen->isCurrent);
  EXPECT_EQ(textOf(*seen), textOf(*made));
  request_.draws = 3;
  EXPECT_FALSE(planning::viewPlan(request_, draws()));
}

TEST_F(SmallPlan, IsViewedButNotContinuedAfterADistributionOrAThresholdWasChanged)
{
  const std::tuple<const char*, const char*, const char*> changes[] = {
      {"resources/planning/uncertainty.toml", "tilt_sd_deg = 4.0", "tilt_sd_deg = 5.0"},
      {"resources/clinical/hand.toml", "lag_mm = 1.0", "lag_mm = 1.5"},
      {"resources/clinical/wires.toml", "packing_low = 0.06", "packing_low = 0.1"},
      // not of the draws but of what the summary compares them with
      {"resources/reference/surgeons.toml", "value_N = 0.0204", "value_N = 0.0102"},
      {"resources/planning/frequency-allocation.toml", "[120, 235,", "[140, 235,"}};
  request_.draws = 2;
  for (const auto& [file, from, to] : changes) {
    const OwnResources resources;
    const fs::path place = folder_ / fs::path(file).stem();
    fs::create_directory(place);
    const fs::path draws = place / "draws.sqlite";
    const auto made = planning::makePlan(request_, draws, {});
    ASSERT_TRUE(made) << made.error().message;
    std::ofstream(place / "plan.json") << *planning::planJson(*made);
    const auto before = planning::fingerprintOf(request_);
    ASSERT_TRUE(before);
    EXPECT_EQ(*before, made->fingerprint);

    resources.change(file, from, to);
    EXPECT_NE(*planning::fingerprintOf(request_), *before) << file;
    const auto continued = planning::makePlan(request_, draws, {});
    ASSERT_FALSE(continued) << file;
    EXPECT_NE(continued.error().message.find(file), std::string::npos) << continued.error().message;
    const auto seen = planning::viewPlan(request_, draws);
    ASSERT_TRUE(seen) << seen.error().message;
    EXPECT_FALSE(seen->isCurrent);
    EXPECT_EQ(planning::arraysCsv(*seen), planning::arraysCsv(*made));
    EXPECT_EQ(planning::contactsCsv(*seen), planning::contactsCsv(*made));
    EXPECT_EQ(seen->seal, Seal::intact);
    for (const auto& change : {+[](planning::PlanRequest& one) { ++one.seed; },
                               +[](planning::PlanRequest& one) { one.friction = "tissue"; },
                               +[](planning::PlanRequest& one) { one.patient.label = "other"; }}) {
      planning::PlanRequest other = request_;
      change(other);
      const auto changed = planning::viewPlan(other, draws);
      ASSERT_TRUE(changed) << changed.error().message;
      EXPECT_EQ(changed->seal, Seal::changed);
      EXPECT_EQ(changed->fingerprint, "");
    }
    EXPECT_FALSE(planning::shapeOf(*seen, 0, 1, {}));
    fs::remove(place / "plan.json");
    EXPECT_FALSE(planning::viewPlan(request_, draws));
  }
}

/// A clinic in which friction is somewhat higher than shipped: the prior without its lower half.
std::string clinicText(double friction)
{
  planning::ClinicResistance clinic;
  clinic.cells = planning::resistancePrior();
  double sum = 0.0;
  for (std::size_t i = 0; i < clinic.cells.size(); ++i) {
    if (planning::frictionShift(i / planning::stopShifts) < 0.0) clinic.cells[i] = 0.0;
    sum += clinic.cells[i];
  }
  for (double& cell : clinic.cells) cell /= sum;
  clinic.friction = friction;
  clinic.resisted = 9;
  clinic.firstYear = clinic.lastYear = 2026;
  return planning::clinicResistanceText(clinic);
}

TEST_F(SmallPlan, WithAClinicsResistanceHasTheSameInsertionsAndAnotherNumber)
{
  const fs::path file = folder_.path() / "clinic.json";
  std::ofstream(file) << clinicText(0.165);
  planning::PlanRequest request = smallRequest();
  request.clinicResistance = file.string();
  const auto plan = planning::makePlan(request, draws(), {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_NE(plan->fingerprint, usual().fingerprint);
  ASSERT_EQ(plan->insertions.size(), usual().insertions.size());
  for (std::size_t i = 0; i < plan->insertions.size(); ++i) {
    const auto &with = plan->insertions[i], &without = usual().insertions[i];
    EXPECT_EQ(with.insertion.depth, without.insertion.depth);
    EXPECT_EQ(with.insertion.peak, without.insertion.peak);
    EXPECT_EQ(with.insertion.partition, without.insertion.partition);
    EXPECT_EQ(with.stop_mm.size(), planning::stopShifts);
    EXPECT_TRUE(without.stop_mm.empty());
    // a higher limit stops no earlier
    EXPECT_TRUE(std::is_sorted(with.stop_mm.begin(), with.stop_mm.end()));
  }
  // three simulations are not a hundred effective ones
  ASSERT_TRUE(plan->clinic);
  EXPECT_EQ(plan->clinic->resisted, 9u);
  EXPECT_FALSE(plan->arrays[0].inClinic);
  // file and text keep it
  const auto viewed = planning::viewPlan(request, draws());
  ASSERT_TRUE(viewed) << viewed.error().message;
  EXPECT_TRUE(viewed->isCurrent);
  EXPECT_EQ(viewed->insertions[0].stop_mm, plan->insertions[0].stop_mm);
  const auto json = planning::planJson(*plan);
  ASSERT_TRUE(json) << json.error().message;
  const auto stored = planning::planIn(*json, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  ASSERT_TRUE(stored->plan.clinic);
  EXPECT_EQ(stored->plan.clinic->number, plan->clinic->number);
  EXPECT_EQ(stored->limits.back(), planning::clinicSentence(*plan->clinic));
  EXPECT_NE(stored->limits.back().phrase(), nullptr);
}

TEST_F(SmallPlan, RefusesAClinicsResistanceOfAnotherFriction)
{
  const fs::path file = folder_.path() / "clinic.json";
  std::ofstream(file) << clinicText(0.12);
  planning::PlanRequest request = smallRequest();
  request.clinicResistance = file.string();
  const auto plan = planning::makePlan(request, {}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("counts from the friction 0.12, and this plan has 0.165"),
            std::string::npos);
  std::ofstream(file) << "{}";
  EXPECT_FALSE(planning::makePlan(request, {}, {}));
}

TEST(ClinicDepths, AreShallowerWhereFrictionIsHigherAndLeaveForcesAsTheyAre)
{
  // 200 simulations of a law: depth 20 mm - 10 mm u, whatever the limit
  planning::PlanSetup setup;
  planning::Nominal nominal;
  nominal.parameters.frictionSpread = {0.283, 0.2};
  setup.nominal.push_back(nominal);
  const auto clinic = planning::clinicResistanceIn(clinicText(0.165), "clinic.json");
  ASSERT_TRUE(clinic);
  setup.clinic = *clinic;
  planning::Plan plan;
  plan.arrays.resize(1);
  plan.arrays[0].peak_mN.median = 77.0;
  for (int k = 0; k < 200; ++k) {
    planning::PlannedInsertion one;
    const double u = 0.7 * (k - 99.5) / 100.0;
    one.friction = std::exp(u);
    one.intended_mm = 40.0;
    one.push_mm = 40.0;
    one.stop_mm.assign(planning::stopShifts, 20.0 - 10.0 * u);
    plan.insertions.push_back(one);
  }
  planning::addClinic(plan, setup);
  ASSERT_TRUE(plan.arrays[0].inClinic);
  EXPECT_GE(plan.arrays[0].inClinic->effective, planning::fewestEffective);
  // the upper half of N(0, 0.28^2) has the mean 0.22: some 2 mm shallower
  EXPECT_LT(plan.arrays[0].inClinic->depth_mm.median, 19.0);
  EXPECT_GT(plan.arrays[0].inClinic->depth_mm.median, 16.0);
  EXPECT_EQ(plan.arrays[0].peak_mN.median, 77.0);
}

}  // namespace
}  // namespace perilymph::test

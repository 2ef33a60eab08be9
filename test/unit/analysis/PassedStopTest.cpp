// SPDX-License-Identifier: BSD-3-Clause

// Where a hand that stops would have ended, compared with an insertion that does stop there.

#include "perilymph/analysis/PassedStop.h"

#include <gtest/gtest.h>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/SimulatedInsertion.h"
#include "perilymph/device/ScriptedDevice.h"

namespace perilymph::analysis {
namespace {

struct InsertionToItsEnd {
  SimulatedInsertion simulated;
  std::vector<ContactPosition> contacts;  ///< At the end.
};

InsertionToItsEnd runWith(const std::string& stopForce_N, const std::string& stopTravel_mm)
{
  const auto scenario = session::loadScenario("surgery-flex28", {{"nodes", "30"},
                                                                 {"dt_ms", "10.0"},
                                                                 {"speed_mm_s", "2.0"},
                                                                 {"stop_travel_mm", stopTravel_mm},
                                                                 {"stop_force_N", stopForce_N}});
  EXPECT_TRUE(scenario) << scenario.error().message;
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      std::nullopt);
  EXPECT_TRUE(insertion) << insertion.error().message;
  const auto simulated = simulate(**insertion, [](const haptics::TickRecord&) { return true; });
  EXPECT_TRUE(simulated) << simulated.error().message;
  (*insertion)->refresh();
  return {*simulated,
          contactPositions((*insertion)->anatomy(), scenario->array(), (*insertion)->latest())};
}

TEST(AnInsertionAboveTheGreatestStop, StatesWhereOneThatStopsThereEnds)
{
  const auto hand = shippedHand();
  ASSERT_TRUE(hand) << hand.error().message;
  const InsertionToItsEnd whole = runWith("0.0", "26.0");
  const InsertionToItsEnd stopped = runWith(std::to_string(hand->stopHigh.si()), "26.0");
  ASSERT_EQ(haptics::endOf(stopped.simulated.last), haptics::InsertionEnd::stoppedByResistance);
  ASSERT_TRUE(whole.simulated.passedStop);
  const PassedStop& passed = *whole.simulated.passedStop;
  EXPECT_EQ(passed.stop.si(), hand->stopHigh.si());
  // the same ticks up to the one that ends it
  EXPECT_EQ(passed.depth.si(), stopped.simulated.last.depth);
  EXPECT_LT(passed.depth.si(), whole.simulated.last.depth);
  EXPECT_EQ(passed.apical.si(), angularInsertionDepth(stopped.contacts).si());
  EXPECT_EQ(passed.contacts, stopped.contacts.size());
  std::size_t inside = 0;
  for (const ContactPosition& each : stopped.contacts) inside += each.depth.si() > 0.0 ? 1 : 0;
  EXPECT_EQ(passed.inside, inside);
  EXPECT_FALSE(stopped.simulated.passedStop);  // its hand stops
}

TEST(AnInsertionBelowTheGreatestStop, PassesNone)
{
  EXPECT_FALSE(runWith("0.0", "4.0").simulated.passedStop);
}

}  // namespace
}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/SyntheticPlan.h"

#include "perilymph/planning/PlanSummary.h"

namespace perilymph::test {

anatomy::Patient measuredPatient()
{
  anatomy::Patient patient;
  patient.label = "P-17";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.2), millimeters(6.8), millimeters(4.0)};
  patient.errors = anatomy::BasalTurnErrors{millimeters(0.1), millimeters(0.2), millimeters(0.3)};
  return patient;
}

std::vector<planning::PlannedInsertion> syntheticInsertions(std::size_t draws)
{
  std::vector<planning::PlannedInsertion> all;
  for (std::size_t draw = 1; draw <= draws; ++draw)
    for (std::size_t array = 0; array < 2; ++array) {
      const auto number = static_cast<double>(draw);
      planning::PlannedInsertion one;
      one.draw = draw;
      one.array = array;
      one.a_mm = 9.0 + number / 1000.0;
      one.b_mm = draw % 2 == 0 ? 6.7 : 6.9;
      analysis::ClinicalInsertion& found = one.insertion;
      found.end = draw % 4 == 0 ? haptics::InsertionEnd::stoppedByResistance
                                : haptics::InsertionEnd::finished;
      found.isRuptured = draw % 10 == 0;
      found.apical = degrees(array == 0 ? 300.0 + number : 500.0);
      found.depth = millimeters(20.0);
      found.peak = millinewtons(number);
      found.partition = millinewtons(number);
      found.endForce = millinewtons(0.5 * number);
      found.forceAfter1s = millinewtons(0.25 * number);
      for (const double depth_mm : {0.0, 0.5, 1.0})
        found.profile.push_back({millimeters(depth_mm), millinewtons(number)});
      if (array == 0 && draw <= 10)
        found.profile.push_back({millimeters(1.5), millinewtons(number)});
      analysis::ContactPosition apical, basal;
      apical.number = 1;
      apical.isInserted = true;
      apical.angle = found.apical;
      apical.coverage = 0.5;
      apical.toModiolus = millimeters(1.0);
      basal.number = 2;
      basal.isInserted = draw % 2 == 1;
      basal.angle = degrees(90.0);
      found.contacts = {apical, basal};
      all.push_back(one);
    }
  return all;
}

planning::Thresholds publishedThresholds()
{
  return {millinewtons(20.4), millinewtons(42.0), millinewtons(122.0)};
}

std::vector<planning::PlannedArray> plannedArrays()
{
  return {{"FLEX24", {100.0, 200.0}}, {"FLEX28", {}}};
}

planning::Plan syntheticPlan(std::size_t draws)
{
  planning::Plan plan;
  plan.request.patient = measuredPatient();
  plan.request.arrays = {"flex24", "flex28"};
  plan.fingerprint = "0123";
  plan.insertions = syntheticInsertions(draws);
  plan.thresholds = publishedThresholds();
  plan.friction = {0.12, 0.12};
  planning::addSummary(plan, plannedArrays());
  return plan;
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// What the bands of a plan are worth: virtual patients are measured with errors, planned, and
// inserted. How often does the 90 % band hold what the true cochlea, hand and array give?

#include <gtest/gtest.h>

#include <iostream>
#include <stop_token>

#include "PlanSetup.h"
#include "TruePatient.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::test {
namespace {

// Seeds of the README's table alone, first run after the distributions were fixed.
constexpr std::uint64_t seedOfTruths = 8'210'001, seedOfLuck = 8'220'002, seedOfPlans = 8'230'003;

planning::PlanRequest requestFor(const anatomy::Patient& patient, std::uint64_t number)
{
  planning::PlanRequest request;
  request.patient = patient;
  request.arrays = {"flex28"};
  request.draws = COVERAGE_DRAWS;
  request.stopsEarly = false;
  request.seed = seedOfPlans + number;
  // the same for plan and truth, so that it does not matter to the coverage
  request.resolution = planning::Resolution{40, milliseconds(10)};
  return request;
}

/// The true insertion: cochlea of another family; hand, friction, stiffness and approach as fate has it.
Result<analysis::ClinicalInsertion> insertTruly(const planning::PlanRequest& request,
                                                const TruePatient& patient, std::uint64_t number)
{
  const auto setup = planning::preparePlan(request);
  if (!setup) return setup.error();
  const planning::PlanDraw luck =
      planning::drawPlan(patient.measured, setup->uncertainty, setup->hand, seedOfLuck, number,
                         setup->nominal.front().parameters.frictionSpread);
  const planning::Nominal& nominal = setup->nominal.front();
  const auto parameters = planning::drawnParameters(
      nominal.parameters, luck, planning::stiffnessFactor(luck, nominal.stiffnessDeviation),
      request.resolution);
  return analysis::insertByHand(parameters, patient.anatomy, setup->hand, luck.surgeon,
                                planning::bandSpacing, {});
}

/// Counts of one quantity.
struct Coverage {
  const char* name;
  int inside = 0, below = 0, above = 0;

  /// A truth at the edge of the band is inside: forces on the partition are often zero in both.
  void take(double truth, const planning::Band& band)
  {
    if (truth < band.low)
      ++below;
    else if (truth > band.high)
      ++above;
    else
      ++inside;
  }
};

TEST(Truth, IsMeasuredWithTheStatedErrors)
{
  double squares = 0.0;
  constexpr int count = 4;
  for (std::uint64_t i = 1; i <= count; ++i) {
    const auto patient = truePatient(seedOfTruths, i);
    ASSERT_TRUE(patient) << patient.error().message;
    const double off =
        (patient->measured.basalTurn->a - patient->truth.a) / patient->measured.errors->a;
    squares += off * off;
    EXPECT_GT(patient->truth.a, anatomy::spreadOfA().low);
    EXPECT_LT(patient->truth.a, anatomy::spreadOfA().high);
    EXPECT_GT(patient->truth.b, anatomy::spreadOfB().low);
    EXPECT_LT(patient->truth.b, anatomy::spreadOfB().high);
    EXPECT_GT(*patient->truth.h, anatomy::limitsOfH().low);
    EXPECT_LT(*patient->truth.h, anatomy::limitsOfH().high);
  }
  // chi-square with 4 degrees of freedom: 0.09 to 18.5 with 99.8 %
  EXPECT_GT(squares, 0.09);
  EXPECT_LT(squares, 18.5);
}

TEST(Bands, AreComparedWithTheTruthInEveryPatient)
{
  Coverage angle{"angle"}, peak{"peak force"}, partition{"partition force"};
  int withoutPartition = 0;
  std::cout << "patient,end,angle_deg,low,median,high,peak_mN,low,median,high,partition_mN,low,"
               "median,high\n";
  for (std::uint64_t i = 1; i <= COVERAGE_PATIENTS; ++i) {
    const auto patient = truePatient(seedOfTruths, i);
    ASSERT_TRUE(patient) << patient.error().message;
    const auto request = requestFor(patient->measured, i);
    const auto plan = planning::makePlan(request, {}, {});
    ASSERT_TRUE(plan) << i << ": " << plan.error().message;
    const auto truth = insertTruly(request, *patient, i);
    ASSERT_TRUE(truth) << i << ": " << truth.error().message;
    ASSERT_NE(truth->end, haptics::InsertionEnd::refused) << i << ": " << truth->reason;
    const planning::ArrayPlan& array = plan->arrays.front();
    const double angle_deg = inDegrees(truth->apical), peak_mN = inMillinewtons(truth->peak),
                 partition_mN = inMillinewtons(truth->partition);
    angle.take(angle_deg, array.angle_deg);
    peak.take(peak_mN, array.peak_mN);
    partition.take(partition_mN, array.partition_mN);
    withoutPartition += partition_mN == 0.0 ? 1 : 0;
    std::cout << i << ',' << haptics::nameOf(truth->end);
    const auto print = [](double value, const planning::Band& band) {
      std::cout << ',' << value << ',' << band.low << ',' << band.median << ',' << band.high;
    };
    print(angle_deg, array.angle_deg);
    print(peak_mN, array.peak_mN);
    print(partition_mN, array.partition_mN);
    std::cout << std::endl;
  }
  for (const Coverage* each : {&angle, &peak, &partition}) {
    const auto estimate = analysis::proportionOf(static_cast<std::size_t>(each->inside),
                                                 static_cast<std::size_t>(COVERAGE_PATIENTS));
    std::cout << each->name << ": inside " << 100.0 * estimate.value << " % ("
              << 100.0 * estimate.low << " to " << 100.0 * estimate.high << "), below "
              << each->below << ", above " << each->above << '\n';
    EXPECT_EQ(each->inside + each->below + each->above, COVERAGE_PATIENTS);
  }
  std::cout << "truths without force on the partition: " << withoutPartition << '\n';
}

}  // namespace
}  // namespace perilymph::test

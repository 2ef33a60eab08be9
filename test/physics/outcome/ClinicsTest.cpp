// SPDX-License-Identifier: BSD-3-Clause

// What a clinic's resistance is worth: virtual clinics of 5, 20 and 100 patients. How often does the 90 %
// band of the depth hold the length measured, each patient predicted from those before him?
//
// In the right world, cochleae of another family and hands of their own: the mean coverage over the clinics
// must be 85 to 95 %. In wrong worlds it may be at most three points below that of the shipped prior.
//
// None of this is accuracy in patients: truth and plan share the model of the insertion.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include "VirtualClinics.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::test {
namespace {

constexpr std::uint64_t seedOfClinics = CLINIC_SEED + 40'004;
/// Counts as a table's number where there are enough clinics; few are run to see that all works.
constexpr std::size_t fewestClinics = 50;

const Pool& pool()
{
  static const Result<Pool> made =
      makePool({CLINIC_POOL_PATIENTS, CLINIC_POOL_DRAWS, CLINIC_POOL_TRUTHS});
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

/// Means over clinics.
struct Coverage {
  double clinic = 0.0;  ///< By the clinic's resistance, offered or not.
  double asOffered =
      0.0;               ///< By the clinic's where it was offered before the surgery, else shipped.
  double shipped = 0.0;  ///< By the shipped prior.
  double frictionError = 0.0,
         stopError = 0.0;  ///< Root mean square of the posterior means' errors.
  double gain = 0.0;       ///< ln p_clinic - ln p_shipped a patient.
  std::size_t offered = 0, resisted = 0, censored = 0, uninformative = 0;
};

bool isInside(double percentile) { return percentile >= 0.05 && percentile <= 0.95; }

Coverage coverageOf(World world, std::size_t patients)
{
  Coverage mean;
  for (std::uint64_t number = 1; number <= CLINICS; ++number) {
    const ClinicRun run = runClinic(pool(), world, patients, seedOfClinics, number);
    EXPECT_EQ(run.scores.size(), patients);
    for (const outcome::ResistanceScore& each : run.scores) {
      const double share = 1.0 / static_cast<double>(CLINICS * patients);
      mean.clinic += isInside(each.percentile) ? share : 0.0;
      mean.shipped += isInside(each.shippedPercentile) ? share : 0.0;
      mean.asOffered +=
          isInside(each.isOffered ? each.percentile : each.shippedPercentile) ? share : 0.0;
      mean.gain += share * (each.logClinic - each.logShipped);
    }
    const double f = run.meanFrictionShift - run.frictionShift,
                 g = run.meanStopShift - run.stopShift;
    mean.frictionError += f * f / static_cast<double>(CLINICS);
    mean.stopError += g * g / static_cast<double>(CLINICS);
    mean.offered += run.isOffered ? 1 : 0;
    mean.resisted += run.resisted;
    mean.censored += run.censored;
    mean.uninformative += run.uninformative;
  }
  mean.frictionError = std::sqrt(mean.frictionError);
  mean.stopError = std::sqrt(mean.stopError);
  return mean;
}

void print(const char* world, std::size_t patients, const Coverage& found)
{
  std::cout << world << ',' << patients << ',' << CLINICS << ',' << 100.0 * found.clinic << ','
            << 100.0 * found.asOffered << ',' << 100.0 * found.shipped << ',' << found.offered
            << ',' << found.gain << ',' << found.frictionError << ',' << found.stopError << ','
            << found.resisted << ',' << found.censored << ',' << found.uninformative << std::endl;
}

struct NamedWorld {
  World world;
  const char* name;
};
constexpr std::array worlds{NamedWorld{World::right, "right"},
                            NamedWorld{World::reasonsMissing, "half of the reasons missing"},
                            NamedWorld{World::stiffer, "1.5 times as stiff"},
                            NamedWorld{World::lengthsOff, "lengths 1.5 mm off"},
                            NamedWorld{World::stopAt120, "stop at 120 mN"}};

TEST(Clinics, AreCoveredInTheRightWorldAndNotMuchWorseInWrongOnes)
{
  std::cout << "world,patients,clinics,clinic_percent,as_offered_percent,shipped_percent,offered,"
               "gain_a_patient,rms_f,rms_g,resisted,censored,uninformative\n";
  for (const auto& [world, name] : worlds)
    for (const std::size_t patients : {5, 20, 100}) {
      const Coverage found = coverageOf(world, patients);
      print(name, patients, found);
      EXPECT_EQ(found.resisted + found.censored + found.uninformative, CLINICS * patients);
      if (CLINICS < fewestClinics) continue;
      if (world == World::right) {
        EXPECT_GE(found.clinic, 0.85) << name << ", " << patients;
        EXPECT_LE(found.clinic, 0.95) << name << ", " << patients;
      } else {
        EXPECT_GE(found.clinic, found.shipped - 0.03) << name << ", " << patients;
      }
    }
}

TEST(Clinics, LearnTheirShiftsFromManyPatients)
{
  // Shifts of the posterior beside the true ones: with 100 patients a clinic's length of stop is known
  // better than before, in the direction of both shifts that lengths tell, g - f.
  double before = 0.0, after = 0.0;
  for (std::uint64_t number = 1; number <= CLINICS; ++number) {
    const ClinicRun run = runClinic(pool(), World::right, 100, seedOfClinics, number);
    const double truth = run.stopShift - run.frictionShift;
    const double found = run.meanStopShift - run.meanFrictionShift;
    before += truth * truth;
    after += (found - truth) * (found - truth);
  }
  std::cout << "g - f: rms " << std::sqrt(before / CLINICS) << " before, "
            << std::sqrt(after / CLINICS) << " after 100 patients\n";
  EXPECT_LT(after, before);
}

}  // namespace
}  // namespace perilymph::test

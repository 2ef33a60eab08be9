// SPDX-License-Identifier: BSD-3-Clause
#include "Refusal.h"

#include <cmath>
#include <utility>

#include "LumenProfile.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

// Misfits of phantoms and of ten real ears are up to 0.25.
constexpr double refusedMisfit = 0.42;

std::string percent(double fraction) { return std::to_string(std::lround(100.0 * fraction)); }

/// Metal near the fit, which explains it, or else the sentence given.
Error refusal(const CtVolume& volume, const FitResult& fit, Sentence otherwise)
{
  const double metal_mm3 = metalAround_mm3(volume, fit.state.pose);
  if (metal_mm3 < minMetal_mm3) return Error{std::move(otherwise)};
  return Error{
      "There is metal in or beside the cochlea (an implant?): %1 cubic millimeters are brighter "
      "than %2 HU and hide its wall. Take a CT from before the implantation.",
      std::lround(metal_mm3), metalLevel};
}

}  // namespace

Result<void> checkMisfit(const CtVolume& volume, const FitResult& fit)
{
  if (fit.misfit <= refusedMisfit) return {};
  return refusal(
      volume, fit,
      Sentence{"No cochlea of usual shape was found: the best fit leaves %1 % of the voxels "
               "near its wall unexplained, at most %2 % is allowed. Click into the "
               "cochlea; of a malformed or ossified one A, B and H do not apply.",
               percent(fit.misfit), percent(refusedMisfit)});
}

Result<void> checkClimb(const CtVolume& volume, const LumenShape& family, const FitResult& fit)
{
  if (climbs(family, fit.state.shape)) return {};
  return refusal(
      volume, fit,
      Sentence{"No cochlea of usual shape was found: the best fit falls from the base to "
               "the middle turn, where a cochlea climbs. Click into the cochlea; of a "
               "malformed or ossified one A, B and H do not apply."});
}

Result<void> checkDiameters(const CtVolume& volume, const FitResult& fit, double a_mm, double b_mm)
{
  const anatomy::Spread a = anatomy::spreadOfA(), b = anatomy::spreadOfB();
  const auto isBeyond = [](double value_mm, const anatomy::Spread& spread) {
    return value_mm < inMillimeters(spread.low) || value_mm > inMillimeters(spread.high);
  };
  if (!isBeyond(a_mm, a) && !isBeyond(b_mm, b)) return {};
  return refusal(
      volume, fit,
      Sentence{"The best fit has A %1 mm and B %2 mm; of 138 cochleae A was %3 mm to %4 mm and B "
               "%5 mm to %6 mm at four standard deviations. Click into the cochlea; of a malformed "
               "or ossified one A, B and H do not apply.",
               millimetersOf(a_mm), millimetersOf(b_mm), millimetersOf(inMillimeters(a.low)),
               millimetersOf(inMillimeters(a.high)), millimetersOf(inMillimeters(b.low)),
               millimetersOf(inMillimeters(b.high))});
}

}  // namespace perilymph::ct

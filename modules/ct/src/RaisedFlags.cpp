// SPDX-License-Identifier: BSD-3-Clause
#include "RaisedFlags.h"

#include <cmath>

#include "MarkConstraint.h"
#include "SeedSearch.h"
#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double coarseVoxel_mm = 0.65;
constexpr double poorMisfit = 0.30;
constexpr double sectionLimit_mm = 0.25, sectionMissing = 0.25;
// Ten ears and phantoms have up to 0.11, where air cells or the facial nerve touch the wall.
constexpr double basalGapLimit = 0.20;
constexpr double fullTurns = 2.15;
constexpr double unmeasuredLimit = 0.05;
constexpr double placedBy_mm = 0.5;  // standard deviation of a landmark that a person placed
constexpr double disagreementSds = 3.0;

bool isUnusual(double value_mm, const anatomy::Spread& spread)
{
  return std::fabs(value_mm - inMillimeters(spread.mean)) >
         2.0 * inMillimeters(spread.standardDeviation);
}

/// Standard deviation of the sum of two independent errors.
double together(double one, double other) { return std::sqrt(one * one + other * other); }

/// Whether A, B or H between two landmarks that a person placed differs from the fitted one.
bool disagrees(const CochleaMeasures& measures)
{
  const MarkedMeasures marked = measuresBetween(measures.marksByHand, measures.axis_P);
  const auto isOff = [](const std::optional<double>& value_mm, const Measure& fitted) {
    return value_mm &&
           std::fabs(*value_mm - fitted.value) >
               disagreementSds * together(fitted.sd(), together(placedBy_mm, placedBy_mm));
  };
  return isOff(marked.a, measures.a) || isOff(marked.b, measures.b) || isOff(marked.h, measures.h);
}

/// Distinguishes air from fluid by Hounsfield units: only this flag requires a scanner whose fluid
/// is within 400 of water. Ten ears had -760 to -910 and 30 to 150.
bool isAir(const CochleaMeasures& measures)
{
  constexpr double airBelow = -400.0;
  return measures.lumenLevel < airBelow;
}

/// The side that is known beside the winding: as the files state it, as told, from the other
/// cochlea, or from the middle of a volume that is as wide as a head.
bool isMirrored(const CochleaMeasures& measures, const FlagEvidence& evidence)
{
  const auto& stated = evidence.volume.provenance().side;
  if (stated && *stated != measures.side) return true;
  if (evidence.request.side) return *evidence.request.side != measures.side;
  std::optional<double> middle_P = midline_P(evidence.volume);
  if (measures.otherCochlea_P)
    middle_P = 0.5 * (measures.otherCochlea_P->x() + measures.center_P.x());
  if (!middle_P) return false;
  const bool isRight = measures.center_P.x() < *middle_P;
  return isRight != (measures.side == anatomy::Side::right);
}

}  // namespace

std::vector<Flag> raisedFlags(const CochleaMeasures& measures, const FlagEvidence& evidence)
{
  std::vector<Flag> flags;
  const auto raise = [&](Flag flag, bool isRaised) {
    if (isRaised) flags.push_back(flag);
  };
  const SectionCheck& sections = evidence.sections;
  raise(Flag::coarseVoxels, evidence.volume.spacing_mm().maxCoeff() > coarseVoxel_mm);
  raise(Flag::airInCochlea, isAir(measures));
  raise(Flag::mirrored, isMirrored(measures, evidence));
  raise(Flag::outsidePopulation, isUnusual(measures.a.value, anatomy::spreadOfA()) ||
                                     isUnusual(measures.b.value, anatomy::spreadOfB()));
  raise(Flag::poorFit, measures.misfit > poorMisfit);
  raise(Flag::sectionsDisagree,
        sections.rms_mm > sectionLimit_mm || sections.missing - sections.clipped > sectionMissing);
  raise(Flag::roundWindowUnsure, !evidence.window.isFound);
  raise(Flag::clipped, sections.clipped > 0.02 || evidence.lumen.unmeasured > unmeasuredLimit);
  raise(Flag::landmarkContradicted, evidence.isLandmarkContradicted);
  // Beyond the end of a short lumen there is nothing to judge.
  const bool isFullLength = evidence.lumen.turns >= fullTurns;
  const ModiolusFinding modiolus = evidence.lumen.modiolus;
  raise(Flag::fewTurns, !isFullLength);
  raise(Flag::cysticApex, isFullLength && modiolus == ModiolusFinding::absent);
  raise(Flag::apexNotJudged, isFullLength && modiolus == ModiolusFinding::notJudged);
  raise(Flag::wallWithoutContrast, evidence.lumen.basalGap >= basalGapLimit);
  raise(Flag::metal, evidence.lumen.metal_mm3 >= minMetal_mm3);
  raise(Flag::unusualProportions,
        anatomy::areOutOfProportion(millimeters(measures.a.value), millimeters(measures.b.value),
                                    millimeters(measures.h.value), millimeters(measures.b.sd()),
                                    millimeters(measures.h.sd())));
  raise(Flag::secondCochlea, measures.otherCochlea_P.has_value());
  raise(Flag::landmarksDisagree, disagrees(measures));
  raise(Flag::seriesInDoubt, evidence.volume.provenance().isInDoubt);
  return flags;
}

}  // namespace perilymph::ct

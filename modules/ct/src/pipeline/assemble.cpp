// SPDX-License-Identifier: BSD-3-Clause

// Third stage of the measurement: round window, measures with their errors, frame, wall, flags.

#include <algorithm>
#include <cmath>

#include "ErrorBars.h"
#include "LumenProfile.h"
#include "LumenWall.h"
#include "MeasuredGeometry.h"
#include "ModiolarSections.h"
#include "RaisedFlags.h"
#include "Refusal.h"
#include "RoundWindow.h"
#include "SeedSearch.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"
#include "pipeline/Pipeline.h"

namespace perilymph::ct {
namespace {

constexpr double axisError_deg = 3.0;  // compared with the frames of real ears and of phantoms

}  // namespace

Result<CochleaMeasures> Pipeline::measured(const FitResult& best, const FitResult& mirrored) const
{
  const FitState& state = best.state;
  const ShapedLumen lumen(family_, state.shape);
  RoundWindow window = findRoundWindow(volume_, lumen, state);
  if (const auto& click = request_.marks[Mark::roundWindow])
    window = withClick(window, state.pose.into_W(*click));
  CochleaMeasures measures;
  fillMeasures(family_, best, window, axis_W_, volume_.spacing_mm(), measures);
  if (const auto done = checkDiameters(volume_, best, measures.a.value, measures.b.value); !done)
    return done.error();
  const LumenWall wall = wallOf(lumen, 0.0);
  const ClinicalFrame frame = clinicalFrame(axis_W_, window.center_W);
  measures.axes_PW = state.pose.axes_PW * frame.axes_W;
  measures.axis_P = measures.axes_PW.col(2);
  measures.axisError_deg = axisError_deg;
  measures.center_P = state.pose.outOf_W(frame.origin_W);
  measures.roundWindow_P = state.pose.outOf_W(window.center_W);
  placeAnatomy(state.pose, measures);
  measures.side = state.pose.isRight() ? anatomy::Side::right : anatomy::Side::left;
  // A mirror image at another place is the other ear's, and tells nothing of this one.
  const bool isOther = (middleOf(mirrored) - middleOf(best)).norm() > anotherEar_mm;
  measures.handednessMargin = (isOther ? 1.0 : mirrored.misfit) - best.misfit;
  measures.boneLevel = state.bone;
  measures.lumenLevel = state.lumen;
  measures.blurInPlane_mm = state.blurInPlane;
  measures.blurAxial_mm = state.blurAxial;
  measures.misfit = best.misfit;
  measures.provenance = volume_.provenance();
  measures.marksByHand = request_.marks;
  addWall(wall, state.pose, measures);

  const SectionCheck check = checkSections(volume_, lumen, state);
  measures.sectionRms_mm = check.rms_mm;
  if (check.kinematic) {
    const double along = std::fabs(check.kinematic->direction.dot(axis_W_));
    const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
    measures.kinematicTilt_deg = inDegrees(radians(arcTangent(across, along)));
  }
  const LumenFindings findings = examineLumen(volume_, lumen, fit_, best);
  measures.turnsSeen = findings.turns;
  measures.otherCochlea_P = other_P_;
  measures.flags = raisedFlags(
      measures, {volume_, request_, check, findings, window,
                 contradicts(request_.marks, family_, state.pose, state.shape, axis_W_)});
  if (measures.noFullSpiral()) measures.cdlOc.reset();
  report(1.0);
  return measures;
}

}  // namespace perilymph::ct

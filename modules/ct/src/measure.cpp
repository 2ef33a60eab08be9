// SPDX-License-Identifier: BSD-3-Clause

// The measurement pipeline: levels, coarse search, fit, round window, measures.

#include <algorithm>
#include <cmath>
#include <utility>

#include "CoarseSearch.h"
#include "ErrorBars.h"
#include "ImageFit.h"
#include "LumenProfile.h"
#include "LumenWall.h"
#include "MarkConstraint.h"
#include "MeasuredGeometry.h"
#include "ModiolarSections.h"
#include "Padding.h"
#include "RaisedFlags.h"
#include "Refusal.h"
#include "Region.h"
#include "RoundWindow.h"
#include "SeedSearch.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double maxVoxel_mm = 1.0;
constexpr double hFirst_deg = 20.0;  // below this angle the vestibule opens into the lumen
constexpr double clickReach_mm =
    4.5;  // from a click in the cochlea to the center of its basal turn
constexpr double seedReach_mm = 2.9;
constexpr double regionRadius_mm = 11.5, levelRadius_mm = 6.5;
constexpr std::size_t seeds = 24, startsPerLevel = 6;
constexpr std::size_t fewVoxels = 3000, someVoxels = 8000, manyVoxels = 14000;

// Misfits of phantoms and of ten real ears are up to 0.25; starts without a cochlea mostly have 0.3
// and more.
constexpr double otherCochleaMisfit = 0.30;
// Weight of landmarks in the choice between starts: as much misfit as tells a cochlea from bone
// without one. Chosen.
constexpr double markWeight = 0.15;
// Landmarks that raise the misfit by more are contradicted by the voxels: those at their true places
// changed that of wrong fits of phantoms by -0.17 to +0.013.
constexpr double contradictedMisfit = 0.03;
// More than any misfit: a spiral that falls is the mirror image of one that climbs.
constexpr double fallingScore = 1.0;
constexpr double axisError_deg = 3.0;  // compared with the frames of real ears and of phantoms

Error canceled() { return Error{"The measurement was canceled."}; }

class Pipeline {
public:
  Pipeline(const CtVolume& volume, const MeasureRequest& request, const MeanLumen& mean)
      : volume_(volume),
        request_(request),
        family_(mean),
        points_(meanTemplate(family_)),
        fit_(family_, sliceNormal(volume), blurGuess(volume)),
        axis_W_(clinicalAxis_W(
            wallOf(ShapedLumen(family_, LumenShape::priorMean()), degrees(hFirst_deg).si())))
  {
  }

  Result<CochleaMeasures> run()
  {
    auto chosen = choose(std::nullopt);
    if (!chosen) return chosen.error();
    if (!request_.click_P) considerOther(*chosen);
    FitResult best = std::move(chosen->best);
    // The voxels are selected again each time, because the wall has moved.
    for (int round = 0; round < 4; ++round) {
      if (isStopped()) return canceled();
      const auto voxels =
          observe(volume_, family_, best.state, 1.3, round < 2 ? someVoxels : manyVoxels);
      const FitSettings settings = round == 0   ? FitSettings{Freedom::shape, 12, 0.4, 1.0}
                                   : round == 1 ? FitSettings{Freedom::everything, 12, 0.25, 1.0}
                                                : FitSettings{Freedom::everything, 16, 0.0, 1.0};
      best = fit_.run(best.state, voxels, settings);
      report(0.5 + 0.1 * round);
    }
    if (!request_.marks.isEmpty()) {
      FitResult corrected = steered(best, GrossError::possible);
      if (corrected.misfit > best.misfit + contradictedMisfit)
        corrected = steered(best, GrossError::excluded);
      best = std::move(corrected);
    }
    if (isStopped()) return canceled();
    if (const auto done = checkMisfit(volume_, best); !done) return done.error();
    if (const auto done = checkClimb(volume_, family_, best); !done) return done.error();
    return measured(best, chosen->mirrored);
  }

private:
  struct Start {
    Candidate candidate;
    double bone, lumen;
  };
  /// The best start after a short fit, and the best of the other handedness at any place.
  struct Choice {
    FitResult best, mirrored;
  };

  /// @param elsewhere_P  A cochlea that is found already; places near it are left out.
  Result<Choice> choose(const std::optional<Eigen::Vector3d>& elsewhere_P) const
  {
    const auto started = starts(elsewhere_P);
    if (!started) return started.error();
    Choice choice;
    if (const auto done = chooseStart(*started, choice.best, choice.mirrored); !done)
      return done.error();
    return choice;
  }

  static Eigen::Vector3d middleOf(const FitResult& fit)
  {
    return fit.state.pose.outOf_W({0.0, 0.0, 1.0});
  }

  /// Looks for a cochlea of the other winding in the rest of the volume, and takes it if the first
  /// one winds as in the ear that is not asked for. The winding tells the ears apart in a volume of
  /// any size.
  void considerOther(Choice& choice)
  {
    const bool isRight = choice.best.state.pose.isRight();
    if (request_.side && isRight == (*request_.side == anatomy::Side::right)) return;
    isQuiet_ = true;
    auto other = choose(middleOf(choice.best));
    isQuiet_ = false;
    if (!other || other->best.misfit > otherCochleaMisfit ||
        other->best.state.pose.isRight() == isRight)
      return;
    if (request_.side)
      choice = *std::move(other);
    else
      other_P_ = middleOf(other->best);
  }

  static Eigen::Vector3d sliceNormal(const CtVolume& volume)
  {
    // The slice normal is the axis with the largest spacing; for equal spacings the third.
    const Eigen::Vector3d spacing = volume.spacing_mm();
    Eigen::Index axis = 2;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (spacing[i] > 1.05 * spacing[axis]) axis = i;
    return volume.lpsFromIndex().block<3, 1>(0, axis).normalized();
  }

  static Eigen::Vector2d blurGuess(const CtVolume& volume)
  {
    const Eigen::Vector3d spacing = volume.spacing_mm();
    return {std::max(0.15, 0.6 * spacing.minCoeff()), std::max(0.17, 0.5 * spacing.maxCoeff())};
  }

  bool isStopped() const { return request_.stop.stop_requested(); }
  void report(double fraction) const
  {
    if (request_.onProgress && !isQuiet_) request_.onProgress(fraction);
  }

  /// Poses near one point, for every possible level of the lumen.
  void searchAt(const Eigen::Vector3d& place_P, double reach_mm, std::size_t count,
                std::vector<Start>& found) const
  {
    const Region region(volume_, place_P, regionRadius_mm);
    const Levels levels = findLevels(region, place_P, levelRadius_mm);
    for (const double lumen : levels.candidates)
      for (const Candidate& candidate : searchPoses(region, levels.bone, lumen, points_, place_P,
                                                    reach_mm, count, request_.stop))
        found.push_back({candidate, levels.bone, lumen});
  }

  /// Starts where round window, modiolus and apex were placed, at the levels of the best starts.
  void addMarkedStarts(std::vector<Start>& found) const
  {
    const std::vector<Start> searched = found;
    for (const bool isRight : {true, false})
      if (const auto pose = poseOf(request_.marks, family_, axis_W_, isRight))
        for (std::size_t i = 0; i < searched.size(); i += startsPerLevel)
          found.push_back(
              {{*pose, searched[i].candidate.score}, searched[i].bone, searched[i].lumen});
  }

  Result<std::vector<Start>> starts(const std::optional<Eigen::Vector3d>& elsewhere_P) const
  {
    std::vector<Start> found;
    if (request_.click_P) {
      if (!volume_.contains(*request_.click_P))
        return Error{
            "The point given lies outside the volume. Click into the cochlea, or give none and let "
            "the volume be searched."};
      searchAt(*request_.click_P, clickReach_mm, startsPerLevel, found);
      addMarkedStarts(found);
    } else {
      const auto places = findSeeds(volume_, elsewhere_P, seeds);
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (isStopped()) return canceled();
        searchAt(places[i], seedReach_mm, 2, found);
        report(0.3 * static_cast<double>(i + 1) / static_cast<double>(places.size()));
      }
    }
    if (isStopped()) return canceled();
    std::stable_sort(found.begin(), found.end(), [](const Start& a, const Start& b) {
      return a.candidate.score > b.candidate.score;
    });
    if (found.empty())
      return Error{
          "No bone with a hollow was found there: the volume is empty or shows no temporal bone. "
          "Choose another series, or click into the cochlea."};
    if (!request_.click_P && found.size() > 2 * startsPerLevel)
      found.resize(2 * startsPerLevel, found.front());
    return found;
  }

  struct Scored {
    FitResult fit;
    double score = 2.0;  ///< The misfit, more if the fit is far from the landmarks.
  };
  Scored scored(FitResult fit) const
  {
    const double off =
        disagreement(request_.marks, family_, fit.state.pose, fit.state.shape, axis_W_);
    const double score =
        fit.misfit + markWeight * off + (climbs(family_, fit.state.shape) ? 0.0 : fallingScore);
    return {std::move(fit), score};
  }

  /// Goes on with a finished fit under the constraints of the landmarks.
  FitResult steered(const FitResult& free, GrossError grossError) const
  {
    FitResult best = free;
    std::vector<double> precisions;
    for (int round = 0; round < 3; ++round) {
      // Floor and apex refer to the present wall; the precisions stay those of the free fit.
      auto marks =
          constraintsOf(request_.marks, family_, best.state.pose, best.state.shape, axis_W_);
      if (marks.empty() || isStopped()) return best;
      if (round == 0) {
        setPrecisions(marks, family_, free.state.pose, free.state.shape, free.posterior,
                      grossError);
        for (const MarkConstraint& mark : marks) precisions.push_back(mark.precision);
      }
      for (std::size_t i = 0; i < marks.size(); ++i) marks[i].precision = precisions[i];
      auto observations = observe(volume_, family_, best.state, 1.3, manyVoxels);
      observations.marks = std::move(marks);
      best = fit_.run(best.state, observations, {Freedom::everything, 16, 0.0, 1.0});
    }
    return best;
  }

  /// A short fit from every start; keeps the best, and the best of the other handedness.
  Result<Done> chooseStart(const std::vector<Start>& from, FitResult& best,
                           FitResult& mirrored) const
  {
    std::vector<Scored> results;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (isStopped()) return canceled();
      FitState state;
      state.pose = from[i].candidate.pose;
      state.bone = from[i].bone;
      state.lumen = from[i].lumen;
      const Eigen::Vector2d blur = blurGuess(volume_);
      state.blurInPlane = blur[0];
      state.blurAxial = blur[1];
      const auto voxels = observe(volume_, family_, state, 1.3, fewVoxels);
      if (voxels.voxels.size() < 200) continue;
      results.push_back(scored(fit_.run(state, voxels, {Freedom::poseAndSize, 12, 0.5, 1.0})));
      report(0.3 + 0.2 * static_cast<double>(i + 1) / static_cast<double>(from.size()));
    }
    std::stable_sort(results.begin(), results.end(),
                     [](const Scored& a, const Scored& b) { return a.score < b.score; });
    if (results.empty())
      return Error{
          "Too few voxels lie near the place given to measure a cochlea. Click into the cochlea, "
          "and "
          "take a series that shows all of it."};
    // The shape of the best few is fitted before one is selected.
    constexpr std::size_t finalists = 3;
    const bool isRight = results.front().fit.state.pose.isRight();
    Scored kept, keptMirrored;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const FitState& state = results[i].fit.state;
      const bool isOther = state.pose.isRight() != isRight;
      if (i >= finalists && !(isOther && keptMirrored.fit.misfit == 1.0)) continue;
      const auto voxels = observe(volume_, family_, state, 1.3, fewVoxels);
      Scored next = scored(fit_.run(state, voxels, {Freedom::shape, 8, 0.35, 1.0}));
      Scored& former = isOther ? keptMirrored : kept;
      if (next.score < former.score) former = std::move(next);
    }
    if (keptMirrored.score < kept.score) std::swap(kept, keptMirrored);
    best = std::move(kept.fit);
    mirrored = std::move(keptMirrored.fit);
    return Done{};
  }

  Result<CochleaMeasures> measured(const FitResult& best, const FitResult& mirrored) const
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

  const CtVolume& volume_;
  const MeasureRequest& request_;
  LumenShape family_;
  Template points_;
  ImageFit fit_;
  Eigen::Vector3d axis_W_;                  ///< The clinical axis.
  std::optional<Eigen::Vector3d> other_P_;  ///< In a second cochlea.
  bool isQuiet_ = false;                    ///< Progress is not reported.
};

}  // namespace

Result<CochleaMeasures> measureCochlea(const CtVolume& volume, const MeasureRequest& request)
{
  const double coarsest = volume.spacing_mm().maxCoeff();
  if (!(coarsest <= maxVoxel_mm))
    return Error{
        "A voxel is %1 mm long; at most 1.0 mm is allowed, and 0.6 mm or less is advised. Take a "
        "series with thinner slices.",
        std::to_string(coarsest).substr(0, 4)};
  const auto mean = MeanLumen::make();
  if (!mean) return mean.error();
  const auto marked = withPaddingMarked(volume, request.click_P);
  return Pipeline(marked ? *marked : volume, request, *mean).run();
}

}  // namespace perilymph::ct

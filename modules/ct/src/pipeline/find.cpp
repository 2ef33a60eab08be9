// SPDX-License-Identifier: BSD-3-Clause

// First stage of the measurement: where a cochlea lies, and how it is turned.

#include <algorithm>
#include <optional>
#include <utility>

#include "Pieces.h"
#include "Region.h"
#include "SeedSearch.h"
#include "pipeline/Pipeline.h"

namespace perilymph::ct {
namespace {

constexpr double clickReach_mm =
    4.5;  // from a click in the cochlea to the center of its basal turn
constexpr double seedReach_mm = 2.9;
constexpr double regionRadius_mm = 11.5, levelRadius_mm = 6.5;
constexpr std::size_t seeds = 24, startsPerLevel = 6;
constexpr std::size_t fewVoxels = 3000;

// Misfits of phantoms and of ten real ears are up to 0.25; starts without a cochlea mostly have 0.3
// and more.
constexpr double otherCochleaMisfit = 0.30;
// Weight of landmarks in the choice between starts: as much misfit as tells a cochlea from bone
// without one. Chosen.
constexpr double markWeight = 0.15;
// More than any misfit: a spiral that falls is the mirror image of one that climbs.
constexpr double fallingScore = 1.0;

}  // namespace

Result<Pipeline::Choice> Pipeline::choose(const std::optional<Eigen::Vector3d>& elsewhere_P) const
{
  const auto started = starts(elsewhere_P);
  if (!started) return started.error();
  return chooseStart(*started);
}

Result<std::vector<Pipeline::Start>> Pipeline::starts(
    const std::optional<Eigen::Vector3d>& elsewhere_P) const
{
  std::vector<Start> found;
  if (!request_.starts.empty()) {
    addGivenStarts(found);
  } else if (request_.click_P) {
    if (!volume_.contains(*request_.click_P))
      return Error{
          "The point given lies outside the volume. Click into the cochlea, or give none and let "
          "the volume be searched."};
    found = searchAt(*request_.click_P, clickReach_mm, startsPerLevel, Threads::all);
    addMarkedStarts(found);
  } else {
    const auto places = findSeeds(volume_, elsewhere_P, seeds);
    std::vector<std::vector<Start>> near(places.size());
    eachPiece(
        places.size(), Threads::all,
        [&](std::size_t i) { near[i] = searchAt(places[i], seedReach_mm, 2, Threads::one); },
        [&](std::size_t done) {
          report(0.3 * static_cast<double>(done) / static_cast<double>(places.size()));
        },
        request_.stop);
    for (const std::vector<Start>& each : near) found.insert(found.end(), each.begin(), each.end());
  }
  if (isStopped()) return canceled();
  std::stable_sort(found.begin(), found.end(), [](const Start& a, const Start& b) {
    return a.candidate.score > b.candidate.score;
  });
  if (found.empty())
    return Error{
        "No bone with a hollow was found there: the volume is empty or shows no temporal bone. "
        "Choose another series, or click into the cochlea."};
  if (!request_.click_P && request_.starts.empty() && found.size() > 2 * startsPerLevel)
    found.resize(2 * startsPerLevel, found.front());
  return found;
}

std::vector<Pipeline::Start> Pipeline::searchAt(const Eigen::Vector3d& place_P, double reach_mm,
                                                std::size_t count, Threads threads) const
{
  const Region region(volume_, place_P, regionRadius_mm);
  const Levels levels = findLevels(region, place_P, levelRadius_mm);
  std::vector<Start> found;
  for (const double lumen : levels.candidates)
    for (const Candidate& candidate : searchPoses(region, levels.bone, lumen, points_, place_P,
                                                  reach_mm, count, threads, request_.stop))
      found.push_back({candidate, levels.bone, lumen});
  return found;
}

void Pipeline::addMarkedStarts(std::vector<Start>& found) const
{
  const std::vector<Start> searched = found;
  for (const bool isRight : {true, false})
    if (const auto pose = poseOf(request_.marks, family_, axis_W_, isRight))
      for (std::size_t i = 0; i < searched.size(); i += startsPerLevel)
        found.push_back(
            {{*pose, searched[i].candidate.score}, searched[i].bone, searched[i].lumen});
}

void Pipeline::addGivenStarts(std::vector<Start>& found) const
{
  for (const CochleaStart& each : request_.starts) {
    Marks marks;
    marks[Mark::roundWindow] = each.roundWindow_P;
    marks[Mark::modiolus] = each.center_P;
    marks[Mark::apex] = each.apex_P;
    const auto pose = poseOf(marks, family_, axis_W_, each.side == anatomy::Side::right);
    if (!pose || !volume_.contains(each.center_P)) continue;
    const Region region(volume_, each.center_P, regionRadius_mm);
    const Levels levels = findLevels(region, each.center_P, levelRadius_mm);
    for (const double lumen : levels.candidates)
      found.push_back({{*pose, 0.0}, levels.bone, lumen});
  }
}

Result<Pipeline::Choice> Pipeline::chooseStart(const std::vector<Start>& from) const
{
  std::vector<std::optional<Scored>> fits(from.size());
  const auto fit = [&](std::size_t i) {
    FitState state;
    state.pose = from[i].candidate.pose;
    state.bone = from[i].bone;
    state.lumen = from[i].lumen;
    const Eigen::Vector2d blur = blurGuess(volume_);
    state.blurInPlane = blur[0];
    state.blurAxial = blur[1];
    const auto voxels = observe(volume_, family_, state, 1.3, fewVoxels, Threads::one);
    if (voxels.voxels.size() < 200) return;
    fits[i] = scored(fit_.run(state, voxels, {Freedom::poseAndSize, 12, 0.5, 1.0}, Threads::one));
  };
  eachPiece(
      from.size(), Threads::all, fit,
      [&](std::size_t done) {
        report(0.3 + 0.2 * static_cast<double>(done) / static_cast<double>(from.size()));
      },
      request_.stop);
  if (isStopped()) return canceled();
  std::vector<Scored> results;
  for (std::optional<Scored>& each : fits)
    if (each) results.push_back(*std::move(each));
  std::stable_sort(results.begin(), results.end(),
                   [](const Scored& a, const Scored& b) { return a.score < b.score; });
  if (results.empty())
    return Error{
        "Too few voxels lie near the place given to measure a cochlea. Click into the cochlea, "
        "and "
        "take a series that shows all of it."};
  // The shape of the best few is fitted before one is selected, and of the best of the other
  // handedness that can be fitted.
  constexpr std::size_t finalists = 3;
  const bool isRight = results.front().fit.state.pose.isRight();
  const auto isOther = [&](std::size_t i) {
    return results[i].fit.state.pose.isRight() != isRight;
  };
  const auto withShape = [&](std::size_t i, Threads threads) {
    const FitState& state = results[i].fit.state;
    const auto voxels = observe(volume_, family_, state, 1.3, fewVoxels, threads);
    return scored(fit_.run(state, voxels, {Freedom::shape, 8, 0.35, 1.0}, threads));
  };
  std::vector<std::size_t> chosen;
  bool hasOther = false;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (i >= finalists && (hasOther || !isOther(i))) continue;
    chosen.push_back(i);
    hasOther = hasOther || isOther(i);
  }
  std::vector<Scored> shaped(chosen.size());
  eachPiece(chosen.size(), Threads::all,
            [&](std::size_t k) { shaped[k] = withShape(chosen[k], Threads::one); });
  Scored kept, keptMirrored;
  const auto consider = [&](std::size_t i, Scored next) {
    Scored& former = isOther(i) ? keptMirrored : kept;
    if (next.score < former.score) former = std::move(next);
  };
  for (std::size_t k = 0; k < chosen.size(); ++k) consider(chosen[k], std::move(shaped[k]));
  for (std::size_t i = finalists; i < results.size() && keptMirrored.fit.misfit == 1.0; ++i)
    if (isOther(i) && std::find(chosen.begin(), chosen.end(), i) == chosen.end())
      consider(i, withShape(i, Threads::all));
  if (keptMirrored.score < kept.score) std::swap(kept, keptMirrored);
  return Choice{std::move(kept.fit), std::move(keptMirrored.fit)};
}

Pipeline::Scored Pipeline::scored(FitResult fit) const
{
  const double off =
      disagreement(request_.marks, family_, fit.state.pose, fit.state.shape, axis_W_);
  const double score =
      fit.misfit + markWeight * off + (climbs(family_, fit.state.shape) ? 0.0 : fallingScore);
  return {std::move(fit), score};
}

void Pipeline::considerOther(Choice& choice)
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

}  // namespace perilymph::ct

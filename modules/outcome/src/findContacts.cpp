// SPDX-License-Identifier: BSD-3-Clause

// The search for the contacts, stage by stage.

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "Assignment.h"
#include "EarFrame.h"
#include "FoundResults.h"
#include "MetalGrid.h"
#include "Refinement.h"
#include "Ridge.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

namespace {

using Eigen::Vector3d;

constexpr double fwhmOfSd = 2.3548;
constexpr double reach_mm = 15.0;
constexpr double singly = 1.15;  // pitch per FWHM from which contacts are seen singly
constexpr double chained =
    1.0;  // from which the chain of blobs is tried, below 2.5 beside the ridge
constexpr double ridged = 2.5;
constexpr double margin =
    25.0;  // of the cost to the second-best assignment, below which it is flagged
constexpr double fewestSeen = 0.75;
constexpr double coarsest_mm = 0.65;

double smallestPitch_mm(const electrode::ArrayDesign& array)
{
  std::vector<double> pitch;
  for (std::size_t i = 0; i + 1 < array.contactsFromTip.size(); ++i)
    pitch.push_back(inMillimeters(array.contactsFromTip[i + 1]) -
                    inMillimeters(array.contactsFromTip[i]));
  std::nth_element(pitch.begin(), pitch.begin() + static_cast<std::ptrdiff_t>(pitch.size() / 2),
                   pitch.end());
  return pitch[pitch.size() / 2];
}

/// Positions of all contacts of a chain: those that were not seen lie between or beyond the others.
std::vector<Vector3d> positionsOf(const Chain& chain, const std::vector<Candidate>& candidates,
                                  const electrode::ArrayDesign& array)
{
  std::vector<Vector3d> seen;
  std::vector<double> at;
  for (std::size_t i = 0; i < chain.candidate.size(); ++i)
    if (chain.candidate[i] >= 0) {
      seen.push_back(candidates[static_cast<std::size_t>(chain.candidate[i])].position_P);
      at.push_back(inMillimeters(array.contactsFromTip[i]));
    }
  std::vector<Vector3d> positions;
  for (const Length place : array.contactsFromTip) {
    const double x = inMillimeters(place);
    std::size_t k = 0;
    while (k + 2 < at.size() && at[k + 1] < x) ++k;
    positions.push_back(seen[k] + ((x - at[k]) / (at[k + 1] - at[k])) * (seen[k + 1] - seen[k]));
  }
  return positions;
}

/// The positions one contact further toward the tip (or the base): each takes the place of its neighbor, whose blob
/// it then explains, and the last one the place where the course goes on.
std::vector<Vector3d> shifted(const std::vector<Vector3d>& positions,
                              const electrode::ArrayDesign& array, bool towardTip)
{
  const std::size_t last = positions.size() - 1;
  const auto spacing = [&](std::size_t i) {
    return inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i]);
  };
  std::vector<Vector3d> moved(positions.size());
  for (std::size_t i = 0; i < last; ++i)
    moved[towardTip ? i + 1 : i] = positions[towardTip ? i : i + 1];
  if (towardTip)
    moved[0] = positions[0] + spacing(0) * (positions[0] - positions[1]).normalized();
  else
    moved[last] =
        positions[last] + spacing(last - 1) * (positions[last] - positions[last - 1]).normalized();
  return moved;
}

/// A point of the lead: where the array goes on beyond its most basal contact.
Vector3d leadAfter(const std::vector<Vector3d>& positions)
{
  const std::size_t last = positions.size() - 1;
  return positions[last] + 1.5 * (positions[last] - positions[last - 1]).normalized();
}

/// Points of a chain's course and of what lies a contact or two beyond both ends, half a millimeter apart.
void addCourse(const std::vector<Vector3d>& positions, const electrode::ArrayDesign& array,
               std::vector<Vector3d>& points)
{
  const std::vector<Vector3d> most = shifted(shifted(positions, array, true), array, true),
                              least = shifted(shifted(positions, array, false), array, false);
  std::vector<Vector3d> all(most.begin(), most.begin() + 2);
  all.insert(all.end(), positions.begin(), positions.end());
  all.insert(all.end(), least.end() - 2, least.end());
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const int parts = std::max(1, static_cast<int>(std::ceil((all[i + 1] - all[i]).norm() / 0.5)));
    for (int k = 0; k < parts; ++k)
      points.push_back(all[i] + (static_cast<double>(k) / parts) * (all[i + 1] - all[i]));
  }
}

/// The fit from the best start, shifted by contacts toward the tip or the base if the model explains the image
/// better so. The cost of the second-best above it is the evidence for the numbers of the contacts.
FittedChain bestFit(const ct::CtVolume& volume, const MetalGrid& grid, const Ear& ear,
                    const EarFrame& frame, const electrode::ArrayDesign& array,
                    const FittedChain& begin, const std::vector<std::vector<Vector3d>>& starts,
                    const RefinementSettings& settings, FoundEvidence& evidence)
{
  constexpr int maxShift = 3;
  const bool isHeld =
      std::find(settings.isFixed.begin(), settings.isFixed.end(), true) != settings.isFixed.end();
  // all are compared on the same voxels
  std::vector<Vector3d> courses_P;
  for (const std::vector<Vector3d>& start : starts) addCourse(start, array, courses_P);
  const std::vector<FitVoxel> voxels = voxelsNear(volume, frame, courses_P, begin.blurInPlane_mm);
  const auto fitAt = [&](const std::vector<Vector3d>& positions) {
    FittedChain start = begin;
    start.position_P = positions;
    start.position_P.push_back(leadAfter(positions));
    return refined(volume, grid, ear, voxels, array, start, settings);
  };
  const auto contactsOf = [](const FittedChain& fit) {
    return std::vector<Vector3d>(fit.position_P.begin(), fit.position_P.end() - 1);
  };
  std::vector<FittedChain> fits;
  for (const std::vector<Vector3d>& start : starts) {
    fits.push_back(fitAt(start));
    if (isHeld) continue;
    const FittedChain first = fits.back();
    for (const bool towardTip : {true, false}) {
      FittedChain last = first;
      for (int shift = 1; shift <= maxShift; ++shift) {
        FittedChain next = fitAt(shifted(contactsOf(last), array, towardTip));
        fits.push_back(next);
        if (next.cost >= last.cost) break;
        last = std::move(next);
      }
    }
  }
  const FittedChain best =
      *std::min_element(fits.begin(), fits.end(),
                        [](const FittedChain& a, const FittedChain& b) { return a.cost < b.cost; });
  evidence.shiftMargin = 1e9;
  const double half = 0.25 * inMillimeters(array.contactsFromTip[2] - array.contactsFromTip[0]);
  for (const FittedChain& fit : fits)
    if ((fit.position_P[0] - best.position_P[0]).norm() > half)
      evidence.shiftMargin = std::min(evidence.shiftMargin, fit.cost - best.cost);
  return best;
}

}  // namespace

bool FoundArray::has(Flag flag) const
{
  return std::find(flags.begin(), flags.end(), flag) != flags.end();
}

Result<FoundArray> findContacts(const ct::CtVolume& postoperative, const Ear& ear,
                                const ContactsRequest& request)
{
  const auto started = std::chrono::steady_clock::now();
  const electrode::ArrayDesign& array = request.array;
  if (array.contactsFromTip.size() < 4)
    return Error{
        "The array %1 has %2 contacts; 4 or more are needed. Choose an array with contacts.",
        array.name, std::to_string(array.contactsFromTip.size())};
  const auto report = [&](double part) {
    if (request.onProgress) request.onProgress(part);
  };
  const auto isStopped = [&] { return request.stop.stop_requested(); };
  const Error canceled{"The search for contacts was canceled."};

  const EarFrame frame(ear);
  const Vector3d spacing = postoperative.spacing_mm();
  const double blur = std::max(0.15, 0.6 * spacing.minCoeff()),
               blurAxial = std::max(0.15, 0.5 * spacing.maxCoeff());
  const MetalGrid grid = metalAround(postoperative, ear, frame, reach_mm, blur);
  report(0.2);
  if (isStopped()) return canceled;
  constexpr double minMetal_mm3 = 0.3;
  if (grid.aboveBone_mm3 < minMetal_mm3)
    return Error{
        "There is no array in this ear: %1 cubic millimeters of metal lie in or near the cochlea, "
        "at least 0.3 are expected. Choose a CT after surgery, and check the side.",
        std::to_string(grid.aboveBone_mm3).substr(0, 4)};

  const double pitch = smallestPitch_mm(array);
  const double fwhm = fwhmOfSd * std::cbrt(blur * blur * blurAxial);

  // contacts placed by hand are candidates of their own
  std::map<int, int> byHand;
  const auto withHands = [&](std::vector<Candidate> candidates) {
    byHand.clear();
    for (const auto& [number, position_P] : request.byHand) {
      std::erase_if(candidates, [&](const Candidate& each) {
        return (each.position_P - position_P).norm() < 0.4 * pitch;
      });
    }
    for (const auto& [number, position_P] : request.byHand) {
      byHand[number - 1] = static_cast<int>(candidates.size());
      candidates.push_back({position_P, 1.0, frame.placeOf(position_P)});
    }
    return candidates;
  };

  FoundEvidence evidence;
  int inChain = 0;  // contacts that have a candidate
  evidence.isSeenSingly = pitch > singly * fwhm;
  std::vector<std::vector<Vector3d>> starts;  // positions of all contacts
  std::vector<Candidate> candidates;
  Chain chain;
  if (pitch > chained * fwhm) {
    const double sigma = std::clamp(std::max(0.25 * pitch, 0.6 * blur), 0.12, 0.35);
    candidates = withHands(candidatesOf(blobsOf(grid, sigma), frame, array.contactsFromTip.size()));
    report(0.3);
    if (isStopped()) return canceled;
    chain = bestChain(candidates, grid, array, byHand, fwhm);
    inChain = static_cast<int>(std::count_if(chain.candidate.begin(), chain.candidate.end(),
                                             [](int each) { return each >= 0; }));
    if (3 * inChain >= static_cast<int>(array.contactsFromTip.size()))
      starts.push_back(positionsOf(chain, candidates, array));
  }
  const bool isChained = !starts.empty();
  const auto alongRidge = [&](const std::vector<Vector3d>& ridge, double at, double offset) {
    std::vector<Vector3d> positions;
    for (std::size_t i = 0; i < array.contactsFromTip.size(); ++i) {
      positions.push_back(alongPolyline(ridge, at));
      if (i + 1 == array.contactsFromTip.size()) break;
      // on the inner side of the bend contacts are nearer to each other than along the array
      const EarPlace place = frame.placeOf(positions.back());
      const double half = 0.5 * inMillimeters(array.sectionAt(array.contactsFromTip[i]).within);
      const double bend =
          place.isInside && place.angle > 0.0 ? 1.0 / std::max(1.0, place.radius_mm) : 0.0;
      at += inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i]) *
            (1.0 - offset * bend * half);
    }
    for (const auto& [number, position_P] : request.byHand)
      if (number >= 1 && static_cast<std::size_t>(number) <= positions.size())
        positions[static_cast<std::size_t>(number) - 1] = position_P;
    return positions;
  };
  report(0.4);
  if (isStopped()) return canceled;
  if (!isChained || pitch < ridged * fwhm ||
      inChain < static_cast<int>(array.contactsFromTip.size())) {
    const std::vector<Vector3d> ridge = ridgeOf(grid, frame);
    if (ridge.size() >= 10) {
      const double start = startOfRow(grid, ridge) + 0.5 * inMillimeters(array.contactLength);
      // how far they lie from the center line, and so how near to each other, is not known
      for (const double offset : {0.4 * contactOffset, contactOffset, 1.6 * contactOffset})
        starts.push_back(alongRidge(ridge, start, offset));
    }
  }
  if (starts.empty())
    return Error{
        "The contacts cannot be found: the metal in this ear forms no array's course. Place "
        "contacts by hand, or check side and array."};
  report(0.5);
  if (isStopped()) return canceled;

  FittedChain begin;
  begin.blurInPlane_mm = blur;
  begin.blurAxial_mm = blurAxial;
  RefinementSettings settings;
  settings.isSeenSingly = evidence.isSeenSingly;
  settings.isFixed.assign(array.contactsFromTip.size(), false);
  for (const auto& [number, position_P] : request.byHand)
    if (number >= 1 && static_cast<std::size_t>(number) <= settings.isFixed.size())
      settings.isFixed[static_cast<std::size_t>(number) - 1] = true;
  const FittedChain fitted =
      bestFit(postoperative, grid, ear, frame, array, begin, starts, settings, evidence);
  report(0.9);
  if (isStopped()) return canceled;

  // which contacts have a blob of their own, and which blobs have no contact
  for (std::size_t i = 0; i < array.contactsFromTip.size(); ++i) {
    double nearest = 1e9;
    for (const Candidate& each : candidates)
      nearest = std::min(nearest, (each.position_P - fitted.position_P[i]).norm());
    evidence.isSeen.push_back(nearest < 0.35 * pitch);
  }
  const auto seen =
      static_cast<std::size_t>(std::count(evidence.isSeen.begin(), evidence.isSeen.end(), true));
  evidence.areMissing = evidence.isSeenSingly && seen < evidence.isSeen.size();
  evidence.areManyMissing =
      evidence.isSeenSingly &&
      static_cast<double>(seen) < fewestSeen * static_cast<double>(evidence.isSeen.size());
  for (const Candidate& each : candidates) {
    if (each.strength < 0.6) continue;
    double nearest = 1e9;
    for (const Vector3d& position_P : fitted.position_P)
      nearest = std::min(nearest, (each.position_P - position_P).norm());
    if (nearest > 0.6 * pitch) ++evidence.unexplained;
  }
  evidence.isSecondNear = evidence.shiftMargin < margin;
  evidence.isCoarse = spacing.maxCoeff() > coarsest_mm;
  auto found = resultsOf(postoperative, ear, frame, request, fitted, settings.isFixed, evidence);
  if (!found) return found.error();
  found->seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  report(1.0);
  return found;
}

}  // namespace perilymph::outcome

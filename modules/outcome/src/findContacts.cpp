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
constexpr double singly = 1.15;    // pitch per FWHM from which contacts are looked for one by one
constexpr double merged = 0.85;    // below, never
constexpr double margin = 3.0;     // of the score to the second-best assignment, below which it is flagged
constexpr double fewestSeen = 0.75;
constexpr double coarsest_mm = 0.65;

double smallestPitch_mm(const electrode::ArrayDesign& array)
{
  std::vector<double> pitch;
  for (std::size_t i = 0; i + 1 < array.contactsFromTip.size(); ++i)
    pitch.push_back(inMillimeters(array.contactsFromTip[i + 1]) - inMillimeters(array.contactsFromTip[i]));
  std::nth_element(pitch.begin(), pitch.begin() + static_cast<std::ptrdiff_t>(pitch.size() / 2), pitch.end());
  return pitch[pitch.size() / 2];
}

/// Positions of all contacts of a chain: those that were not seen lie between or beyond the others.
std::vector<Vector3d> positionsOf(const Chain& chain, const std::vector<Candidate>& candidates, const electrode::ArrayDesign& array)
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

/// A point of the lead: where the array goes on beyond its most basal contact.
Vector3d leadAfter(const std::vector<Vector3d>& positions)
{
  const std::size_t last = positions.size() - 1;
  return positions[last] + 1.5 * (positions[last] - positions[last - 1]).normalized();
}

}  // namespace

bool FoundArray::has(Flag flag) const { return std::find(flags.begin(), flags.end(), flag) != flags.end(); }

Result<FoundArray> findContacts(const ct::CtVolume& postoperative, const Ear& ear, const ContactsRequest& request)
{
  const auto started = std::chrono::steady_clock::now();
  const electrode::ArrayDesign& array = request.array;
  if (array.contactsFromTip.size() < 4)
    return Error{"The array %1 has %2 contacts; 4 or more are needed. Choose an array with contacts.", array.name,
                 std::to_string(array.contactsFromTip.size())};
  const auto report = [&](double part) {
    if (request.onProgress) request.onProgress(part);
  };
  const auto isStopped = [&] { return request.stop.stop_requested(); };
  const Error canceled{"The search for contacts was canceled."};

  const EarFrame frame(ear);
  const MetalGrid grid = metalAround(postoperative, ear, reach_mm);
  report(0.2);
  if (isStopped()) return canceled;
  double metal_mm3 = 0.0;
  const auto bright = static_cast<float>(std::min(300.0, 0.3 * (grid.ceiling - grid.floor)));
  for (int k = 0; k < grid.size[2]; k += 1)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        if (grid.value[grid.index(i, j, k)] > bright && frame.placeOf(grid.at_P(i, j, k)).isNearDuct) metal_mm3 += std::pow(grid.step_mm, 3);
  constexpr double leastMetal_mm3 = 1.0;
  if (metal_mm3 < leastMetal_mm3)
    return Error{"There is no array in this ear: %1 cubic millimeters of metal lie in or near the cochlea, at least 1 is expected. Choose a CT after surgery, and check the side.",
                 std::to_string(metal_mm3).substr(0, 4)};

  const Vector3d spacing = postoperative.spacing_mm();
  const double blur = std::max(0.15, 0.6 * spacing.minCoeff()), blurAxial = std::max(0.15, 0.5 * spacing.maxCoeff());
  const double pitch = smallestPitch_mm(array);
  const double fwhm = fwhmOfSd * std::cbrt(blur * blur * blurAxial);

  // contacts placed by hand are candidates of their own
  std::map<int, int> byHand;
  const auto withHands = [&](std::vector<Candidate> candidates) {
    byHand.clear();
    for (const auto& [number, position_P] : request.byHand) {
      std::erase_if(candidates, [&](const Candidate& each) { return (each.position_P - position_P).norm() < 0.4 * pitch; });
    }
    for (const auto& [number, position_P] : request.byHand) {
      byHand[number - 1] = static_cast<int>(candidates.size());
      candidates.push_back({position_P, 1.0, frame.placeOf(position_P)});
    }
    return candidates;
  };

  FoundEvidence evidence;
  std::vector<Vector3d> positions;
  if (pitch > merged * fwhm) {
    const double sigma = std::clamp(0.6 * blur * (grid.ceiling < 1e8 ? 1.4 : 1.0), 0.12, 0.35);
    const std::vector<Candidate> candidates = withHands(candidatesOf(blobsOf(grid, sigma), frame, array.contactsFromTip.size()));
    report(0.4);
    if (isStopped()) return canceled;
    const Chain chain = bestChain(candidates, grid, array, byHand);
    if (!chain.candidate.empty()) {
      evidence.seen = static_cast<int>(std::count_if(chain.candidate.begin(), chain.candidate.end(), [](int each) { return each >= 0; }));
      const double part = static_cast<double>(evidence.seen) / static_cast<double>(chain.candidate.size());
      if (part >= (pitch > singly * fwhm ? 0.3 : 0.9)) {
        positions = positionsOf(chain, candidates, array);
        evidence.isSeenSingly = pitch > singly * fwhm || part >= 0.9;
        for (const int each : chain.candidate) evidence.isSeen.push_back(each >= 0);
        const int first = chain.candidate.front() >= 0 ? chain.candidate.front() : -1;
        const Chain second = bestChain(candidates, grid, array, byHand, first >= 0 ? candidates[static_cast<std::size_t>(first)].position_P : positions.front());
        evidence.margin = chain.score - second.score;
        evidence.isSecondNear = evidence.margin < margin;
        evidence.areMissing = part < 1.0;
        evidence.areManyMissing = part < fewestSeen;
        // bright places along the course that no contact explains
        for (std::size_t i = 0; i < candidates.size(); ++i) {
          if (std::find(chain.candidate.begin(), chain.candidate.end(), static_cast<int>(i)) != chain.candidate.end()) continue;
          if (candidates[i].strength < 0.6) continue;
          double nearest = 1e9;
          for (const Vector3d& each : positions) nearest = std::min(nearest, (each - candidates[i].position_P).norm());
          if (nearest > 0.6 * pitch) ++evidence.unexplained;
        }
      }
    }
  }
  if (positions.empty()) {
    evidence = {};
    evidence.isSeenSingly = false;
    const std::vector<Vector3d> ridge = ridgeOf(grid, frame);
    if (ridge.size() < 10)
      return Error{"The contacts cannot be found: the metal in this ear forms no array's course. Place contacts by hand, or check side and array."};
    const double start = startOfRow(grid, ridge) + 0.5 * inMillimeters(array.contactLength);
    for (const Length place : array.contactsFromTip)
      positions.push_back(alongPolyline(ridge, start + inMillimeters(place) - inMillimeters(array.contactsFromTip.front())));
    evidence.isSeen.assign(positions.size(), false);
    for (const auto& [number, position_P] : request.byHand)
      if (number >= 1 && static_cast<std::size_t>(number) <= positions.size()) positions[static_cast<std::size_t>(number) - 1] = position_P;
  }
  report(0.6);
  if (isStopped()) return canceled;

  FittedChain chain;
  chain.position_P = positions;
  chain.position_P.push_back(leadAfter(positions));
  chain.blurInPlane_mm = blur;
  chain.blurAxial_mm = blurAxial;
  RefinementSettings settings;
  settings.isSeenSingly = evidence.isSeenSingly;
  settings.isFixed.assign(positions.size(), false);
  for (const auto& [number, position_P] : request.byHand)
    if (number >= 1 && static_cast<std::size_t>(number) <= positions.size()) settings.isFixed[static_cast<std::size_t>(number) - 1] = true;
  chain = refined(postoperative, grid, ear, array, chain, settings);
  report(0.9);
  if (isStopped()) return canceled;
  evidence.largestVoxel_mm = spacing.maxCoeff();
  evidence.isCoarse = spacing.maxCoeff() > coarsest_mm;
  auto found = resultsOf(postoperative, ear, frame, request, chain, settings.isFixed, evidence);
  if (!found) return found.error();
  found->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  report(1.0);
  return found;
}

}  // namespace perilymph::outcome

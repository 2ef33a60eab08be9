// SPDX-License-Identifier: BSD-3-Clause
#include "Assignment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

namespace {

using Eigen::Vector3d;

// Weights of the chain's score, chosen on phantoms of the development seeds (module's README).
constexpr double rewardOfContact = 5.0, rewardFrom = 0.3, fullFrom = 0.6;
constexpr double costOfMissing = 3.5;
constexpr int maxMissing = 2;  // one after the other
constexpr double lengthSd = 0.10, lengthSdRelative = 0.05;
constexpr double costOfGap = 1.0, wirePart = 0.03;
constexpr double costOfTurnBack = 2.5;
constexpr double bendSd = 0.6;  // [rad], beyond that of the cochlea
constexpr double costOfMetalBeyond = 7.0, darkPart = 0.25, brightPart = 0.75;  // beyond the tip
constexpr double mergedPart =
    0.6;  // of the cost of a contact that was not seen, where there is metal
constexpr double weakest = 0.12;
constexpr std::size_t maxCandidates = 90;

double distanceOf(const electrode::ArrayDesign& array, std::size_t from, std::size_t to)
{
  return inMillimeters(array.contactsFromTip[to]) - inMillimeters(array.contactsFromTip[from]);
}

/// Radius of the course at two contacts: that of the turn inside, none before the opening [mm].
double radiusOf(const Candidate& a, const Candidate& b)
{
  constexpr double straight = 20.0, least = 0.5;
  if (!a.place.isInside || !b.place.isInside || a.place.angle <= 0.0 || b.place.angle <= 0.0)
    return straight;
  return std::max(least, 0.5 * (a.place.radius_mm + b.place.radius_mm));
}

/// Chord of an arc of a circle.
double chordOf(double arc, double radius)
{
  return 2.0 * radius * sineCosine(std::min(0.5 * arc / radius, 1.3)).sine;
}

struct Step {
  std::size_t to;
  double cost;
};

/// Brightness of the metal beyond the first contact of a chain, relative to it: of an array none.
double metalBeyond(const Candidate& first, const Candidate& second, const MetalGrid& grid,
                   double distance)
{
  const Vector3d along = (first.position_P - second.position_P).normalized();
  const Vector3d any = std::fabs(along.x()) < 0.7 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d side = along.cross(any).normalized(), other = along.cross(side);
  double most = grid.sample(grid.value, first.position_P + distance * along);
  constexpr int directions = 8;
  constexpr double spread = 0.45;  // the course may turn
  for (int i = 0; i < directions; ++i) {
    const SineCosine turn = sineCosine(2.0 * pi * i / directions);
    const Vector3d way = (along + spread * (turn.cosine * side + turn.sine * other)).normalized();
    most = std::max(most, grid.sample(grid.value, first.position_P + distance * way));
  }
  return most / std::max(1.0, grid.sample(grid.value, first.position_P));
}

/// The cost of a step of so many contacts from one candidate to another; nothing if it is impossible.
std::optional<double> costOfStep(const Candidate& a, const Candidate& b, const MetalGrid& grid,
                                 double arc, int missed)
{
  const Eigen::Vector3d step = b.position_P - a.position_P;
  const double length = step.norm();
  if (length < 0.55 * arc || length > 1.1 * arc + 0.3) return std::nullopt;
  // no array jumps to another turn
  constexpr double turnedFreely = 1.0, turnedPerArc = 1.5;
  const double radius = radiusOf(a, b);
  if (a.place.isInside && b.place.isInside &&
      std::fabs(a.place.angle - b.place.angle) >
          turnedFreely + turnedPerArc * arc / std::min(radius, 4.0))
    return std::nullopt;
  const double chord = chordOf(arc, radius);
  // the array lies nearer to the wall or to the axis than the turn's center
  const double sd = lengthSd + lengthSdRelative * arc + 0.5 * (arc - chord);
  const double off = (length - chord) / sd;
  double cost = std::min(6.0, 0.5 * off * off);
  // metal all along
  double least = 1e9;
  const int samples = std::max(2, static_cast<int>(std::ceil(length / 0.25)));
  for (int i = 1; i < samples; ++i)
    least = std::min(
        least, grid.sample(grid.value, a.position_P + (static_cast<double>(i) / samples) * step));
  const double typical = wirePart * std::max(1.0, 0.5 * (grid.sample(grid.value, a.position_P) +
                                                         grid.sample(grid.value, b.position_P)));
  if (least < typical) cost += costOfGap * (1.0 - least / typical);
  // contacts between the two that merge with others are not missed as much as those without metal
  if (missed > 0)
    cost -= costOfMissing * mergedPart * missed * std::min(1.0, least / (10.0 * typical));
  return cost;
}

/// From the tip toward the base the depth decreases, but for a folded tip.
bool isBack(const Candidate& a, const Candidate& b)
{
  return b.place.depth_mm > a.place.depth_mm + 0.1;
}

}  // namespace

std::vector<Candidate> candidatesOf(const std::vector<Blob>& blobs, const EarFrame& frame,
                                    std::size_t contacts)
{
  std::vector<Candidate> candidates;
  for (const Blob& blob : blobs) {
    const EarPlace place = frame.placeOf(blob.position_P);
    if (place.isNearDuct) candidates.push_back({blob.position_P, blob.strength, place});
    if (candidates.size() >= 4 * maxCandidates) break;
  }
  std::vector<double> strongest;
  for (const Candidate& each : candidates)
    if (strongest.size() < contacts) strongest.push_back(each.strength);
  if (strongest.empty()) return {};
  const double typical = strongest[strongest.size() / 2];
  std::vector<Candidate> kept;
  for (Candidate& each : candidates) {
    each.strength /= typical;
    if (each.strength >= weakest && kept.size() < maxCandidates) kept.push_back(each);
  }
  return kept;
}

Chain bestChain(const std::vector<Candidate>& candidates, const MetalGrid& grid,
                const electrode::ArrayDesign& array, const std::map<int, int>& byHand,
                double fwhm_mm)
{
  const std::size_t count = array.contactsFromTip.size(), places = candidates.size();
  Chain best;
  if (places < 2 || count < 2) return best;
  const auto gain = [&](std::size_t contact, std::size_t place) -> std::optional<double> {
    if (const auto fixed = byHand.find(static_cast<int>(contact));
        fixed != byHand.end() && fixed->second != static_cast<int>(place))
      return std::nullopt;
    for (const auto& [other, its] : byHand)
      if (its == static_cast<int>(place) && other != static_cast<int>(contact)) return std::nullopt;
    return rewardOfContact *
           (std::min(1.0, candidates[place].strength / fullFrom) - rewardFrom / fullFrom);
  };
  const auto missing = [&](std::size_t from,
                           std::size_t to) {  // contacts between two, that a person did not place
    for (std::size_t i = from + 1; i < to; ++i)
      if (byHand.contains(static_cast<int>(i))) return 1e6;
    return costOfMissing * static_cast<double>(to - from - 1);
  };
  constexpr double none = -1e9;
  struct State {
    double score = none;
    int before = -1;  // candidate before the pair's first
    int gapBefore = 0;
  };
  // state[gap - 1][contact][a * places + b]: contact at b, the one `gap` before it at a
  std::array<std::vector<std::vector<State>>, maxMissing + 1> states;
  for (auto& each : states) each.assign(count, std::vector<State>(places * places));
  // steps between candidates by the arc between two contacts
  std::vector<std::vector<Step>> steps(count * (maxMissing + 1) * places);
  const auto stepsOf = [&](std::size_t contact, std::size_t gap,
                           std::size_t from) -> std::vector<Step>& {
    return steps[(contact * (maxMissing + 1) + gap - 1) * places + from];
  };
  for (std::size_t contact = 0; contact < count; ++contact)
    for (std::size_t gap = 1; gap <= maxMissing + 1 && contact + gap < count; ++gap)
      for (std::size_t a = 0; a < places; ++a)
        for (std::size_t b = 0; b < places; ++b)
          if (a != b)
            if (const auto cost = costOfStep(candidates[a], candidates[b], grid,
                                             distanceOf(array, contact, contact + gap),
                                             static_cast<int>(gap) - 1))
              stepsOf(contact, gap, a).push_back({b, *cost});

  double found = none;
  std::size_t lastContact = 0, lastA = 0, lastB = 0, lastGap = 0;
  for (std::size_t contact = 0; contact < count; ++contact) {
    for (std::size_t gap = 1; gap <= maxMissing + 1 && gap <= contact; ++gap) {
      const std::size_t from = contact - gap;
      for (std::size_t a = 0; a < places; ++a) {
        const auto gainA = gain(from, a);
        if (!gainA) continue;
        for (const Step& step : stepsOf(from, gap, a)) {
          const auto gainB = gain(contact, step.to);
          if (!gainB) continue;
          State& state = states[gap - 1][contact][a * places + step.to];
          // it begins here, with some contacts before it that were not seen
          if (from <= maxMissing) {
            const double beyond = metalBeyond(candidates[a], candidates[step.to], grid,
                                              std::max(distanceOf(array, 0, 1), fwhm_mm));
            const double metal =
                std::clamp((beyond - darkPart) / (brightPart - darkPart), 0.0, 1.0);
            const double before =
                from == 0 ? costOfMetalBeyond * metal
                          : costOfMissing * static_cast<double>(from) * (1.0 - mergedPart * metal);
            const double start =
                *gainA + *gainB - step.cost - missing(from, contact) - before -
                (isBack(candidates[a], candidates[step.to]) ? costOfTurnBack : 0.0);
            bool isFixedBefore = false;
            for (std::size_t i = 0; i < from; ++i)
              isFixedBefore = isFixedBefore || byHand.contains(static_cast<int>(i));
            if (!isFixedBefore && start > state.score) state = {start, -1, 0};
          }
          // or it follows another pair
          const Eigen::Vector3d next =
              (candidates[step.to].position_P - candidates[a].position_P).normalized();
          for (std::size_t gapBefore = 1; gapBefore <= maxMissing + 1 && gapBefore <= from;
               ++gapBefore)
            for (std::size_t z = 0; z < places; ++z) {
              const State& former = states[gapBefore - 1][from][z * places + a];
              if (former.score <= none || z == step.to) continue;
              const Eigen::Vector3d last =
                  (candidates[a].position_P - candidates[z].position_P).normalized();
              const double bend = arcTangent(last.cross(next).norm(), last.dot(next));
              const double usual = 0.5 * (distanceOf(array, from - gapBefore, from) /
                                              radiusOf(candidates[z], candidates[a]) +
                                          distanceOf(array, from, contact) /
                                              radiusOf(candidates[a], candidates[step.to]));
              const double off = std::max(0.0, bend - usual) / bendSd;
              const double score = former.score + *gainB - step.cost - missing(from, contact) -
                                   std::min(4.0, 0.5 * off * off) -
                                   (isBack(candidates[z], candidates[a]) !=
                                            isBack(candidates[a], candidates[step.to])
                                        ? costOfTurnBack
                                        : 0.0);
              if (score > state.score)
                state = {score, static_cast<int>(z), static_cast<int>(gapBefore)};
            }
          // it ends here, with some contacts after it that were not seen
          bool isFixedAfter = false;
          for (std::size_t i = contact + 1; i < count; ++i)
            isFixedAfter = isFixedAfter || byHand.contains(static_cast<int>(i));
          const double end = state.score - costOfMissing * static_cast<double>(count - 1 - contact);
          if (!isFixedAfter && end > found) {
            found = end;
            lastContact = contact, lastA = a, lastB = step.to, lastGap = gap;
          }
        }
      }
    }
  }
  if (found <= none) return best;
  best.score = found;
  best.candidate.assign(count, -1);
  std::size_t contact = lastContact, a = lastA, b = lastB, gap = lastGap;
  for (;;) {
    best.candidate[contact] = static_cast<int>(b);
    best.candidate[contact - gap] = static_cast<int>(a);
    const State& state = states[gap - 1][contact][a * places + b];
    if (state.before < 0) break;
    contact -= gap;
    b = a;
    a = static_cast<std::size_t>(state.before);
    gap = static_cast<std::size_t>(state.gapBefore);
  }
  return best;
}

}  // namespace perilymph::outcome

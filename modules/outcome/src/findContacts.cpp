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
#include "Row.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

namespace {

using Eigen::Vector3d;

constexpr double fwhmOfSd = 2.3548;
constexpr double reach_mm = 15.0;
constexpr double singly = 1.15;  // pitch per FWHM from which contacts are seen singly
constexpr double chained =
    1.0;  // from which the chain of blobs is tried beside rows along the ridge
constexpr std::size_t rowsTried = 4;
constexpr double margin =
    25.0;  // of the cost to the second-best assignment, below which it is flagged
constexpr double fewestSeen = 0.75;
constexpr double coarsest_mm = 0.65;
constexpr double darkAmplitude = 0.25,
                 costOfDark = 60.0;  // part of the median; of a contact without metal
constexpr double costOfBeyond = 120.0, darkBeyond = 0.35,
                 brightBeyond = 0.75;  // parts of a contact's brightness
constexpr double
    costOfWall = 40.0,
    wall_mm = 0.3, wallFrom = 0.8,
    insideFrom_mm =
        2.0;  // of a contact in the bone; blur of its edge; part of bone from which it costs
constexpr double blursBeyond = 1.3,
                 gridBlur_mm = 0.1;  // full widths at half maximum; by interpolation
constexpr int maxShift = 2;          // numberings that are tried on both sides of a start
constexpr double besideTip = 0.3;    // [rad]: what lies that much less deep is not another turn
constexpr double leadSeen_mm = 0.4;
constexpr double minMended = 0.15;  // of a spacing, that three distances together are wrong
constexpr int maxMended = 3;
constexpr double sameCost = 3.0, samePlace_mm = 0.15;  // of two fits that are one
constexpr int roundsOfTrials = 15;
constexpr std::size_t finished = 4;
constexpr int beyondTip = 2;  // contacts: the fit sees what lies there

/// The upper one of an even number's two.
double medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double medianPitch_mm(const electrode::ArrayDesign& array)
{
  std::vector<double> pitch;
  for (std::size_t i = 0; i + 1 < array.contactsFromTip.size(); ++i)
    pitch.push_back(inMillimeters(array.contactsFromTip[i + 1]) -
                    inMillimeters(array.contactsFromTip[i]));
  return medianOf(std::move(pitch));
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

/// The course through contacts with points of the lead beyond the most basal one, as far as shifted() needs it.
std::vector<Vector3d> withLead(std::vector<Vector3d> positions, const MetalGrid& grid,
                               const electrode::ArrayDesign& array)
{
  const std::size_t count = positions.size();
  const double last =
      inMillimeters(array.contactsFromTip[count - 1] - array.contactsFromTip[count - 2]);
  const auto points = static_cast<int>(std::ceil((maxShift + 1) * last / leadStep_mm));
  for (const Vector3d& point :
       followed(grid, positions[count - 1], positions[count - 1] - positions[count - 2],
                leadStep_mm, points))
    positions.push_back(point);
  return positions;
}

/// What the courses of an array need of the ear.
struct Surroundings {
  const MetalGrid& grid;
  const EarFrame& frame;
  const electrode::ArrayDesign& array;
};

/// The place beyond a course's first contact at a distance: on the spiral that the first two follow about the axis of
/// the cochlea, or where the metal goes on, whichever is brighter.
Vector3d beyondFirst(const std::vector<Vector3d>& course, double distance,
                     const Surroundings& around)
{
  const auto& [grid, frame, array] = around;
  constexpr int legs = 3;
  const Vector3d metal =
      followed(grid, course[0], course[0] - course[1], distance / legs, legs).back();
  if (!frame.placeOf(course[0]).isInside || frame.placeOf(course[0]).angle < 0.5 * pi) return metal;
  constexpr double least_mm = 0.3, most_mm = 0.3;  // radius; change of radius and height
  const Vector3d first = 1e3 * frame.toW(course[0]), second = 1e3 * frame.toW(course[1]);
  const double radius = std::max(least_mm, first.head<2>().norm());
  const double change = std::clamp(radius - second.head<2>().norm(), -most_mm, most_mm),
               rise = std::clamp(first.z() - second.z(), -most_mm, most_mm);
  const double along =
      std::sqrt(std::max(0.0, distance * distance - change * change - rise * rise));
  const double sine = std::min(1.0, 0.5 * along / std::max(least_mm, radius + 0.5 * change));
  const double angle =
      arcTangent(first.y(), first.x()) + 2.0 * arcTangent(sine, std::sqrt(1.0 - sine * sine));
  const SineCosine turn = sineCosine(angle);
  const double next = std::max(least_mm, radius + change);
  const Vector3d spiral =
      frame.toP(1e-3 * Vector3d(next * turn.cosine, next * turn.sine, first.z() + rise));
  return grid.sample(grid.value, spiral) >= grid.sample(grid.value, metal) ? spiral : metal;
}

/// The course one contact further toward the tip (or the base): each contact takes the place of its neighbor, whose
/// blob it then explains, and the last one the place where the course goes on.
std::vector<Vector3d> shifted(const std::vector<Vector3d>& course, const Surroundings& around,
                              bool towardTip)
{
  const electrode::ArrayDesign& array = around.array;
  const std::size_t count = array.contactsFromTip.size();
  const auto spacing = [&](std::size_t i) {
    return inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i]);
  };
  const std::vector<Vector3d> basal(course.begin() + static_cast<std::ptrdiff_t>(count) - 2,
                                    course.end());
  const double last = spacing(count - 2), from = (basal[1] - basal[0]).norm();
  std::vector<Vector3d> moved;
  if (towardTip) moved.push_back(beyondFirst(course, spacing(0), around));
  for (std::size_t i = towardTip ? 0 : 1; moved.size() < count - (towardTip ? 0 : 1); ++i)
    moved.push_back(course[i]);
  if (!towardTip) moved.push_back(alongPolyline(basal, from + last));
  for (std::size_t i = 1; moved.size() < course.size(); ++i)
    moved.push_back(alongPolyline(
        basal, (towardTip ? 0.0 : from + last) + static_cast<double>(i) * leadStep_mm));
  return moved;
}

/// The courses in which a part of the array moves by one contact to where the fit's distances say that it misses one,
/// or has one too many: between the contacts whose distance, with those beside it, is the most wrong.
std::vector<std::vector<Vector3d>> mended(const FittedChain& fit, const Surroundings& around)
{
  const electrode::ArrayDesign& array = around.array;
  const std::size_t count = array.contactsFromTip.size();
  std::size_t worst = 0;
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    double excess = 0.0;
    for (std::size_t k = i > 0 ? i - 1 : 0; k <= i + 1 && k + 1 < count; ++k)
      excess += fit.excess_mm[k];
    const double spacing = inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i]);
    if (std::fabs(excess) / spacing > std::fabs(most)) most = excess / spacing, worst = i;
  }
  if (std::fabs(most) < minMended) return {};
  const std::vector<Vector3d>& course = fit.position_P;
  const std::vector<Vector3d> tipward = shifted(course, around, true),
                              baseward = shifted(course, around, false);
  std::vector<Vector3d> apical = course, basal = course;
  for (std::size_t i = 0; i < course.size(); ++i)
    if (i <= worst)
      apical[i] = most < 0.0 ? tipward[i] : baseward[i];
    else
      basal[i] = most < 0.0 ? baseward[i] : tipward[i];
  if (most > 0.0) {
    const Vector3d middle = 0.5 * (course[worst] + course[worst + 1]);
    apical[worst] = middle;
    basal[worst + 1] = middle;
  }
  return {apical, basal};
}

/// Points from two contacts beyond a course's tip to the first of its lead, half a millimeter apart. Beyond that the
/// lead bends as it likes, which tells nothing about the numbers.
std::vector<Vector3d> pointsOf(const std::vector<Vector3d>& course, const Surroundings& around)
{
  const electrode::ArrayDesign& array = around.array;
  std::vector<Vector3d> before = course;
  for (int i = 0; i < beyondTip; ++i) before = shifted(before, around, true);
  std::vector<Vector3d> all(before.begin(), before.begin() + beyondTip);
  all.insert(all.end(), course.begin(),
             course.begin() + static_cast<std::ptrdiff_t>(array.contactsFromTip.size()) + 1);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const int parts = std::max(1, static_cast<int>(std::ceil((all[i + 1] - all[i]).norm() / 0.5)));
    for (int k = 0; k < parts; ++k)
      points.push_back(all[i] + (static_cast<double>(k) / parts) * (all[i + 1] - all[i]));
  }
  points.push_back(all.back());
  return points;
}

/// The points of several courses as far as those reach toward the base that end near the first of them.
std::vector<Vector3d> commonPoints(const std::vector<std::vector<Vector3d>>& courses,
                                   const Surroundings& around)
{
  const auto& [grid, frame, array] = around;
  const std::size_t last = array.contactsFromTip.size() - 1;
  const double first = frame.placeOf(courses.front()[last]).depth_mm;
  const double pitch = inMillimeters(array.contactsFromTip[last] - array.contactsFromTip[last - 1]);
  double least = first;
  for (const std::vector<Vector3d>& course : courses)
    if (const double depth = frame.placeOf(course[last]).depth_mm; depth > first - 1.5 * pitch)
      least = std::min(least, depth);
  least -= leadSeen_mm;
  std::vector<Vector3d> points;
  for (const std::vector<Vector3d>& course : courses)
    for (const Vector3d& point : pointsOf(course, around))
      if (frame.placeOf(point).depth_mm > least) points.push_back(point);
  return points;
}

/// What speaks against the numbers of a fit's contacts beside its cost: contacts without metal, contacts in the bone,
/// and metal that goes on beyond the apical contact, where an array ends. In units of the cost.
double costOfEnds(const FittedChain& fit, const MetalGrid& grid, const EarFrame& frame,
                  const electrode::ArrayDesign& array)
{
  const double dark = darkAmplitude * medianOf(fit.amplitude);
  double cost = 0.0;
  for (const double each : fit.amplitude)
    if (each < dark) cost += costOfDark * (1.0 - each / dark);
  for (std::size_t i = 0; i < fit.amplitude.size(); ++i)
    if (frame.placeOf(fit.position_P[i]).depth_mm > insideFrom_mm)
      cost += costOfWall *
              std::clamp((frame.bonePart(fit.position_P[i], wall_mm) - wallFrom) / (1.0 - wallFrom),
                         0.0, 1.0);
  const auto brightness = [&](const Vector3d& point_P) { return grid.sample(grid.value, point_P); };
  std::vector<double> seen;
  for (std::size_t i = 0; i < fit.amplitude.size(); ++i)
    seen.push_back(brightness(fit.position_P[i]));
  const double typical = std::max(1.0, medianOf(std::move(seen)));
  const Vector3d along = (fit.position_P[0] - fit.position_P[1]).normalized(),
                 side = along.unitOrthogonal(), other = along.cross(side);
  // the apical contact's own blur is no metal beyond it: as far as it can be told, and what is left of it
  const double length = inMillimeters(array.contactLength);
  const double own_mm = std::sqrt(std::pow(std::max(fit.blurInPlane_mm, fit.blurAxial_mm), 2) +
                                  length * length / 12.0 + gridBlur_mm * gridBlur_mm);
  const double distance =
      std::max(inMillimeters(array.contactsFromTip[1] - array.contactsFromTip[0]),
               blursBeyond * fwhmOfSd * own_mm);
  const double atCenter = fit.amplitude[0] / std::pow(2.0 * pi * own_mm * own_mm, 1.5);
  const double here = frame.placeOf(fit.position_P[0]).angle;
  double beyond = 0.0;
  for (const double part : {0.85, 1.0, 1.15})
    for (const double spread : {0.0, 0.25, 0.5})
      for (int i = 0; i < (spread > 0.0 ? 8 : 1); ++i) {
        const SineCosine turn = sineCosine(2.0 * pi * i / 8);
        const double far = part * distance;
        const Vector3d point =
            fit.position_P[0] +
            far * (along + spread * (turn.cosine * side + turn.sine * other)).normalized();
        if (frame.placeOf(point).angle > here - besideTip)
          beyond = std::max(beyond, brightness(point) - atCenter * exponential(-0.5 * far * far /
                                                                               (own_mm * own_mm)));
      }
  return cost +
         costOfBeyond *
             std::clamp((beyond / typical - darkBeyond) / (brightBeyond - darkBeyond), 0.0, 1.0);
}

bool isCheaper(const FittedChain& a, const FittedChain& b) { return a.cost < b.cost; }

/// The fit from the best start, shifted by contacts toward the tip or the base if the model explains the image
/// better so. The cost of the second-best above it is the evidence for the numbers of the contacts.
FittedChain bestFit(const ct::CtVolume& volume, const MetalGrid& grid, const Ear& ear,
                    const EarFrame& frame, const electrode::ArrayDesign& array,
                    const FittedChain& begin, const std::vector<std::vector<Vector3d>>& starts,
                    const RefinementSettings& settings, FoundEvidence& evidence)
{
  const Surroundings around{grid, frame, array};
  const bool isHeld =
      std::find(settings.isFixed.begin(), settings.isFixed.end(), true) != settings.isFixed.end();
  // all are compared on the same voxels
  std::vector<std::vector<Vector3d>> courses;
  for (const std::vector<Vector3d>& start : starts) courses.push_back(withLead(start, grid, array));
  const std::vector<FitVoxel> voxels =
      voxelsNear(volume, frame, commonPoints(courses, around), begin.blurInPlane_mm);
  std::vector<FittedChain> trials;
  const auto isKnown = [&](const FittedChain& fit) {
    const std::size_t last = array.contactsFromTip.size() - 1;
    return std::any_of(trials.begin(), trials.end(), [&](const FittedChain& each) {
      return std::fabs(each.cost - fit.cost) < sameCost &&
             (each.position_P[0] - fit.position_P[0]).norm() < samePlace_mm &&
             (each.position_P[last] - fit.position_P[last]).norm() < samePlace_mm;
    });
  };
  // fits from a course, unless it leads where another led
  const auto tried = [&](const std::vector<Vector3d>& course, int rounds) {
    FittedChain start = begin;
    start.position_P = course;
    RefinementSettings each = settings;
    each.rounds = rounds;
    FittedChain fit = refined(frame, volume, grid, ear, voxels, array, start, each);
    fit.cost += costOfEnds(fit, grid, frame, array);
    if (!isKnown(fit)) trials.push_back(std::move(fit));
  };
  const auto best = [&] { return *std::min_element(trials.begin(), trials.end(), isCheaper); };
  for (const std::vector<Vector3d>& course : courses) tried(course, roundsOfTrials);
  // the best one's numbers shifted, and what its distances say that is wrong
  for (int round = 0; round < maxMended && !isHeld; ++round) {
    const FittedChain before = best();
    for (const bool towardTip : {true, false}) {
      std::vector<Vector3d> course = before.position_P;
      for (int shift = 1; shift <= maxShift; ++shift) {
        course = shifted(course, around, towardTip);
        tried(course, roundsOfTrials);
      }
    }
    for (const std::vector<Vector3d>& course : mended(before, around))
      tried(course, roundsOfTrials);
    // its tip may have turned off
    std::vector<Vector3d> course = before.position_P;
    course[0] =
        beyondFirst({course.begin() + 1, course.end()},
                    inMillimeters(array.contactsFromTip[1] - array.contactsFromTip[0]), around);
    tried(course, roundsOfTrials);
    // its lead may have begun in the wrong place
    tried(withLead({before.position_P.begin(),
                    before.position_P.begin() +
                        static_cast<std::ptrdiff_t>(array.contactsFromTip.size())},
                   grid, array),
          roundsOfTrials);
    if (best().cost >= before.cost - sameCost) break;
  }
  // the cheapest, and the cheapest with other numbers, to the end
  std::sort(trials.begin(), trials.end(), isCheaper);
  std::vector<FittedChain> begun = trials;
  begun.resize(std::min<std::size_t>(begun.size(), finished));
  for (const FittedChain& trial : begun) tried(trial.position_P, settings.rounds);
  const FittedChain chosen = best();
  evidence.shiftMargin = 1e9;
  const double half = 0.25 * inMillimeters(array.contactsFromTip[2] - array.contactsFromTip[0]);
  for (const FittedChain& fit : trials)
    if ((fit.position_P[0] - chosen.position_P[0]).norm() > half)
      evidence.shiftMargin = std::min(evidence.shiftMargin, fit.cost - chosen.cost);
  // what was left out because not all numberings reach it
  FittedChain whole = begin;
  whole.position_P = chosen.position_P;
  return refined(
      frame, volume, grid, ear,
      voxelsNear(volume, frame, pointsOf(chosen.position_P, around), begin.blurInPlane_mm), array,
      whole, settings);
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

  const double pitch = medianPitch_mm(array);
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
  evidence.isSeenSingly = pitch > singly * fwhm;
  std::vector<std::vector<Vector3d>> starts;  // positions of all contacts
  std::vector<Candidate> candidates;
  // of a pair's plates one blob
  const bool isPair = array.platesOf(array.contactsFromTip.size() - 1) == electrode::Plates::pair;
  const double sigma = std::clamp(std::max(0.25 * pitch, 0.6 * blur), 0.12, isPair ? 0.5 : 0.35);
  if (pitch > chained * fwhm) {
    candidates = withHands(candidatesOf(blobsOf(grid, sigma), frame, array.contactsFromTip.size()));
    report(0.3);
    if (isStopped()) return canceled;
    const Chain chain = bestChain(candidates, grid, array, byHand, fwhm);
    const auto seen = std::count_if(chain.candidate.begin(), chain.candidate.end(),
                                    [](int each) { return each >= 0; });
    if (3 * seen >= static_cast<std::ptrdiff_t>(array.contactsFromTip.size()))
      starts.push_back(positionsOf(chain, candidates, array));
  }
  report(0.4);
  if (isStopped()) return canceled;
  const std::vector<Vector3d> ridge = ridgeOf(grid, frame);
  if (ridge.size() >= 10) {
    std::map<std::size_t, Vector3d> placed;
    for (const auto& [number, position_P] : request.byHand)
      placed[static_cast<std::size_t>(number) - 1] = position_P;
    for (std::vector<Vector3d>& row :
         rowsAlong(grid, contrastOf(grid, sigma), ridge, frame, array, fwhm, placed, rowsTried))
      starts.push_back(std::move(row));
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
  const double dark = darkAmplitude * medianOf(fitted.amplitude);
  const auto lit = static_cast<double>(std::count_if(
      fitted.amplitude.begin(), fitted.amplitude.end(), [&](double each) { return each >= dark; }));
  const auto all = static_cast<double>(fitted.amplitude.size());
  evidence.areMissing = evidence.isSeenSingly && lit < all;
  evidence.areManyMissing = evidence.isSeenSingly && lit < fewestSeen * all;
  // the lead, which has blobs as well, is no metal without a contact
  const double lead_mm =
      frame.placeOf(fitted.position_P[array.contactsFromTip.size() - 1]).depth_mm - 0.5 * pitch;
  for (const Candidate& each : candidates) {
    if (each.strength < 0.6 || each.place.depth_mm < lead_mm) continue;
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

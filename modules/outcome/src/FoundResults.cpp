// SPDX-License-Identifier: BSD-3-Clause
#include "FoundResults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/anatomy/ScalaVestibuli.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/planning/DefaultFilters.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::outcome {

std::array<double, 2> FoundContact::mismatch95_semitones() const
{
  if (filter_Hz <= 0.0) return {};
  return {analysis::semitones(filter_Hz, spiralGanglion_Hz[1]),
          analysis::semitones(filter_Hz, spiralGanglion_Hz[2])};
}

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Error of the model along each direction that the fit does not know [mm]: a constant and a part of a voxel.
// Calibrated on phantoms of the development seeds (module's README).
constexpr double modelConstant_mm = 0.03, modelPerVoxel = 0.20;
constexpr double handSd_mm = 0.2;       // of a contact that a person placed (choice)
constexpr double definition_deg = 2.5;  // 0 degrees: as in ct's errors
constexpr double definitionUnsure_deg = 15.0;
constexpr double partitionSd_mm =
    0.25;  // individual height of the membrane (choice, low confidence)
constexpr double earSd_mm = 0.10, earSdFromThisCt_mm = 0.25;  // of the fitted ear's height
constexpr double kinkPerMm = 1.6;              // curvature [1/mm]: a radius of 0.6 mm
constexpr double foldBack_mm = 0.6;            // by which the depth decreases toward the tip
constexpr double badLengths = 1.8;             // spacing errors in their standard deviations
constexpr double beyondWall_mm = 0.4;          // of a contact in the cochlea
constexpr double translocated = 0.8;           // probability from which a contact counts as above
constexpr std::size_t fewestTranslocated = 2;  // contacts that count, for the flag

/// A smooth course through the contacts, from the tip to the lead (centripetal Catmull-Rom), about 0.25 mm apart.
std::vector<Vector3d> courseThrough(std::vector<Vector3d> knots, double tip_mm)
{
  knots.insert(knots.begin(), knots[0] + tip_mm * (knots[0] - knots[1]).normalized());
  std::vector<Vector3d> course;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Vector3d &b = knots[i], &c = knots[i + 1];
    const Vector3d a = i > 0 ? knots[i - 1] : Vector3d(2.0 * b - c),
                   d = i + 2 < knots.size() ? knots[i + 2] : Vector3d(2.0 * c - b);
    const double t0 = 0.0, t1 = t0 + std::sqrt(std::max(1e-6, (b - a).norm())),
                 t2 = t1 + std::sqrt(std::max(1e-6, (c - b).norm())),
                 t3 = t2 + std::sqrt(std::max(1e-6, (d - c).norm()));
    const int parts = std::max(1, static_cast<int>(std::ceil((c - b).norm() / 0.25)));
    for (int s = 0; s < parts; ++s) {
      const double t = t1 + (t2 - t1) * s / parts;
      const Vector3d p = (t1 - t) / (t1 - t0) * a + (t - t0) / (t1 - t0) * b,
                     q = (t2 - t) / (t2 - t1) * b + (t - t1) / (t2 - t1) * c,
                     r = (t3 - t) / (t3 - t2) * c + (t - t2) / (t3 - t2) * d;
      const Vector3d u = (t2 - t) / (t2 - t0) * p + (t - t0) / (t2 - t0) * q,
                     v = (t3 - t) / (t3 - t1) * q + (t - t1) / (t3 - t1) * r;
      course.push_back((t2 - t) / (t2 - t1) * u + (t - t1) / (t2 - t1) * v);
    }
  }
  course.push_back(knots.back());
  return course;
}

/// Length of a course's curve from its start to the point nearest to another [mm].
double lengthTo(const std::vector<Vector3d>& course, const Vector3d& point)
{
  double gone = 0.0, best = 1e9, at = 0.0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (i > 0) gone += (course[i] - course[i - 1]).norm();
    if (const double d = (course[i] - point).norm(); d < best) best = d, at = gone;
  }
  return at;
}

}  // namespace

Result<FoundArray> resultsOf(const ct::CtVolume& volume, const Ear& ear, const EarFrame& frame,
                             const ContactsRequest& request, const FittedChain& chain,
                             const std::vector<bool>& isFixed, const FoundEvidence& evidence)
{
  const electrode::ArrayDesign& array = request.array;
  const std::size_t count = array.contactsFromTip.size();
  FoundArray found;
  found.array = request.arrayName;
  found.side = ear.measures.side;
  found.isRegistered = ear.isRegistered;
  found.residual_mm = ear.residual_mm;
  constexpr double fwhmPerSd = 2.3548;
  found.fwhm_mm =
      fwhmPerSd * std::cbrt(chain.blurInPlane_mm * chain.blurInPlane_mm * chain.blurAxial_mm);
  found.flags = ear.flags;
  const auto raise = [&](Flag flag, bool isRaised) {
    if (isRaised && !found.has(flag)) found.flags.push_back(flag);
  };

  found.course_P = courseThrough(chain.position_P, inMillimeters(array.contactsFromTip.front()));
  const auto filters = planning::defaultFiltersOf(array);
  if (!filters) return filters.error();
  const analysis::OrganOfCorti organ(*ear.scala);
  const anatomy::Entry entry = ear.scala->entry();
  const std::vector<double> partition = anatomy::partitionHeights(*ear.scala);
  const double step = ear.scala->tables().step;

  const double earSd =
      ear.isRegistered ? std::hypot(earSd_mm, ear.residual_mm) : earSdFromThisCt_mm;
  const double ofZero_deg =
      ear.measures.has(ct::Flag::roundWindowUnsure) ? definitionUnsure_deg : definition_deg;

  // beside the opening the plane of the round window decides, in all other turns the duct
  const auto pastWindow_mm = [&](const Vector3d& at_W) {
    return 1e3 * (entry.origin_W - at_W).dot(entry.out_W);
  };
  const auto isPast = [&](const EarPlace& place, const Vector3d& at_W) {
    return place.isInside && (place.angle >= 0.5 * pi || pastWindow_mm(at_W) > 0.0);
  };

  // turns: from the lead to the tip, so that the angle is unwrapped along the array
  std::vector<double> angle(count, 0.0);
  std::vector<bool> isInside(count, false);
  {
    double former = 0.0;
    for (std::size_t i = count; i-- > 0;) {
      const EarPlace place = frame.placeOf(chain.position_P[i]);
      const Vector3d at_W = frame.toW(chain.position_P[i]);
      isInside[i] = isPast(place, at_W);
      if (!isInside[i]) continue;
      double here = arcTangent(at_W.y(), at_W.x());
      // the turn nearest to that of the neighbor, or of the duct for the first
      const bool isFirst = i + 1 == count || !isInside[i + 1];
      const double near = isFirst ? place.angle : former;
      while (here < near - pi) here += 2.0 * pi;
      while (here > near + pi) here -= 2.0 * pi;
      angle[i] = here;
      former = here;
    }
  }

  for (std::size_t i = 0; i < count; ++i) {
    FoundContact contact;
    contact.number = static_cast<int>(i) + 1;
    contact.makerElectrode = array.makerElectrode(contact.number);
    contact.position_P = chain.position_P[i];
    contact.isByHand = i < isFixed.size() && isFixed[i];
    contact.isSeenSingly =
        evidence.isSeenSingly && i < evidence.isSeen.size() && evidence.isSeen[i];
    const double model =
        contact.isByHand ? handSd_mm
                         : modelConstant_mm + modelPerVoxel * std::cbrt(volume.spacing_mm().prod());
    contact.covariance_P = chain.covariance_P[i] + model * model * Matrix3d::Identity();
    contact.isInside = isInside[i];
    if (contact.isInside) {
      const Vector3d at_W = frame.toW(contact.position_P);
      const double r_mm = 1e3 * at_W.head<2>().norm();
      const Vector3d around = frame.directionToP(Vector3d(-at_W.y(), at_W.x(), 0.0).normalized());
      const double along = std::sqrt(std::max(0.0, around.dot(contact.covariance_P * around)));
      contact.angle_deg = {
          inDegrees(radians(angle[i])),
          std::hypot(std::hypot(inDegrees(radians(along / std::max(0.5, r_mm))), ofZero_deg),
                     inDegrees(radians(0.5 * earSd / std::max(0.5, r_mm))))};
      const anatomy::Section section =
          ear.scala->section(std::clamp(angle[i], 0.0, ear.scala->lastAngle().si()));
      contact.modiolus_mm = r_mm - 1e3 * section.innerRadius;
      contact.outerWall_mm = 1e3 * section.outerRadius - r_mm;
      const double x = std::clamp(angle[i] / step, 0.0, static_cast<double>(partition.size() - 1));
      const auto k = std::min(static_cast<std::size_t>(x), partition.size() - 2);
      const double height_mm =
          1e3 * (partition[k] + (x - static_cast<double>(k)) * (partition[k + 1] - partition[k]));
      const Vector3d up = frame.directionToP(Vector3d::UnitZ());
      const double sd = std::sqrt(std::max(0.0, up.dot(contact.covariance_P * up)) + earSd * earSd +
                                  partitionSd_mm * partitionSd_mm);
      contact.inScalaTympani = planning::normalBelow((height_mm - 1e3 * at_W.z()) / sd);
      const auto greenwood = [&](double deg) {
        return analysis::greenwoodFrequency(1.0 - organ.fractionAt(degrees(std::max(0.0, deg))));
      };
      const auto ganglion = [&](double deg) {
        return analysis::spiralGanglionFrequency(degrees(std::max(0.0, deg)));
      };
      const auto [low, high] = contact.angle_deg.interval95();
      contact.greenwood_Hz = {greenwood(contact.angle_deg.value), greenwood(high), greenwood(low)};
      contact.spiralGanglion_Hz = {ganglion(contact.angle_deg.value), ganglion(high),
                                   ganglion(low)};
      if (i < filters->size()) {
        contact.filter_Hz = (*filters)[i];
        contact.mismatch_semitones =
            analysis::semitones(contact.filter_Hz, contact.spiralGanglion_Hz[0]);
      }
    }
    found.contacts.push_back(contact);
  }

  // depth
  const auto apical = std::find_if(found.contacts.begin(), found.contacts.end(),
                                   [](const FoundContact& each) { return each.isInside; });
  found.contactsInside =
      static_cast<int>(std::count_if(found.contacts.begin(), found.contacts.end(),
                                     [](const FoundContact& each) { return each.isInside; }));
  if (apical != found.contacts.end()) {
    found.angularInsertionDepth_deg = apical->angle_deg;
    const Vector3d tip_W = frame.toW(found.course_P.front());
    double tip = arcTangent(tip_W.y(), tip_W.x());
    const double near = radians(0.0).si() + degrees(apical->angle_deg.value).si();
    while (tip < near - pi) tip += 2.0 * pi;
    while (tip > near + pi) tip -= 2.0 * pi;
    found.tipAngle_deg = inDegrees(radians(tip));
  }
  // where the course passes the opening
  const double courseToLast = lengthTo(found.course_P, chain.position_P[count - 1]);
  double inserted = 0.0;
  {
    double gone = 0.0;
    bool isOut = false;
    std::vector<Vector3d> course = found.course_P;
    const Vector3d lead = (course.back() - course[course.size() - 2]).normalized();
    for (int i = 0; i < 80; ++i)
      course.push_back(course.back() + 0.25 * lead);  // beyond what was fitted, straight
    for (std::size_t i = 0; i < course.size() && !isOut; ++i) {
      const Vector3d at_W = frame.toW(course[i]);
      const double step_mm = i > 0 ? (course[i] - course[i - 1]).norm() : 0.0;
      if (i > 0 && !isPast(frame.placeOf(course[i]), at_W)) {
        const double here = pastWindow_mm(at_W), before = pastWindow_mm(frame.toW(course[i - 1]));
        inserted = gone + (before > 0.0 && here < 0.0 ? before / (before - here) : 0.0) * step_mm;
        isOut = true;
      }
      gone += step_mm;
    }
    // what seems to be the lead stays in the ear: the duct's own length to the opening counts
    if (!isOut)
      inserted = courseToLast + std::max(0.0, frame.placeOf(chain.position_P[count - 1]).depth_mm);
  }
  // up to the last contact the array's own length counts: the contacts' course is shorter, on the inner side of the bend
  const double last_mm = inMillimeters(array.contactsFromTip.back());
  found.insertedLength_mm = inserted > courseToLast || courseToLast <= 0.0
                                ? last_mm + inserted - courseToLast
                                : inserted * last_mm / courseToLast;
  found.outside_mm = std::max(0.0, last_mm - found.insertedLength_mm);
  const FoundContact& basal = found.contacts.back();
  found.insertedLengthSd_mm = std::hypot(basal.error_mm(), std::hypot(earSd, 0.3));

  // what is doubtful
  double deepest = -1e9, shallowestAfter = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    const double depth = frame.depthAt(std::max(0.0, angle[i]));
    if (!isInside[i]) continue;
    deepest = std::max(deepest, depth);
    shallowestAfter = std::max(shallowestAfter, deepest - depth);
  }
  found.isFolded = shallowestAfter > foldBack_mm;
  // what the flag asks for: one contact alone may be in the wrong place
  std::vector<double> above;
  for (const FoundContact& each : found.contacts)
    if (each.isInside) above.push_back(1.0 - each.inScalaTympani);
  std::sort(above.begin(), above.end(), std::greater<>());
  if (above.size() >= fewestTranslocated)
    found.translocationProbability = above[fewestTranslocated - 1];
  for (std::size_t i = count; i-- > 0;)
    if (isInside[i] && 1.0 - found.contacts[i].inScalaTympani > translocated &&
        found.translocationAngle_deg == 0.0)
      found.translocationAngle_deg = found.contacts[i].angle_deg.value;
  bool isKinked = false, isClipped = false;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Vector3d a = chain.position_P[i] - chain.position_P[i - 1],
                   b = chain.position_P[i + 1] - chain.position_P[i];
    const double turn = arcTangent(a.cross(b).norm(), a.dot(b));
    isKinked = isKinked || 2.0 * turn / (a.norm() + b.norm()) > kinkPerMm;
  }
  for (std::size_t i = 0; i < count; ++i)
    isClipped = isClipped || !volume.contains(chain.position_P[i]);
  const bool isBeyondWall =
      std::any_of(found.contacts.begin(), found.contacts.end(), [](const FoundContact& each) {
        return each.isInside && std::min(each.modiolus_mm, each.outerWall_mm) < -beyondWall_mm;
      });
  raise(Flag::secondAssignment, evidence.isSecondNear);
  raise(Flag::missingContacts, evidence.areMissing);
  raise(Flag::extraMetal, evidence.unexplained > 1);
  raise(Flag::arrayDoesNotFit, evidence.areManyMissing || chain.lengthMisfit > badLengths ||
                                   evidence.unexplained > 3 || isBeyondWall);
  raise(Flag::notSeenSingly, !evidence.isSeenSingly);
  raise(Flag::fold, found.isFolded);
  raise(Flag::kink, isKinked && !found.isFolded);
  raise(Flag::possibleTranslocation, found.translocationProbability > translocated);
  raise(Flag::contactsOutside, found.contactsInside < static_cast<int>(count));
  raise(Flag::clipped, isClipped);
  raise(Flag::coarseVoxels, evidence.isCoarse);
  return found;
}

}  // namespace perilymph::outcome

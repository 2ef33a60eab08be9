// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ImplantPhantom.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "CtPhantomAnatomy.h"
#include "ImplantGeometry.h"
#include "ImplantScanner.h"
#include "ImplantSurroundings.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

Eigen::Vector3d moved(const Eigen::Matrix4d& pose, const Eigen::Vector3d& point)
{
  return pose.topLeftCorner<3, 3>() * point + pose.topRightCorner<3, 1>();
}

Eigen::Matrix3d drawnRotation(Dice& dice, double angle)
{
  return Eigen::AngleAxisd(
             angle, Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized())
      .toRotationMatrix();
}

/// The head lies differently after surgery: rotated by up to 20 degrees about the cochlea, moved by up to 20 mm.
Eigen::Matrix4d drawnMove(std::uint64_t seed, const Eigen::Vector3d& center)
{
  Dice dice(seed ^ 0x905eU);
  Eigen::Matrix4d move = Eigen::Matrix4d::Identity();
  const Eigen::Matrix3d rotation = drawnRotation(dice, degrees(dice.uniform(-20, 20)).si());
  const Eigen::Vector3d shift(dice.uniform(-20, 20), dice.uniform(-20, 20), dice.uniform(-20, 20));
  move.topLeftCorner<3, 3>() = rotation;
  move.topRightCorner<3, 1>() = center + shift - rotation * center;
  return move;
}

using AboveTest = std::function<bool(const Eigen::Vector3d& point_W, double angle)>;

ImplantTruth measured(const Course& course, const electrode::ArrayDesign& array,
                      const AboveTest& isAbove, const Eigen::Matrix4d& pose_PW)
{
  ImplantTruth truth;
  truth.pose_PW = pose_PW;
  const auto toP = [&](const Eigen::Vector3d& point_W) { return moved(truth.pose_PW, point_W); };
  for (std::size_t i = 0; i < array.contactsFromTip.size(); ++i) {
    const double at = inMillimeters(array.contactsFromTip[i]);
    TrueContact contact;
    contact.number = static_cast<int>(i) + 1;
    contact.onCourse_P = toP(course.at(at));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double volume = 0.0;
    for (const MetalPiece& piece : platinumOf(array, course, i)) {
      sum += piece.volume_mm3 * piece.point;
      volume += piece.volume_mm3;
    }
    contact.position_P = toP(sum / volume);
    contact.angle_deg = inDegrees(radians(course.angleAt(at)));
    contact.isInside = at <= course.opening;
    contact.isAbove = contact.isInside && isAbove(course.at(at), course.angleAt(at));
    if (contact.isInside) {
      ++truth.contactsInside;
      truth.angularInsertionDepth_deg =
          std::max(truth.angularInsertionDepth_deg, contact.angle_deg);
    }
    truth.contacts.push_back(contact);
  }
  for (double at = 0.0; at <= course.length(); at += 0.1)
    truth.course_P.push_back(toP(course.at(at)));
  truth.tip_P = truth.course_P.front();
  truth.tipAngle_deg = inDegrees(radians(course.angleAt(0.0)));
  truth.insertedLength_mm = course.opening;
  truth.isFolded = course.fold > 0.0;
  if (truth.isFolded) truth.foldAngle_deg = inDegrees(radians(course.angleAt(course.fold)));
  for (double at = course.opening; at >= 0.0; at -= Course::step)
    if (course.angleAt(at) > degrees(20).si() && isAbove(course.at(at), course.angleAt(at))) {
      truth.translocation_deg = inDegrees(radians(course.angleAt(at)));
      break;
    }
  return truth;
}

}  // namespace

ImplantScan fineImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.125);
  scan.preoperative = coneBeamScan();
  scan.detector_mm = 0.1;
  scan.focalSpot_mm = 0.2;
  scan.sliceProfile_mm = 0.125;
  scan.photons = 8.0e5;
  return scan;
}
ImplantScan coneBeamImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.2);
  scan.preoperative = coneBeamScan();
  scan.detector_mm = 0.15;
  scan.focalSpot_mm = 0.35;
  scan.sliceProfile_mm = 0.2;
  scan.photons = 6.0e5;
  return scan;
}
ImplantScan highResolutionImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.3);
  scan.preoperative = highResolutionScan();
  scan.detector_mm = 0.2;
  scan.focalSpot_mm = 0.3;
  scan.sliceProfile_mm = 0.3;
  scan.photons = 6.0e5;
  return scan;
}
ImplantScan clinicalImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm = {0.4, 0.4, 0.6};
  scan.preoperative = clinicalScan();
  scan.detector_mm = 0.3;
  scan.focalSpot_mm = 0.4;
  scan.sliceProfile_mm = 0.6;
  scan.photons = 6.0e5;
  return scan;
}

namespace {

/// The CT after surgery of an ear with an array in it; completes the truth by an old lead.
ct::CtVolume scannedEar(EarContent ear, const electrode::ArrayDesign& array, const Course& course,
                        const Eigen::Vector3d& center_P, const ImplantScan& scan, bool hasOldLead,
                        std::uint64_t seed, ImplantTruth& truth)
{
  const ImplantSurroundings surroundings(std::move(ear), array, course, hasOldLead, seed);
  for (const Eigen::Vector3d& point : surroundings.oldLead_W())
    truth.oldLead_P.push_back(moved(truth.pose_PW, point));
  const Eigen::Matrix4d w_fromP = truth.pose_PW.inverse();
  ImplantScene scene;
  scene.intensity = [&](const Eigen::Vector3d& point_P, double cell) {
    return surroundings.intensity(moved(w_fromP, point_P), cell);
  };
  for (const MetalPiece& piece : surroundings.metal())
    scene.metal.push_back({moved(truth.pose_PW, piece.point), piece.volume_mm3, piece.isContact});
  scene.center_P = center_P;
  scene.isRight = truth.isRight;
  return scanned(scene, scan, seed);
}

}  // namespace

ImplantPhantom makeImplantPhantom(std::uint64_t seed, const ImplantScan& scan,
                                  const ImplantCondition& condition)
{
  PhantomCondition ear;
  ear.isRight = condition.isRight;
  ear.hasRoomForArrays = true;
  CtPhantom before = makeCtPhantom(seed, scan.preoperative, ear);
  const PhantomAnatomy anatomy(seed, ear);
  electrode::ArrayDesign array = shippedArray(condition.array);
  const Course course = insertedCourse(seed, anatomy, array, condition);
  const Eigen::Matrix4d post_from_pre = drawnMove(seed, before.volume.center_P());
  const auto isAbove = [&](const Eigen::Vector3d& point_W, double angle) {
    return isAbovePartition(anatomy, point_W, angle);
  };
  ImplantTruth truth = measured(course, array, isAbove, post_from_pre * before.pose_PW);
  truth.a = before.a;
  truth.b = before.b;
  truth.h = before.h;
  truth.isRight = before.isRight;
  truth.axis_P = post_from_pre.topLeftCorner<3, 3>() * before.axis_P;
  truth.roundWindow_P = moved(post_from_pre, before.roundWindow_P);
  truth.inside_P = moved(post_from_pre, before.inside_P);
  const EarContent content{[&](const Eigen::Vector3d& point_W, double cell) {
                             return anatomy.intensity(point_W, fluidHu, cell);
                           },
                           [&](const Eigen::Vector3d& point_W) { return anatomy.inside(point_W); }};
  ct::CtVolume after =
      scannedEar(content, array, course, moved(post_from_pre, before.volume.center_P()), scan,
                 condition.hasOldLead, seed, truth);
  return {std::move(before), std::move(after), post_from_pre, std::move(truth), std::move(array)};
}

ImplantedEar implantInto(const ct::CtVolume& before, const ct::CochleaMeasures& ear,
                         std::uint64_t seed, const ImplantScan& scan,
                         const ImplantCondition& condition)
{
  if (condition.isFolded || condition.translocationAngle_deg)
    throw std::runtime_error("Folds and translocations are made in phantoms only.");
  const anatomy::BasalTurn turn{millimeters(ear.a.value), millimeters(ear.b.value),
                                millimeters(ear.h.value)};
  const auto scala = anatomy::buildMean("real ear", turn, Length{});
  if (!scala) throw std::runtime_error(scala.error().message);
  electrode::ArrayDesign array = shippedArray(condition.array);
  const Course course = insertedCourse(seed, *scala, array, condition);
  Eigen::Matrix4d pose_PW = Eigen::Matrix4d::Identity();
  pose_PW.topLeftCorner<3, 3>() = ear.anatomyAxes_PW;
  pose_PW.topRightCorner<3, 1>() = ear.anatomyOrigin_P;
  const Eigen::Matrix4d post_from_pre = drawnMove(seed, ear.center_P);
  ImplantTruth truth = measured(
      course, array, [](const Eigen::Vector3d&, double) { return false; }, post_from_pre * pose_PW);
  truth.a = ear.a.value;
  truth.b = ear.b.value;
  truth.h = ear.h.value;
  truth.isRight = ear.side == anatomy::Side::right;
  truth.axis_P = post_from_pre.topLeftCorner<3, 3>() * ear.axis_P;
  truth.roundWindow_P = moved(post_from_pre, ear.roundWindow_P);
  truth.inside_P = moved(truth.pose_PW, 1e3 * (*scala)->center_W(degrees(60).si()));
  // Beyond what was scanned: bone and air cells, as the homogeneous temporal bone of the scanner's head.
  constexpr double beyond = 1100.0;
  const EarContent content{
      [&](const Eigen::Vector3d& point_W, double) {
        return before.sample(moved(pose_PW, point_W)).value_or(beyond);
      },
      // What is nearer to the center line than a scala is wide.
      [&](const Eigen::Vector3d& point_W) {
        double nearest = 1e9;
        for (double angle = 0.0; angle < (*scala)->lastAngle().si(); angle += 0.2)
          nearest = std::min(nearest, (1e3 * (*scala)->center_W(angle) - point_W).norm());
        return 1.2 - nearest;
      }};
  ct::CtVolume after = scannedEar(content, array, course, moved(post_from_pre, ear.center_P), scan,
                                  condition.hasOldLead, seed, truth);
  return {std::move(after), post_from_pre, std::move(truth), std::move(array)};
}

}  // namespace perilymph::test

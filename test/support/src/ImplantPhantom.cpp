// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ImplantPhantom.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "CtPhantomAnatomy.h"
#include "ImplantGeometry.h"
#include "ImplantScanner.h"
#include "ImplantSurroundings.h"
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

ImplantTruth measured(const Course& course, const electrode::ArrayDesign& array,
                      const PhantomAnatomy& anatomy, const CtPhantom& before,
                      const Eigen::Matrix4d& post_from_pre)
{
  ImplantTruth truth;
  truth.pose_PW = post_from_pre * before.pose_PW;
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
    contact.isAbove =
        contact.isInside && isAbovePartition(anatomy, course.at(at), course.angleAt(at));
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
    if (course.angleAt(at) > degrees(20).si() &&
        isAbovePartition(anatomy, course.at(at), course.angleAt(at))) {
      truth.translocation_deg = inDegrees(radians(course.angleAt(at)));
      break;
    }
  truth.a = before.a;
  truth.b = before.b;
  truth.h = before.h;
  truth.isRight = before.isRight;
  truth.axis_P = post_from_pre.topLeftCorner<3, 3>() * before.axis_P;
  truth.roundWindow_P = moved(post_from_pre, before.roundWindow_P);
  truth.inside_P = moved(post_from_pre, before.inside_P);
  return truth;
}

}  // namespace

ImplantScan fineImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.125);
  scan.preoperative = coneBeamScan();
  scan.detector_mm = 0.1;
  scan.focalSpot_mm = 0.12;
  scan.sliceProfile_mm = 0.125;
  scan.photons = 4.0e5;
  return scan;
}
ImplantScan coneBeamImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.2);
  scan.preoperative = coneBeamScan();
  scan.detector_mm = 0.15;
  scan.focalSpot_mm = 0.2;
  scan.sliceProfile_mm = 0.2;
  scan.photons = 3.0e5;
  return scan;
}
ImplantScan highResolutionImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm.setConstant(0.3);
  scan.preoperative = highResolutionScan();
  scan.detector_mm = 0.25;
  scan.focalSpot_mm = 0.35;
  scan.sliceProfile_mm = 0.3;
  scan.photons = 3.0e5;
  return scan;
}
ImplantScan clinicalImplantScan()
{
  ImplantScan scan;
  scan.spacing_mm = {0.4, 0.4, 0.6};
  scan.preoperative = clinicalScan();
  scan.detector_mm = 0.35;
  scan.focalSpot_mm = 0.5;
  scan.sliceProfile_mm = 0.6;
  scan.photons = 3.0e5;
  return scan;
}

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
  ImplantTruth truth = measured(course, array, anatomy, before, post_from_pre);
  const ImplantSurroundings surroundings(anatomy, array, course, condition.hasOldLead, seed);
  for (const Eigen::Vector3d& point : surroundings.oldLead_W())
    truth.oldLead_P.push_back(moved(truth.pose_PW, point));
  const Eigen::Matrix4d w_fromP = truth.pose_PW.inverse();
  ImplantScene scene;
  scene.intensity = [&](const Eigen::Vector3d& point_P, double cell) {
    return surroundings.intensity(moved(w_fromP, point_P), cell);
  };
  for (const MetalPiece& piece : surroundings.metal())
    scene.metal.push_back({moved(truth.pose_PW, piece.point), piece.volume_mm3, piece.isContact});
  scene.center_P = moved(post_from_pre, before.volume.center_P());
  scene.isRight = before.isRight;
  ct::CtVolume after = scanned(scene, scan, seed);
  return {std::move(before), std::move(after), post_from_pre, std::move(truth), std::move(array)};
}

}  // namespace perilymph::test

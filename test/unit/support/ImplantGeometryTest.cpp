// SPDX-License-Identifier: BSD-3-Clause
#include "ImplantGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ImplantScanner.h"
#include "XrayBeam.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

const PhantomAnatomy& ear()
{
  PhantomCondition condition;
  condition.hasRoomForArrays = true;
  static const PhantomAnatomy anatomy(1, condition);
  return anatomy;
}

Course courseOf(const ImplantCondition& condition)
{
  return insertedCourse(1, ear(), shippedArray(condition.array), condition);
}

double depthAt(const Course& course, double fromTip) { return ear().inside(course.at(fromTip)); }

TEST(InsertedCourse, LiesInTheLowerScalaWithRoomForTheCarrier)
{
  const Course course = courseOf({});
  // The carrier touches the wall with its half thickness, 0.2 mm at the tip and more behind it; the lining of
  // 0.08 mm yields. The front of the cap at the tip may touch it.
  for (double at = 0.3; at < course.opening - 0.5; at += 0.5) {
    EXPECT_GT(depthAt(course, at), 0.12) << at;
    EXPECT_FALSE(isAbovePartition(ear(), course.at(at), course.angleAt(at))) << at;
  }
  EXPECT_GT(course.angleAt(0.0), degrees(450).si());
}

TEST(InsertedCourse, HasTheLengthOfTheArrayHoweverItLies)
{
  ImplantCondition folded, lifted;
  folded.isFolded = true;
  lifted.translocationAngle_deg = 180.0;
  for (const ImplantCondition& condition : {ImplantCondition{}, folded, lifted}) {
    const Course course = courseOf(condition);
    double length = 0.0;
    for (std::size_t i = 1; i < course.points_W.size(); ++i)
      length += (course.points_W[i] - course.points_W[i - 1]).norm();
    // Chords of 0.02 mm in bends of 0.3 mm are shorter than their arcs by 0.02 %.
    EXPECT_NEAR(length, inMillimeters(shippedArray("flex28").length), 0.02);
  }
}

TEST(InsertedCourse, TurnsBackWhereItsTipIsFolded)
{
  ImplantCondition condition;
  condition.isFolded = true;
  const Course course = courseOf(condition);
  ASSERT_GT(course.fold, 1.5);
  EXPECT_LT(course.fold, 6.0);
  EXPECT_LT(course.angleAt(0.0), course.angleAt(course.fold) - degrees(40).si());
  // Both legs lie side by side in the lumen.
  for (double at = 0.0; at < course.opening - 0.5; at += 0.25)
    EXPECT_GT(depthAt(course, at), 0.0) << at;
  for (double at = course.fold + 1.0; at < course.opening; at += 0.1)
    EXPECT_GT((course.at(at) - course.at(0.0)).norm(), 0.4) << at;
}

TEST(InsertedCourse, IsAboveThePartitionBeyondItsTranslocation)
{
  ImplantCondition condition;
  condition.translocationAngle_deg = 180.0;
  const Course course = courseOf(condition);
  for (double at = 0.0; at < course.opening; at += 0.5) {
    const double angle_deg = inDegrees(radians(course.angleAt(at)));
    // Within 1 to 2 mm of the array, at most 50 degrees there.
    if (angle_deg > 210.0) {
      EXPECT_TRUE(isAbovePartition(ear(), course.at(at), course.angleAt(at))) << at;
      EXPECT_GT(depthAt(course, at), 0.05) << at;
    }
    if (angle_deg > 20.0 && angle_deg < 150.0) {
      EXPECT_FALSE(isAbovePartition(ear(), course.at(at), course.angleAt(at))) << at;
    }
  }
}

TEST(Platinum, HasTheVolumeOfItsPlates)
{
  const electrode::ArrayDesign array = shippedArray("flex28");
  const Course course = courseOf({});
  double single = 0.0, pair = 0.0;
  for (const MetalPiece& piece : platinumOf(array, course, 0)) single += piece.volume_mm3;
  for (const MetalPiece& piece : platinumOf(array, course, 11)) pair += piece.volume_mm3;
  EXPECT_NEAR(single, 0.5 * 0.5 * 0.035, 1e-6);
  EXPECT_NEAR(pair, 2.0 * 0.5 * 0.5 * 0.035, 1e-6);
}

TEST(TubeBeam, HasTheKEdgesOfItsMetals)
{
  const XrayBeam beam = tubeBeam();
  float sum = 0.0F;
  for (const float weight : beam.weight) sum += weight;
  EXPECT_NEAR(sum, 1.0F, 1e-5F);
  // 65 to 76.11, 76.11 to 78.39, 78.39 to 88 keV. Platinum: 2.2 cm^2/g below and 9.3 above its edge.
  EXPECT_LT(beam.platinum[4], beam.platinum[3]);
  EXPECT_GT(beam.platinum[5], 3.0F * beam.platinum[4]);
  // The tenth of iridium absorbs between both edges.
  EXPECT_GT(beam.wire[4], 1.2F * beam.platinum[4]);
  // NIST's water at 60 keV is 0.0206 per mm; the beam is hardened to about 70.
  EXPECT_NEAR(beam.reference(), 0.0195, 0.001);
}

TEST(SimulatedCt, ShowsWaterBoneAndAPieceOfMetalWhereTheyAre)
{
  const Eigen::Vector3d center(10.0, -20.0, 30.0),
      ball = center + Eigen::Vector3d(3.13, -2.21, 1.37);
  const Eigen::Vector3d bone = center + Eigen::Vector3d(-4.0, 3.0, 0.0);
  ImplantScene scene;
  scene.center_P = center;
  scene.intensity = [&](const Eigen::Vector3d& point, double) {
    return (point - bone).head<2>().norm() < 3.0 ? 2000.0 : 60.0;
  };
  // A cube of 0.2 mm.
  for (int k = 0; k < 8; ++k)
    scene.metal.push_back(
        {ball + 0.05 * Eigen::Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1), 0.001,
         true});
  ImplantScan scan = clinicalImplantScan();
  scan.scatterFraction = 0.0;
  scan.isClipped = false;
  const ct::CtVolume volume = scanned(scene, scan, 1);

  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0.0, inBone = 0.0, inWater = 0.0;
  int bones = 0, waters = 0;
  const auto size = volume.size();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Eigen::Vector3d point =
            volume.toLps({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
        const double value = volume.voxel(i, j, k);
        if ((point - ball).norm() < 1.5) {
          sum += (value - 60.0) * point;
          weight += value - 60.0;
        } else if ((point - bone).head<2>().norm() < 2.0) {
          inBone += value;
          ++bones;
        } else if ((point - bone).head<2>().norm() > 5.0 && (point - ball).norm() > 4.0 &&
                   (point - center).head<2>().norm() < 8.0) {
          inWater += value;
          ++waters;
        }
      }
  // A tenth of a voxel in the plane; a slice of 0.6 mm does not show where within it something small lies.
  const Eigen::Vector3d off = sum / weight - ball;
  EXPECT_LT(off.head<2>().norm(), 0.04);
  EXPECT_LT(std::abs(off.z()), 0.3);
  // The water correction leaves the hardening by bone.
  EXPECT_NEAR(inBone / bones, 2000.0, 100.0);
  EXPECT_NEAR(inWater / waters, 60.0, 30.0);
}

}  // namespace
}  // namespace perilymph::test

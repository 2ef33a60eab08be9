// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ImplantPhantom.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "perilymph/foundation/Units.h"
#include "perilymph/test/RealEarTruth.h"
#include "perilymph/test/RealEars.h"

namespace perilymph::test {
namespace {

const ImplantPhantom& flex28()
{
  static const ImplantPhantom phantom = makeImplantPhantom(1, clinicalImplantScan());
  return phantom;
}

TEST(ImplantPhantom, HasContactsAtTheDesignsDistancesAlongItsCourse)
{
  const ImplantPhantom& phantom = flex28();
  const auto& course = phantom.truth.course_P;
  ASSERT_EQ(phantom.truth.contacts.size(), 12u);
  for (const TrueContact& contact : phantom.truth.contacts) {
    // The contact's place on the published course: its points are 0.1 mm apart.
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < course.size(); ++i)
      if ((course[i] - contact.onCourse_P).norm() < (course[nearest] - contact.onCourse_P).norm())
        nearest = i;
    double along = 0.0;
    for (std::size_t i = 1; i <= nearest; ++i) along += (course[i] - course[i - 1]).norm();
    const double wanted =
        inMillimeters(phantom.array.contactsFromTip[static_cast<std::size_t>(contact.number - 1)]);
    // Half a step of the course, and chords that are shorter than their arcs.
    EXPECT_NEAR(along, wanted, 0.07) << contact.number;
  }
}

TEST(ImplantPhantom, CarriesTheRoundWindowFromOneVolumeToTheOther)
{
  const ImplantPhantom& phantom = flex28();
  const Eigen::Vector3d carried =
      (phantom.post_from_pre * phantom.preoperative.roundWindow_P.homogeneous()).head<3>();
  EXPECT_LT((carried - phantom.truth.roundWindow_P).norm(), 1e-9);
  EXPECT_TRUE(phantom.postoperative.contains(carried));
  const Eigen::Matrix3d rotation = phantom.post_from_pre.topLeftCorner<3, 3>();
  EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(ImplantPhantom, IsTheSameForTheSameSeed)
{
  const ImplantPhantom again = makeImplantPhantom(1, clinicalImplantScan());
  EXPECT_TRUE(std::ranges::equal(again.postoperative.voxels(), flex28().postoperative.voxels()));
}

/// Every contact is as bright within a voxel as the volume is anywhere: clipped.
void expectBrightContacts(const ct::CtVolume& volume, const ImplantTruth& truth)
{
  std::int16_t brightest = -1024;
  for (const std::int16_t voxel : volume.voxels()) brightest = std::max(brightest, voxel);
  EXPECT_EQ(brightest, 3071);
  for (const TrueContact& contact : truth.contacts) {
    const Eigen::Vector3d at = volume.toIndex(contact.position_P);
    if ((at.array() < 1.0).any() || at.x() > volume.size()[0] - 2 ||
        at.y() > volume.size()[1] - 2 || at.z() > volume.size()[2] - 2)
      continue;
    std::int16_t near = -1024;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          near = std::max(near, volume.voxel(static_cast<int>(std::lround(at.x())) + i,
                                             static_cast<int>(std::lround(at.y())) + j,
                                             static_cast<int>(std::lround(at.z())) + k));
    EXPECT_EQ(near, brightest) << contact.number;
  }
}

TEST(ImplantPhantom, IsBrightestAtItsContacts)
{
  expectBrightContacts(flex28().postoperative, flex28().truth);
}

TEST(ImplantPhantom, ShowsTheSameEarAroundTheMetal)
{
  // Far from metal both volumes show the same bone: the correlation of their intensities at the same points.
  const ImplantPhantom& phantom = flex28();
  double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (double z = -6.0; z <= 6.0; z += 0.6)
    for (double y = -6.0; y <= 6.0; y += 0.6)
      for (double x = -6.0; x <= 6.0; x += 0.6) {
        const Eigen::Vector3d before_P =
            phantom.preoperative.volume.center_P() + Eigen::Vector3d(x, y, z);
        const Eigen::Vector3d after_P = (phantom.post_from_pre * before_P.homogeneous()).head<3>();
        const auto before = phantom.preoperative.volume.sample(before_P);
        const auto after = phantom.postoperative.sample(after_P);
        if (!before || !after) continue;
        bool isNear = false;
        for (const Eigen::Vector3d& point : phantom.truth.course_P)
          isNear = isNear || (point - after_P).norm() < 3.0;
        if (isNear) continue;
        n += 1.0;
        a += *before;
        b += *after;
        aa += *before * *before;
        bb += *after * *after;
        ab += *before * *after;
      }
  ASSERT_GT(n, 500.0);
  EXPECT_GT((ab - a * b / n) / std::sqrt((aa - a * a / n) * (bb - b * b / n)), 0.85);
}

TEST(ImplantPhantom, LeavesContactsOutsideWhereItIsAskedTo)
{
  ImplantCondition condition;
  condition.contactsOutside = 3;
  condition.hasOldLead = true;
  ImplantScan scan = clinicalImplantScan();
  scan.hasMetalCorrection = true;
  scan.motion_mm = 0.2;
  scan.isBoneKernel = false;
  const ImplantPhantom phantom = makeImplantPhantom(3, scan, condition);
  EXPECT_EQ(phantom.truth.contactsInside, 9);
  EXPECT_FALSE(phantom.truth.contacts[9].isInside);
  EXPECT_TRUE(phantom.truth.contacts[8].isInside);
  // Another piece of metal is where its lead is, in silicone of 230 and fluid.
  int bright = 0, seen = 0;
  for (const Eigen::Vector3d& point : phantom.truth.oldLead_P)
    if (const auto value = phantom.postoperative.sample(point)) {
      ++seen;
      bright += *value > 1000.0 ? 1 : 0;
    }
  EXPECT_GT(seen, 50);
  EXPECT_GT(bright, 9 * seen / 10);
}

TEST(ImplantInto, RefusesWhatItCannotMake)
{
  ImplantCondition condition;
  condition.isFolded = true;
  EXPECT_THROW(implantInto(flex28().preoperative.volume, {}, 1, clinicalImplantScan(), condition),
               std::runtime_error);
  condition = {};
  condition.array = "no-such-array";
  EXPECT_THROW(makeImplantPhantom(1, clinicalImplantScan(), condition), std::runtime_error);
}

TEST(ImplantInto, AddsAnArrayToRealEars)
{
  const auto folder = realEarFolder();
  if (!folder)
    GTEST_SKIP() << "PERILYMPH_EARS names no folder with real ears: set it to test on them.";
  for (const std::string& name : realEarNames(*folder)) {
    const RealEar ear = loadRealEar(*folder, name);
    ct::MeasureRequest request;
    request.click_P = clickOf(ear);
    const auto measured = ct::measureCochlea(ear.ct, request);
    ASSERT_TRUE(measured) << measured.error().message;
    ImplantCondition condition;
    condition.array = "slim-straight";
    const ImplantedEar implanted =
        implantInto(ear.ct, *measured, 3, highResolutionImplantScan(), condition);
    SCOPED_TRACE(name);
    EXPECT_GT(implanted.truth.angularInsertionDepth_deg, 300.0);
    expectBrightContacts(implanted.postoperative, implanted.truth);
  }
}

}  // namespace
}  // namespace perilymph::test

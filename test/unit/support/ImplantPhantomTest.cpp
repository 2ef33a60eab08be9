// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ImplantPhantom.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"

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

TEST(ImplantPhantom, IsBrightestAtItsContacts)
{
  const ImplantPhantom& phantom = flex28();
  const ct::CtVolume& volume = phantom.postoperative;
  std::int16_t brightest = -1024;
  for (const std::int16_t voxel : volume.voxels()) brightest = std::max(brightest, voxel);
  for (const TrueContact& contact : phantom.truth.contacts) {
    const Eigen::Vector3d at = volume.toIndex(contact.position_P);
    std::int16_t near = -1024;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          near = std::max(near, volume.voxel(static_cast<int>(std::lround(at.x())) + i,
                                             static_cast<int>(std::lround(at.y())) + j,
                                             static_cast<int>(std::lround(at.z())) + k));
    // Clipped, as the brightest metal is.
    EXPECT_EQ(near, brightest) << contact.number;
  }
}

}  // namespace
}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// Measurement of a phantom in DICOM slices of a tilted gantry.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perilymph/ct/Measures.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

/// The phantom's volume in slices that are inclined to the table's motion, 0.25 mm apart.
ct::CtVolume tilted(const ct::CtVolume& volume, double tilt)
{
  const Eigen::Matrix3d axes = volume.lpsFromIndex().topLeftCorner<3, 3>().colwise().normalized();
  const Eigen::Matrix3d turned =
      axes * Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
  constexpr int size = 60;
  constexpr double spacing_mm = 0.25;
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.block<3, 1>(0, 0) = spacing_mm * turned.col(0);
  lps.block<3, 1>(0, 1) = spacing_mm * turned.col(1);
  lps.block<3, 1>(0, 2) = spacing_mm * axes.col(2);
  lps.block<3, 1>(0, 3) =
      volume.center_P() - lps.topLeftCorner<3, 3>() * Eigen::Vector3d::Constant(0.5 * (size - 1));
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) {
        const Eigen::Vector4d place = lps * Eigen::Vector4d(i, j, k, 1.0);
        voxels.push_back(
            static_cast<std::int16_t>(std::lround(volume.sample(place.head<3>()).value_or(0.0))));
      }
  return *ct::CtVolume::make({size, size, size}, lps, std::move(voxels));
}

TEST(DicomPhantom, OfATiltedGantryIsMeasuredWithinItsErrors)
{
  const test::CtPhantom phantom = test::makeCtPhantom(205, test::coneBeamScan());
  const test::TemporaryFolder folder;
  test::writeDicomFiles(test::dicomSlices(tilted(phantom.volume, 0.2)), folder / "ct");
  const auto loaded = readCt(folder / "ct");
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->volume.provenance().notes.size(), 1u);
  ct::MeasureRequest request;
  request.click_P = phantom.inside_P;
  const auto found = ct::measureCochlea(loaded->volume, request);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->a.value, phantom.a, 3.0 * found->a.sd());
  EXPECT_NEAR(found->b.value, phantom.b, 3.0 * found->b.sd());
  EXPECT_NEAR(found->h.value, phantom.h, 3.0 * found->h.sd());
  EXPECT_EQ(found->side == anatomy::Side::right, phantom.isRight);
  EXPECT_EQ(found->provenance.notes, loaded->volume.provenance().notes);
}

}  // namespace
}  // namespace perilymph::imaging

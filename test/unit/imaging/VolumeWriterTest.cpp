// SPDX-License-Identifier: BSD-3-Clause

// A CT written without patient data comes back with the same voxels at the same places.

#include "perilymph/imaging/VolumeWriter.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "SmallCt.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

Eigen::Matrix3d oblique(bool isMirrored)
{
  Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  if (isMirrored) axes.col(2) = -axes.col(2);
  return axes;
}

class WrittenVolume : public testing::TestWithParam<const char*> {
protected:
  test::TemporaryFolder folder_;
};

TEST_P(WrittenVolume, ComesBackWithItsVoxelsAtTheirPlaces)
{
  for (const bool isMirrored : {false, true}) {
    const ct::CtVolume volume =
        smallCt(oblique(isMirrored), Eigen::Vector3d(0.3, 0.4, 0.6), {14, 12, 10});
    const auto file = folder_ / GetParam();
    const auto written = writeVolume(volume, file);
    ASSERT_TRUE(written) << written.error().message;
    const auto read = readCt(file);
    ASSERT_TRUE(read) << read.error().message;
    for (const Eigen::Vector3d& index :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(13, 11, 9), Eigen::Vector3d(3, 7, 2)}) {
      const Eigen::Vector3d point_P = volume.toLps(index);
      const Eigen::Vector3d there = read->volume.toIndex(point_P);
      // the file may count its axes from the other end, but only whole voxels apart
      EXPECT_LT((there - there.array().round().matrix()).norm(), 1e-3) << isMirrored;
      const Eigen::Vector3i i = index.cast<int>(), j = there.array().round().cast<int>();
      EXPECT_EQ(read->volume.voxel(j.x(), j.y(), j.z()), volume.voxel(i.x(), i.y(), i.z()));
    }
  }
}

TEST_P(WrittenVolume, HoldsAirWhereNothingWasMeasured)
{
  const ct::CtVolume whole = smallCt(oblique(false), Eigen::Vector3d(0.3, 0.4, 0.6), {14, 12, 10});
  std::vector<std::int16_t> voxels(whole.voxels().begin(), whole.voxels().end());
  for (std::size_t i = 0; i < 100; ++i) voxels[i] = ct::unmeasured;
  const auto volume = *ct::CtVolume::make(whole.size(), whole.lpsFromIndex(), voxels);
  EXPECT_EQ(volume.unmeasuredCount(), 100U);
  const auto file = folder_ / GetParam();
  ASSERT_TRUE(writeVolume(volume, file));
  const auto read = readCt(file);
  ASSERT_TRUE(read) << read.error().message;
  const auto found = read->volume.voxels();
  EXPECT_EQ(std::count(found.begin(), found.end(), std::int16_t{-1024}), 100);
  EXPECT_EQ(read->volume.unmeasuredCount(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, WrittenVolume, testing::Values("ct.nrrd", "ct.nii", "ct.nii.gz"));

TEST(WriteVolume, KeepsNrrdPositionsExactly)
{
  const test::TemporaryFolder folder;
  const ct::CtVolume volume = smallCt(oblique(false), Eigen::Vector3d(0.3, 0.4, 0.6), {14, 12, 10});
  ASSERT_TRUE(writeVolume(volume, folder / "ct.nrrd"));
  const auto read = readCt(folder / "ct.nrrd");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->volume.lpsFromIndex(), volume.lpsFromIndex());
}

TEST(WriteVolume, RefusesOtherExtensions)
{
  const test::TemporaryFolder folder;
  const auto written = writeVolume(smallCt(), folder / "ct.dcm");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, testing::HasSubstr(".nrrd, .nii or .nii.gz"));
}

}  // namespace
}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause

// The CT as an image in the cochlear frame, unpacked by the library.

#include "perilymph/broadcast/CtImage.h"

#include <gtest/gtest.h>
#include <igtlImageMessage.h>
#include <igtlMessageHeader.h>

#include <Eigen/Geometry>
#include <cstring>

namespace perilymph::broadcast {
namespace {

using Eigen::Vector3d;

/// Voxels whose intensity tells their place in P: 100 x + 10 y + z [mm], rounded.
std::int16_t intensityAt(const Vector3d& place_P)
{
  return static_cast<std::int16_t>(
      std::lround(100.0 * place_P.x() + 10.0 * place_P.y() + place_P.z()));
}

std::shared_ptr<const ct::CtVolume> volume(const std::array<int, 3>& size,
                                           const Eigen::Matrix4d& lps_PI)
{
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        voxels.push_back(intensityAt((lps_PI * Eigen::Vector4d(i, j, k, 1.0)).head<3>()));
  auto made =
      ct::CtVolume::make(size, lps_PI, std::move(voxels), {"series-key", "A maker", "DICOM"});
  EXPECT_TRUE(made) << made.error().message;
  return std::make_shared<const ct::CtVolume>(*std::move(made));
}

/// Spacing 0.4, 0.5 and 0.6 mm along oblique axes, the first voxel at (-20, -10, 5).
Eigen::Matrix4d obliqueGrid()
{
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();
  lps_PI.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(0.3, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix() *
      Vector3d(0.4, 0.5, 0.6).asDiagonal();
  lps_PI.topRightCorner<3, 1>() = Vector3d(-20.0, -10.0, 5.0);
  return lps_PI;
}

/// An image as a receiver sees it.
struct Received {
  std::string name;
  std::array<int, 3> size{};
  std::array<float, 3> spacing{};
  Eigen::Matrix4d matrix;
  std::vector<std::int16_t> voxels;

  /// As 3D Slicer and OpenIGTLinkIO place a voxel: the origin is the center of the image.
  Vector3d placeOf(int i, int j, int k) const
  {
    const std::array<int, 3> index{i, j, k};
    Vector3d place_W = matrix.topRightCorner<3, 1>();
    for (std::size_t axis = 0; axis < 3; ++axis)
      place_W += (index[axis] - 0.5 * (size[axis] - 1)) * double(spacing[axis]) *
                 matrix.block<3, 1>(0, static_cast<Eigen::Index>(axis));
    return place_W;
  }
  std::int16_t voxel(int i, int j, int k) const
  {
    return voxels[static_cast<std::size_t>((k * size[1] + j) * size[0] + i)];
  }
};

Received unpacked(const PackedImage& bytes)
{
  Received received;
  auto header = igtl::MessageHeader::New();
  header->InitPack();
  std::memcpy(header->GetPackPointer(), bytes->data(),
              static_cast<std::size_t>(header->GetPackSize()));
  header->Unpack();
  received.name = header->GetDeviceName();
  EXPECT_STREQ(header->GetDeviceType(), "IMAGE");
  auto image = igtl::ImageMessage::New();
  image->SetMessageHeader(header);
  image->AllocatePack();
  EXPECT_EQ(bytes->size(), std::size_t(header->GetPackSize() + image->GetPackBodySize()));
  std::memcpy(image->GetPackBodyPointer(), bytes->data() + header->GetPackSize(),
              static_cast<std::size_t>(image->GetPackBodySize()));
  EXPECT_TRUE(image->Unpack(1) & igtl::MessageHeader::UNPACK_BODY);  // its check sum is right
  EXPECT_EQ(image->GetScalarType(), igtl::ImageMessage::TYPE_INT16);
  EXPECT_EQ(image->GetNumComponents(), 1);
  EXPECT_EQ(image->GetEndian(), igtl::ImageMessage::ENDIAN_LITTLE);
  EXPECT_EQ(image->GetCoordinateSystem(), igtl::ImageMessage::COORDINATE_RAS);
  image->GetDimensions(received.size.data());
  image->GetSpacing(received.spacing.data());
  igtl::Matrix4x4 matrix;
  image->GetMatrix(matrix);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) received.matrix(row, column) = matrix[row][column];
  const auto count = static_cast<std::size_t>(received.size[0]) *
                     static_cast<std::size_t>(received.size[1]) *
                     static_cast<std::size_t>(received.size[2]);
  const auto* const first = static_cast<const std::int16_t*>(image->GetScalarPointer());
  received.voxels.assign(first, first + count);
  return received;
}

Received received(const PlacedCt& ct)
{
  const auto image = packImage(ct);
  EXPECT_TRUE(image) << image.error().message;
  return unpacked(*image);
}

/// Every voxel has the intensity of its place in the patient.
void expectInPlace(const Received& image, const PlacedCt& ct)
{
  for (int k = 0; k < image.size[2]; k += 5)
    for (int j = 0; j < image.size[1]; j += 5)
      for (int i = 0; i < image.size[0]; i += 5) {
        const Vector3d place_P = ct.origin_P + ct.axes_PW * image.placeOf(i, j, k);
        ASSERT_NEAR(image.voxel(i, j, k), 100.0 * place_P.x() + 10.0 * place_P.y() + place_P.z(),
                    0.6)
            << i << ' ' << j << ' ' << k;
      }
}

TEST(CtImage, HasEachVoxelAtItsPlaceInTheCochlea)
{
  PlacedCt ct{volume({40, 50, 60}, obliqueGrid())};
  ct.axes_PW = Eigen::AngleAxisd(1.1, Vector3d(0.2, -1.0, 0.4).normalized()).toRotationMatrix();
  ct.origin_P = ct.volume->center_P() + Vector3d(1.0, -0.5, 0.3);
  const Received image = received(ct);
  EXPECT_EQ(image.name, "PerilymphCT");
  EXPECT_EQ(image.size, (std::array<int, 3>{40, 50, 60}));
  EXPECT_FLOAT_EQ(image.spacing[0], 0.4f);
  EXPECT_FLOAT_EQ(image.spacing[2], 0.6f);
  expectInPlace(image, ct);
}

TEST(CtImage, MirrorsALeftEar)
{
  PlacedCt ct{volume({40, 50, 60}, obliqueGrid())};
  ct.axes_PW = Eigen::AngleAxisd(1.1, Vector3d::UnitX()).toRotationMatrix();
  ct.axes_PW.col(1) *= -1.0;
  ct.origin_P = ct.volume->center_P();
  const Received image = received(ct);
  EXPECT_LT((image.matrix.topLeftCorner<3, 3>().determinant()), 0.0);
  expectInPlace(image, ct);
}

TEST(CtImage, HasEachVoxelAtItsPlaceInThePatient)
{
  PlacedCt ct{volume({40, 50, 60}, obliqueGrid())};
  ct.axes_PW = Eigen::AngleAxisd(1.1, Vector3d(0.2, -1.0, 0.4).normalized()).toRotationMatrix();
  ct.origin_P = ct.volume->center_P();
  const auto packed = packImage(ct, Coordinates::patient);
  ASSERT_TRUE(packed);
  const Received image = unpacked(*packed);
  EXPECT_GT((image.matrix.topLeftCorner<3, 3>().determinant()), 0.0);
  for (int k = 0; k < image.size[2]; k += 5)
    for (int j = 0; j < image.size[1]; j += 5)
      for (int i = 0; i < image.size[0]; i += 5) {
        const Vector3d ras = image.placeOf(i, j, k);
        ASSERT_NEAR(image.voxel(i, j, k), -100.0 * ras.x() - 10.0 * ras.y() + ras.z(), 0.6);
      }
}

TEST(CtImage, PlacesTheCochleaInRas)
{
  PlacedCt ct{volume({3, 3, 3}, Eigen::Matrix4d::Identity())};
  ct.axes_PW = Eigen::AngleAxisd(0.7, Vector3d(0.5, 1.0, 0.3).normalized()).toRotationMatrix();
  ct.axes_PW.col(1) *= -1.0;  // a left ear
  ct.origin_P = Vector3d(-61.0, 20.0, 1400.0);
  const Vector3d point_W(3e-3, -4e-3, 1e-3);
  const Vector3d lps = ct.origin_P + 1e3 * (ct.axes_PW * point_W);
  const Vector3d ras = 1e3 * pointIn(placementOf(ct), point_W);
  EXPECT_LT((ras - Vector3d(-lps.x(), -lps.y(), lps.z())).norm(), 1e-9);
}

TEST(CtImage, HoldsTheVoxelsWithinTwentyMillimeters)
{
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();
  lps_PI.diagonal().head<3>() = Vector3d(0.5, 0.5, 1.0);
  PlacedCt ct{volume({160, 100, 80}, lps_PI)};
  ct.origin_P = Vector3d(40.0, 20.0, 40.0);
  const Received image = received(ct);
  EXPECT_EQ(image.size, (std::array<int, 3>{81, 81, 41}));
  EXPECT_LT((image.placeOf(0, 0, 0) - Vector3d(-20.0, -20.0, -20.0)).norm(), 1e-5);
  expectInPlace(image, ct);
}

TEST(CtImage, HoldsLessOfAVolumeWithMoreVoxelsThanAMessage)
{
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();
  lps_PI.diagonal().head<3>() = Vector3d(0.1, 0.1, 0.1);
  PlacedCt ct{volume({370, 370, 370}, lps_PI)};
  ct.origin_P = ct.volume->center_P();
  const auto image = packImage(ct);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_LE((*image)->size(), 2 * maxImageVoxels + 1000);
  EXPECT_GT((*image)->size(), 2 * maxImageVoxels * 8 / 10);
}

TEST(CtImage, BeginsAtTheBorderIfTheScanIsClipped)
{
  PlacedCt ct{volume({40, 50, 60}, obliqueGrid())};
  ct.origin_P = ct.volume->toLps(Vector3d(-3.0, 25.0, 70.0));
  const Received image = received(ct);
  EXPECT_EQ(image.size[0], 40);
  expectInPlace(image, ct);
}

TEST(CtImage, NamesNeitherScannerNorSeries)
{
  PlacedCt ct{volume({40, 50, 60}, obliqueGrid())};
  ct.origin_P = ct.volume->center_P();
  const auto image = packImage(ct);
  ASSERT_TRUE(image);
  const std::string bytes((*image)->begin(), (*image)->end());
  EXPECT_EQ(bytes.find("A maker"), std::string::npos);
  EXPECT_EQ(bytes.find("series-key"), std::string::npos);
}

}  // namespace
}  // namespace perilymph::broadcast

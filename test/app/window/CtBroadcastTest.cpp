// SPDX-License-Identifier: BSD-3-Clause

// The scan of the page CT as navigation programs receive it.

#include <igtlImageMessage.h>

#include <future>

#include "TheCtPage.h"
#include "gui/shell/Navigation.h"
#include "perilymph/test/IgtlClient.h"

namespace perilymph::test {
namespace {

using TheBroadcastScan = TheCtPage;

igtl::ImageMessage::Pointer imageFrom(int port)
{
  auto socket = igtl::ClientSocket::New();
  EXPECT_EQ(socket->ConnectToServer("127.0.0.1", port), 0);
  socket->SetReceiveTimeout(WindowRig::patience_ms);
  auto request = igtl::GetImageMessage::New();
  request->SetDeviceName("PerilymphCT");
  request->Pack();
  socket->Send(request->GetPackPointer(), request->GetPackSize());
  return receive<igtl::ImageMessage>(*socket, "PerilymphCT");
}

TEST_F(TheBroadcastScan, IsInTheFrameOfTheArray)
{
  measure();
  gui::Navigation& navigation = rig_.window().navigation();
  const auto& control = rig_.window().control();
  EXPECT_FALSE(page().placedCt(control.scenario()));  // of another cochlea
  rig_.type("ctPatientCode", "CT-203");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return control.scenario().patient().label == "CT-203"; }));
  ASSERT_TRUE(navigation.listen({"127.0.0.1", 0}));
  auto coming = std::async(std::launch::async, imageFrom, navigation.port());
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
  const igtl::ImageMessage::Pointer image = coming.get();

  // The voxel next to a place in W, in millimeters, is that of the scan at the same place.
  int size[3];
  float spacing[3];
  igtl::Matrix4x4 matrix;
  image->GetDimensions(size);
  image->GetSpacing(spacing);
  image->GetMatrix(matrix);
  const auto* const voxels = static_cast<const std::int16_t*>(image->GetScalarPointer());
  const ct::CtVolume& scan = *study().volume();
  int compared = 0;
  for (int k = 0; k < size[2]; k += 3)
    for (int j = 0; j < size[1]; j += 3)
      for (int i = 0; i < size[0]; i += 3) {
        const std::array<int, 3> index{i, j, k};
        Eigen::Vector3d place_W;
        for (int row = 0; row < 3; ++row) {
          place_W[row] = matrix[row][3];
          for (std::size_t axis = 0; axis < 3; ++axis)
            place_W[row] += double(matrix[row][axis]) * double(spacing[axis]) *
                            (index[axis] - 0.5 * (size[axis] - 1));
        }
        const Eigen::Vector3d inScan =
            scan.toIndex(study().measures()->fromAnatomy(1e-3 * place_W)).array().round();
        ASSERT_EQ(voxels[(k * size[1] + j) * size[0] + i],
                  scan.voxel(int(inScan[0]), int(inScan[1]), int(inScan[2])));
        ++compared;
      }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace perilymph::test

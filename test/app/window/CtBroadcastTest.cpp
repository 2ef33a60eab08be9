// SPDX-License-Identifier: BSD-3-Clause

// The scan of the page CT as navigation programs receive it.

#include <gmock/gmock.h>
#include <igtlImageMessage.h>
#include <igtlPointMessage.h>
#include <igtlStringMessage.h>
#include <igtlTransformMessage.h>

#include <Eigen/LU>
#include <cmath>
#include <future>
#include <sstream>

#include "TheCtPage.h"
#include "gui/shell/Navigation.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/IgtlClient.h"
#include "perilymph/test/Places.h"

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

/// The places of the contacts in the patient's RAS [mm], and the insertion force [N].
struct InPatient {
  std::vector<Eigen::Vector3d> contacts;
  double force = 0.0;
};

/// As the library's client finds them.
InPatient byTheLibrary(int port)
{
  InPatient found;
  auto socket = igtl::ClientSocket::New();
  EXPECT_EQ(socket->ConnectToServer("127.0.0.1", port), 0);
  socket->SetReceiveTimeout(WindowRig::patience_ms);
  igtl::Matrix4x4 matrix;
  receive<igtl::TransformMessage>(*socket, "PerilymphToPatient")->GetMatrix(matrix);
  const auto points = receive<igtl::PointMessage>(*socket, "PerilymphContacts");
  for (int i = 0; i < points->GetNumberOfPointElement(); ++i) {
    igtl::PointElement::Pointer point;
    float at[3];
    points->GetPointElement(i, point);
    point->GetPosition(at);
    Eigen::Vector3d place;
    for (int row = 0; row < 3; ++row)
      place[row] = double(matrix[row][0]) * double(at[0]) + double(matrix[row][1]) * double(at[1]) +
                   double(matrix[row][2]) * double(at[2]) + double(matrix[row][3]);
    found.contacts.push_back(place);
  }
  const std::string text = receive<igtl::StringMessage>(*socket, "PerilymphReadout")->GetString();
  const std::string name = "force_axial_N=";
  EXPECT_THAT(text, testing::HasSubstr("patient=known"));
  found.force = std::stod(text.substr(text.find(name) + name.size()));
  return found;
}

/// As a client finds them that decodes the bytes itself.
InPatient byTheBytes(int port)
{
  const auto outcome =
      run({"/usr/bin/python3",
           {projectFolder() / "test/app/window/contacts_in_patient.py", std::to_string(port)},
           {},
           std::nullopt});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream text(outcome.out);
  InPatient found;
  double x = 0.0, y = 0.0, z = 0.0;
  while (text >> x && text >> y >> z) found.contacts.emplace_back(x, y, z);
  found.force = x;
  return found;
}

/// Where the engine has the contacts, in RAS [mm]: at their distance from the tip along the nodes.
std::vector<Eigen::Vector3d> byTheEngine(const haptics::Snapshot& now,
                                         const electrode::ArrayDesign& array,
                                         const ct::CochleaMeasures& measures)
{
  const auto node = [&](std::uint32_t i) {
    return Eigen::Vector3d(now.node_W[i][0], now.node_W[i][1], now.node_W[i][2]);
  };
  std::vector<Eigen::Vector3d> places;
  for (const Length distance : array.contactsFromTip) {
    double left = distance.si();
    std::uint32_t i = now.nodes - 1;
    while (i > 1 && (node(i) - node(i - 1)).norm() < left) {
      left -= (node(i) - node(i - 1)).norm();
      --i;
    }
    const Eigen::Vector3d place_W = node(i) + left * (node(i - 1) - node(i)).normalized();
    const Eigen::Vector3d lps = measures.fromAnatomy(place_W);
    places.emplace_back(-lps.x(), -lps.y(), lps.z());
  }
  return places;
}

template <class Call>
auto inTheMeantime(Call call)
{
  auto coming = std::async(std::launch::async, call);
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
  return coming.get();
}

// 0.01 mm is a tenth of the spacing of the finest cone-beam CT.
TEST_F(TheBroadcastScan, HasTheArrayInItForBothClientsAndInBothFrames)
{
  measure();
  gui::Navigation& navigation = rig_.window().navigation();
  const auto& control = rig_.window().control();
  // Without the CT of what is shown, there is nothing to be sent in the patient's coordinates.
  ASSERT_TRUE(navigation.listen({"127.0.0.1", 0}, broadcast::Coordinates::patient));
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return navigation.status().contains("Nothing is sent: the coordinates"); }));
  rig_.type("ctPatientCode", "CT-203");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return control.scenario().patient().label == "CT-203"; }));
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !navigation.status().contains("Nothing"); }));
  rig_.window().insertion().start();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 2.0; }));
  rig_.window().insertion().pause();
  auto before = rig_.now().output.tip_W;
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    const auto tip = rig_.now().output.tip_W;
    const bool isSame = tip == before && rig_.now().output.speed == 0.0;
    before = tip;
    return isSame && rig_.runForTicks(200) && rig_.now().output.tip_W == before;
  }));
  for (const auto coordinates :
       {broadcast::Coordinates::cochlea, broadcast::Coordinates::patient}) {
    ASSERT_TRUE(navigation.listen({"127.0.0.1", 0}, coordinates));
    const int port = navigation.port();
    for (const auto& found : {inTheMeantime([port] { return byTheLibrary(port); }),
                              inTheMeantime([port] { return byTheBytes(port); })}) {
      const auto expected =
          byTheEngine(rig_.now(), control.scenario().array(), *study().measures());
      ASSERT_EQ(found.contacts.size(), expected.size());
      double worst_mm = 0.0;
      for (std::size_t i = 0; i < expected.size(); ++i)
        worst_mm = std::max(worst_mm, (found.contacts[i] - expected[i]).norm());
      EXPECT_LT(worst_mm, 0.01) << nameOf(coordinates);
      RecordProperty(std::string("worst_mm_") + nameOf(coordinates), std::to_string(worst_mm));
      EXPECT_EQ(found.force, rig_.now().output.axialForce);
    }
  }
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
  const int port = navigation.port();
  const igtl::ImageMessage::Pointer image = inTheMeantime([port] { return imageFrom(port); });

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

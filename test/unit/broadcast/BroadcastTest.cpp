// SPDX-License-Identifier: BSD-3-Clause

// The server, heard by the library's own client over the loopback.

#include "perilymph/broadcast/Broadcast.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <igtlCapabilityMessage.h>
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlMessageHeader.h>
#include <igtlPointMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlSensorMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTransformMessage.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <random>
#include <vector>

#include "perilymph/test/IgtlClient.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::broadcast {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A client that sends bytes of any kind.
class PlainClient {
public:
  /// @param buffer  Bytes that the kernel keeps for it; 0: as many as usual, megabytes.
  explicit PlainClient(std::uint16_t port, int buffer = 0)
      : file_(::socket(AF_INET, SOCK_STREAM, 0))
  {
    if (buffer > 0) ::setsockopt(file_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    isConnected_ = ::connect(file_, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0;
  }
  ~PlainClient() { ::close(file_); }
  PlainClient(const PlainClient&) = delete;
  PlainClient& operator=(const PlainClient&) = delete;

  bool isConnected() const { return isConnected_; }
  void send(const std::vector<std::uint8_t>& bytes)
  {
    [[maybe_unused]] const auto count = ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// A header as the protocol describes it, of any version, without a body and a check sum.
  static std::vector<std::uint8_t> header(int version, const std::string& type,
                                          const std::string& device, std::uint64_t body = 0)
  {
    std::vector<std::uint8_t> bytes(58, 0);
    bytes[1] = static_cast<std::uint8_t>(version);
    std::copy(type.begin(), type.end(), bytes.begin() + 2);
    std::copy(device.begin(), device.end(), bytes.begin() + 14);
    for (std::size_t i = 0; i < 8; ++i)
      bytes[42 + i] = static_cast<std::uint8_t>(body >> (56 - 8 * i));
    return bytes;
  }
  /// A frame was received.
  bool receivedTip() const { return received_.find("PerilymphTip") != std::string::npos; }
  /// Waits for bytes that contain a text.
  bool receives(const std::string& text)
  {
    return test::waitUntil([&] {
      std::array<char, 4096> buffer;
      const ssize_t count = ::recv(file_, buffer.data(), buffer.size(), MSG_DONTWAIT);
      if (count > 0) received_.append(buffer.data(), static_cast<std::size_t>(count));
      return received_.find(text) != std::string::npos;
    });
  }
  /// The server closed the connection; takes what it sent before.
  bool isClosed()
  {
    char buffer[4096];
    ssize_t count = 1;
    while (count > 0) count = ::recv(file_, buffer, sizeof buffer, MSG_DONTWAIT);
    return count == 0 || errno == ECONNRESET;
  }

private:
  int file_;
  bool isConnected_ = false;
  std::string received_;
};

/// A surface of one triangle, so far along x [m].
anatomy::Surface triangleAt(double x)
{
  return {{{x, 0.0, 0.0}, {x, 1e-3, 0.0}, {x, 0.0, 1e-3}}, {{0, 1, 2}}};
}

/// x of W is superior in the patient, y anterior; z of a right ear is to the left. 0.1 m above the
/// patient's origin.
Placement upright(bool isRight = true)
{
  return {{{{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {isRight ? -1.0 : 1.0, 0.0, 0.0}}}, {0.0, 0.0, 0.1}};
}

class OpenIgtLink : public testing::Test {
protected:
  void SetUp() override
  {
    auto started = Broadcast::start({"127.0.0.1", 0}, [this](const std::string& sentence) {
      const std::lock_guard lock(mutex_);
      sentences_.push_back(sentence);
    });
    ASSERT_TRUE(started) << started.error().message;
    server_ = *std::move(started);
    frame_.tip.place_W = {1e-3, -2e-3, 3.5e-3};
    frame_.tip.axis_W = {{{0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    frame_.tweezers.place_W = {0.0, 0.0, 20e-3};
    frame_.contacts = 2;
    frame_.contact_W[0] = {1e-3, 0.0, 0.0};
    frame_.contact_W[1] = {2e-3, 0.0, -1e-3};
    frame_.force_W = {0.01, -0.02, 0.125};
    frame_.axialForce = 0.25;
  }

  igtl::ClientSocket::Pointer client() const
  {
    const std::uint64_t before = server_->figures().accepted;
    auto socket = igtl::ClientSocket::New();
    EXPECT_EQ(socket->ConnectToServer("127.0.0.1", server_->port()), 0);
    socket->SetReceiveTimeout(2000);
    // Frames from before it was accepted would not come.
    EXPECT_TRUE(test::waitUntil([&] { return server_->figures().accepted > before; }));
    return socket;
  }

  /// Publishes frames until the client has received a message of that type, which is unpacked.
  template <class Message>
  typename Message::Pointer receive(igtl::ClientSocket& socket, const std::string& type,
                                    const std::string& name)
  {
    int misses = 0;  // of 2 s each
    for (int i = 0; i < 1'000'000 && misses < 5; ++i) {
      server_->publish(frame_);
      auto header = igtl::MessageHeader::New();
      header->InitPack();
      if (socket.Receive(header->GetPackPointer(), header->GetPackSize()) !=
          header->GetPackSize()) {
        ++misses;
        continue;
      }
      header->Unpack();
      if (header->GetDeviceType() != type || header->GetDeviceName() != name) {
        socket.Skip(header->GetBodySizeToRead());
        continue;
      }
      return test::bodyOf<Message>(socket, header);
    }
    ADD_FAILURE() << "No " << type << " " << name << " came.";
    return Message::New();
  }
  void ask(igtl::ClientSocket& socket, igtl::MessageBase& message, const char* name)
  {
    message.SetDeviceName(name);
    message.Pack();
    EXPECT_EQ(socket.Send(message.GetPackPointer(), message.GetPackSize()), 1);
  }
  /// Largest x of a surface [mm].
  static double farthest(igtl::PolyDataMessage& message)
  {
    double found = -1e3;
    for (int i = 0; i < message.GetPoints()->GetNumberOfPoints(); ++i) {
      float place[3];
      message.GetPoints()->GetPoint(static_cast<unsigned int>(i), place);
      found = std::max(found, double(place[0]));
    }
    return found;
  }
  std::vector<std::string> sentences()
  {
    const std::lock_guard lock(mutex_);
    return sentences_;
  }
  /// The server still sends to a new client.
  void expectAlive()
  {
    const auto socket = client();
    receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip");
  }

  std::mutex mutex_;
  std::vector<std::string> sentences_;
  std::unique_ptr<Broadcast> server_;
  BroadcastFrame frame_;
};

TEST_F(OpenIgtLink, SendsTipAndTweezersInMillimetersWithTheirAxesAsColumns)
{
  const auto socket = client();
  igtl::Matrix4x4 matrix;
  receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip")->GetMatrix(matrix);
  EXPECT_FLOAT_EQ(matrix[0][3], 1.0f);
  EXPECT_FLOAT_EQ(matrix[1][3], -2.0f);
  EXPECT_FLOAT_EQ(matrix[2][3], 3.5f);
  EXPECT_FLOAT_EQ(matrix[1][0], 1.0f);  // x axis along y
  EXPECT_FLOAT_EQ(matrix[0][1], -1.0f);
  receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTweezers")->GetMatrix(matrix);
  EXPECT_FLOAT_EQ(matrix[2][3], 20.0f);
}

TEST_F(OpenIgtLink, SendsContactsAsPointsWithTheirNumbers)
{
  const auto socket = client();
  const auto points = receive<igtl::PointMessage>(*socket, "POINT", "PerilymphContacts");
  ASSERT_EQ(points->GetNumberOfPointElement(), 2);
  igtl::PointElement::Pointer second;
  points->GetPointElement(1, second);
  EXPECT_STREQ(second->GetName(), "E2");
  float place[3];
  second->GetPosition(place);
  EXPECT_FLOAT_EQ(place[0], 2.0f);
  EXPECT_FLOAT_EQ(place[2], -1.0f);
}

TEST_F(OpenIgtLink, SendsTheForceInNewtons)
{
  const auto socket = client();
  const auto force = receive<igtl::SensorMessage>(*socket, "SENSOR", "PerilymphForce");
  ASSERT_EQ(force->GetLength(), 4u);
  EXPECT_EQ(force->GetValue(1), -0.02);
  EXPECT_EQ(force->GetValue(3), 0.25);
  auto newton = igtl::Unit::New();
  newton->Append(igtl::Unit::SI_DERIVED_NEWTON, 1);
  EXPECT_EQ(force->GetUnit(), newton->Pack());
}

TEST_F(OpenIgtLink, SendsTheForceAsTextAndAsATransform)
{
  frame_.time = 1.5;
  frame_.depth = 12.25e-3;
  frame_.tipAngle = 1.0;
  const auto socket = client();
  igtl::Matrix4x4 matrix;
  receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphForceXYZ")->GetMatrix(matrix);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_FLOAT_EQ(matrix[i][3], static_cast<float>(frame_.force_W[i]));
  const auto text = receive<igtl::StringMessage>(*socket, "STRING", "PerilymphReadout");
  EXPECT_EQ(text->GetEncoding(), 3);  // US-ASCII, as IANA numbers it
  EXPECT_STREQ(text->GetString(),
               "time_s=1.5\ntravel_mm=0\ndepth_mm=12.25\ntip_angle_deg=57.29577951308232\n"
               "force_axial_N=0.25\nforce_x_N=0.01\nforce_y_N=-0.02\nforce_z_N=0.125\n"
               "coordinates=cochlea\npatient=unknown\n");
}

TEST_F(OpenIgtLink, NamesTheFrameOfThePoints)
{
  const auto ownerOf = [&] {
    const auto socket = client();
    igtl::PointElement::Pointer first;
    receive<igtl::PointMessage>(*socket, "POINT", "PerilymphContacts")->GetPointElement(0, first);
    return std::string(first->GetOwner());
  };
  EXPECT_EQ(ownerOf(), "cochlea");
  frame_.patient = upright();
  EXPECT_EQ(ownerOf(), "patient");
}

TEST_F(OpenIgtLink, SendsPlacesAndForcesInTheFrameOfThePatient)
{
  for (const bool isRight : {true, false}) {
    frame_.patient = upright(isRight);
    const auto socket = client();
    server_->show(Walls{triangleAt(5e-3), {}}, frame_.patient);
    const float left = isRight ? -1.0f : 1.0f;
    igtl::Matrix4x4 matrix;
    receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip")->GetMatrix(matrix);
    EXPECT_FLOAT_EQ(matrix[0][3], 3.5f * left);
    EXPECT_FLOAT_EQ(matrix[1][3], -2.0f);
    EXPECT_FLOAT_EQ(matrix[2][3], 101.0f);
    EXPECT_FLOAT_EQ(matrix[0][2], left);  // z of the pose is that of W
    const Eigen::Matrix3f axes{{matrix[0][0], matrix[0][1], matrix[0][2]},
                               {matrix[1][0], matrix[1][1], matrix[1][2]},
                               {matrix[2][0], matrix[2][1], matrix[2][2]}};
    EXPECT_FLOAT_EQ(axes.determinant(), 1.0f);  // a rotation in a left ear, too
    receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphForceXYZ")->GetMatrix(matrix);
    EXPECT_FLOAT_EQ(matrix[0][3], 0.125f * left);
    EXPECT_FLOAT_EQ(matrix[2][3], 0.01f);
    const auto force = receive<igtl::SensorMessage>(*socket, "SENSOR", "PerilymphForce");
    EXPECT_EQ(force->GetValue(0), 0.125 * double(left));
    EXPECT_EQ(force->GetValue(3), 0.25);  // along the approach, in any frame
    igtl::PointElement::Pointer second;
    receive<igtl::PointMessage>(*socket, "POINT", "PerilymphContacts")->GetPointElement(1, second);
    float place[3];
    second->GetPosition(place);
    EXPECT_FLOAT_EQ(place[0], -1.0f * left);
    EXPECT_FLOAT_EQ(place[2], 102.0f);
    ask(*socket, *igtl::GetPolyDataMessage::New(), "PerilymphScala");
    const auto scala = receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphScala");
    scala->GetPoints()->GetPoint(0, place);
    EXPECT_FLOAT_EQ(place[2], 105.0f);
    // The outside of the wall stays outside: two corners change places in a mirror.
    igtlUint32 corners[3];
    scala->GetPolygons()->GetCell(0, corners);
    const bool isMirrored =
        Eigen::Matrix3d{{0.0, 0.0, double(left)}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}}.determinant() <
        0.0;
    if (isMirrored)
      EXPECT_THAT(corners, testing::ElementsAre(0u, 2u, 1u));
    else
      EXPECT_THAT(corners, testing::ElementsAre(0u, 1u, 2u));
  }
}

TEST_F(OpenIgtLink, SendsWhatDoesNotMoveOnConnectionAndWhenItChanges)
{
  const auto before = client();
  server_->show(upright());
  server_->show(Walls{triangleAt(1e-3), triangleAt(2e-3)});
  const auto after = client();
  for (const auto& socket : {before, after}) {
    igtl::Matrix4x4 matrix;
    receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphToPatient")->GetMatrix(matrix);
    EXPECT_FLOAT_EQ(matrix[2][0], 1.0f);
    EXPECT_FLOAT_EQ(matrix[2][3], 100.0f);
    EXPECT_NEAR(farthest(*receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphScala")),
                1.0, 1e-5);
    EXPECT_NEAR(
        farthest(*receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphVestibuli")), 2.0,
        1e-5);
  }
  // Another cochlea, of which the patient is not known.
  server_->show(std::optional<Placement>());
  server_->show(Walls{triangleAt(3e-3), {}});
  for (const auto& socket : {before, after})
    EXPECT_NEAR(farthest(*receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphScala")),
                3.0, 1e-5);
  ask(*before, *igtl::GetTransformMessage::New(), "PerilymphToPatient");
  EXPECT_EQ(receive<igtl::StatusMessage>(*before, "STATUS", "PerilymphToPatient")->GetCode(),
            igtl::StatusMessage::STATUS_NOT_READY);
}

TEST_F(OpenIgtLink, SendsNothingOfAnInsertionAfterItIsCleared)
{
  const auto socket = client();
  server_->show(Walls{triangleAt(1e-3), {}});
  receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphScala");
  server_->clear();
  std::string text;
  while (text != "patient=unknown\n" && !HasFailure())
    text = test::receive<igtl::StringMessage>(*socket, "PerilymphReadout")->GetString();
  PlainClient plain(server_->port());
  plain.send(PlainClient::header(1, "GET_POLYDATA", "PerilymphScala"));
  plain.send(PlainClient::header(1, "GET_POINT", "PerilymphContacts"));
  EXPECT_TRUE(plain.receives("There is no PerilymphContacts yet."));
  EXPECT_TRUE(plain.receives("There is no PerilymphScala yet."));
  EXPECT_FALSE(plain.receivedTip());
  expectAlive();
}

TEST_F(OpenIgtLink, SendsTheArrayOfTheNewestFrame)
{
  const auto socket = client();
  ask(*socket, *igtl::GetPolyDataMessage::New(), "PerilymphArray");
  // There is none yet: the request waits for the first frame with an array.
  receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip");
  frame_.nodes = 3;
  for (std::uint32_t i = 0; i < 3; ++i) {
    frame_.node_W[i] = {5e-3f * static_cast<float>(i), 20e-3f, 0.0f};
    frame_.halfWidth[i] = {0.25e-3f, 0.25e-3f};
  }
  const auto first = receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphArray");
  EXPECT_NEAR(farthest(*first), 10.0, 1e-5);
  for (std::uint32_t i = 0; i < 3; ++i) frame_.node_W[i][0] += 2e-3f;
  // Without a request, too, ten times a second.
  double later = 0.0;
  while (later < 11.0 && !HasFailure())
    later = farthest(*receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphArray"));
  EXPECT_NEAR(later, 12.0, 1e-5);
}

TEST_F(OpenIgtLink, SendsBothSurfacesToARequestWithoutAName)
{
  const auto socket = client();
  server_->show(Walls{triangleAt(0.0), {}});
  frame_.nodes = 2;
  frame_.node_W[1] = {5e-3f, 0.0f, 0.0f};
  frame_.halfWidth[0] = frame_.halfWidth[1] = {0.25e-3f, 0.25e-3f};
  ask(*socket, *igtl::GetPolyDataMessage::New(), "");
  const auto scala = receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphScala");
  EXPECT_EQ(scala->GetPolygons()->GetNumberOfCells(), 1u);
  const auto array = receive<igtl::PolyDataMessage>(*socket, "POLYDATA", "PerilymphArray");
  EXPECT_GT(array->GetPolygons()->GetNumberOfCells(), 100u);
}

TEST_F(OpenIgtLink, SendsTheCtToAClientThatAsksForIt)
{
  const auto socket = client();
  ask(*socket, *igtl::GetImageMessage::New(), "PerilymphCT");
  // There is none yet: the request waits for one.
  EXPECT_EQ(receive<igtl::StatusMessage>(*socket, "STATUS", "PerilymphCT")->GetCode(),
            igtl::StatusMessage::STATUS_NOT_READY);
  auto volume = ct::CtVolume::make({3, 4, 5}, Eigen::Matrix4d::Identity(),
                                   std::vector<std::int16_t>(60, -77));
  ASSERT_TRUE(volume);
  PlacedCt ct{std::make_shared<const ct::CtVolume>(*std::move(volume))};
  ct.origin_P = ct.volume->center_P();
  server_->show(*packImage(ct));
  const auto image = receive<igtl::ImageMessage>(*socket, "IMAGE", "PerilymphCT");
  int size[3];
  image->GetDimensions(size);
  EXPECT_THAT(size, testing::ElementsAre(3, 4, 5));
  EXPECT_EQ(*static_cast<const std::int16_t*>(image->GetScalarPointer()), -77);
}

TEST_F(OpenIgtLink, StatesWhatItSends)
{
  const auto socket = client();
  const auto request = PlainClient::header(1, "GET_CAPABIL", "");
  ASSERT_EQ(socket->Send(request.data(), static_cast<int>(request.size())), 1);
  const auto received = receive<igtl::CapabilityMessage>(*socket, "CAPABILITY", "Perilymph");
  EXPECT_THAT(received->GetTypes(), Contains("POLYDATA"));
  EXPECT_THAT(received->GetTypes(), Contains("IMAGE"));
  EXPECT_THAT(received->GetTypes(), Contains("STRING"));
}

TEST_F(OpenIgtLink, AnswersARequestForWhatItDoesNotSendByAStatus)
{
  const auto socket = client();
  ask(*socket, *igtl::GetPolyDataMessage::New(), "Liver");
  const auto unknown = receive<igtl::StatusMessage>(*socket, "STATUS", "Liver");
  EXPECT_EQ(unknown->GetCode(), igtl::StatusMessage::STATUS_NOT_FOUND);
  EXPECT_THAT(unknown->GetStatusString(), HasSubstr("no POLYDATA of this name"));
  PlainClient plain(server_->port());
  plain.send(PlainClient::header(1, "GET_TDATA", "Tracker"));
  EXPECT_TRUE(plain.receives("Perilymph sends no TDATA."));
  ask(*socket, *igtl::GetStatusMessage::New(), "");
  EXPECT_EQ(receive<igtl::StatusMessage>(*socket, "STATUS", "Perilymph")->GetCode(),
            igtl::StatusMessage::STATUS_OK);
  EXPECT_EQ(server_->figures().closed, 0u);
}

// Version 1 and 2 of the protocol have header version 1, version 3 has 2: its body begins with an
// extended header of 12 bytes and ends with metadata. All of them without a check sum.
TEST_F(OpenIgtLink, AnswersClientsOfAllVersions)
{
  server_->show(Walls{triangleAt(0.0), {}});
  for (const int version : {1, 2, 3}) {
    PlainClient plain(server_->port());
    ASSERT_TRUE(plain.receives("PerilymphScala")) << version;  // that of the connection
    auto bytes = PlainClient::header(version, "GET_STATUS", "Wall", version == 1 ? 0 : 16);
    if (version > 1) {
      const std::vector<std::uint8_t> body{0, 12, 0, 2, 0, 0, 0, 2, 0, 0, 0, 7, 0, 0, 0, 0};
      bytes.insert(bytes.end(), body.begin(), body.end());
    }
    plain.send(bytes);
    EXPECT_TRUE(plain.receives("Perilymph sends an insertion.")) << version;
    EXPECT_FALSE(plain.isClosed()) << version;
  }
  EXPECT_THAT(sentences(), IsEmpty());
}

TEST_F(OpenIgtLink, DropsWhatClientsSend)
{
  const auto socket = client();
  for (int i = 0; i < 100; ++i) ask(*socket, *igtl::TransformMessage::New(), "PerilymphTip");
  receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip");
  EXPECT_EQ(server_->figures().closed, 0u);
  EXPECT_THAT(sentences(), IsEmpty());
}

TEST_F(OpenIgtLink, ClosesAClientThatSendsNonsenseWithOneSentence)
{
  PlainClient nonsense(server_->port());
  nonsense.send(std::vector<std::uint8_t>(500, 0xff));
  EXPECT_TRUE(test::waitUntil([&] { return nonsense.isClosed(); }));
  EXPECT_TRUE(test::waitUntil([&] { return server_->figures().clients == 0; }));
  ASSERT_EQ(sentences().size(), 1u);
  EXPECT_THAT(sentences()[0], HasSubstr("The OpenIGTLink client 127.0.0.1:"));
  EXPECT_THAT(sentences()[0], HasSubstr("header has version 65535"));
  expectAlive();
}

TEST_F(OpenIgtLink, SkipsWhatAClientSendsTooMuch)
{
  std::vector<std::uint8_t> header(58, 0);
  header[1] = 1;
  const std::string type = "IMAGE";
  std::copy(type.begin(), type.end(), header.begin() + 2);
  header[46] = 1;  // 2^24 bytes
  PlainClient huge(server_->port());
  huge.send(header);
  huge.send(std::vector<std::uint8_t>(std::size_t{1} << 24, 0x55));
  // It is still a client, and its next message is read: this one is nonsense.
  huge.send(std::vector<std::uint8_t>(58, 0xff));
  EXPECT_TRUE(test::waitUntil([&] { return huge.isClosed(); }));
  ASSERT_TRUE(test::waitUntil([&] { return sentences().size() == 1; }));
  EXPECT_THAT(sentences()[0], HasSubstr("header has version 65535"));
}

TEST_F(OpenIgtLink, SaysWhoCanConnectToAnAddressOfTheNetwork)
{
  for (const char* address : {"0.0.0.0", "::"}) {
    std::vector<std::string> said;
    const auto server = Broadcast::start(
        {address, 0}, [&said](const std::string& sentence) { said.push_back(sentence); });
    if (!server) continue;  // this machine has no such network
    ASSERT_EQ(said.size(), 1u) << address;
    EXPECT_THAT(said[0], HasSubstr("without a password"));
  }
  EXPECT_THAT(sentences(), IsEmpty());  // of the server at 127.0.0.1
}

/// 31 MB: more than the kernel keeps for a client.
PackedImage largeImage()
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.diagonal().head<3>().setConstant(0.15);
  auto volume = ct::CtVolume::make({250, 250, 250}, lps, std::vector<std::int16_t>(15'625'000, 1));
  EXPECT_TRUE(volume);
  PlacedCt ct{std::make_shared<const ct::CtVolume>(*std::move(volume))};
  ct.origin_P = ct.volume->center_P();
  auto image = packImage(ct);
  EXPECT_TRUE(image);
  EXPECT_GT((*image)->size(), 31'000'000u);
  return *image;
}

TEST_F(OpenIgtLink, DoesNotWaitForAClientThatTakesNothing)
{
  PlainClient lazy(server_->port(), 4096);
  ASSERT_TRUE(lazy.isConnected());
  ASSERT_TRUE(test::waitUntil([&] { return server_->figures().clients == 1; }));
  server_->show(largeImage());
  EXPECT_TRUE(test::waitUntil([&] {
    server_->publish(frame_);
    return server_->figures().skipped > 10;
  }));
  expectAlive();
}

// A client that reads receives every frame beside clients that do what they should not. Each frame is
// published when it has the one before: a server that waits for another client would end the test.
TEST_F(OpenIgtLink, LetsNoHostileClientDelayAnother)
{
  const PackedImage image = largeImage();
  const auto good = client();
  PlainClient lazy(server_->port(), 4096);
  PlainClient half(server_->port());
  half.send(std::vector<std::uint8_t>(20, 0));
  PlainClient oversized(server_->port());
  oversized.send(PlainClient::header(1, "IMAGE", "X", 0xffffffffffffffffu));
  PlainClient negative(server_->port());
  negative.send(PlainClient::header(2, "POINT", "X", std::uint64_t{1} << 63));
  ASSERT_TRUE(test::waitUntil([&] { return server_->figures().clients == 5; }));
  server_->show(image);  // lazy takes nothing of it
  // It is for the good one, too, which takes all of it.
  receive<igtl::ImageMessage>(*good, "IMAGE", "PerilymphCT");
  for (int i = 0; i < 50; ++i) {
    PlainClient garbage(server_->port());
    garbage.send(std::vector<std::uint8_t>(3000, static_cast<std::uint8_t>(i)));
    oversized.send(std::vector<std::uint8_t>(100'000, 0x55));
    lazy.send(PlainClient::header(1, "GET_IMAGE", ""));
    frame_.tip.place_W[0] = 1e-3 * (100 + i);
    server_->publish(frame_);
    igtl::Matrix4x4 matrix;
    do {
      const auto tip = test::receive<igtl::TransformMessage>(*good, "PerilymphTip");
      ASSERT_FALSE(HasFailure());
      tip->GetMatrix(matrix);
    } while (matrix[0][3] < 99.5f);  // those of before
    ASSERT_FLOAT_EQ(matrix[0][3], 100.0f + static_cast<float>(i));
  }
  EXPECT_GE(server_->figures().skipped, 50u);  // by the lazy one
}

TEST_F(OpenIgtLink, RemovesAClientThatLeaves)
{
  {
    const auto socket = client();
    receive<igtl::TransformMessage>(*socket, "TRANSFORM", "PerilymphTip");
    socket->CloseSocket();
  }
  EXPECT_TRUE(test::waitUntil([&] {
    server_->publish(frame_);
    return server_->figures().clients == 0;
  }));
  EXPECT_THAT(sentences(), IsEmpty());
}

TEST_F(OpenIgtLink, RefusesTheNinthClient)
{
  std::vector<std::unique_ptr<PlainClient>> clients;
  for (int i = 0; i < 8; ++i) clients.push_back(std::make_unique<PlainClient>(server_->port()));
  EXPECT_TRUE(test::waitUntil([&] { return server_->figures().clients == 8; }));
  PlainClient ninth(server_->port());
  EXPECT_TRUE(test::waitUntil([&] { return ninth.isClosed(); }));
  EXPECT_TRUE(test::waitUntil([&] { return sentences().size() == 1; }));
  EXPECT_THAT(sentences()[0], HasSubstr("8 are connected"));
}

TEST_F(OpenIgtLink, RefusesAPortThatIsTaken)
{
  const auto second = Broadcast::start({"127.0.0.1", server_->port()}, nullptr);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("is taken by another program"));
}

TEST_F(OpenIgtLink, RefusesAnAddressOfAnotherMachine)
{
  // 192.0.2.0/24 is for documentation (RFC 5737).
  const auto server = Broadcast::start({"192.0.2.1", 18944}, nullptr);
  ASSERT_FALSE(server);
  EXPECT_THAT(server.error().message, HasSubstr("not an address of this computer"));
}

TEST_F(OpenIgtLink, SurvivesClientsThatSendRandomBytes)
{
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    PlainClient client(server_->port());
    std::vector<std::uint8_t> bytes(random() % 3000);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    if (round % 2 == 0 && bytes.size() > 2) bytes[0] = 0, bytes[1] = 1;
    client.send(bytes);
    server_->publish(frame_);
  }
  EXPECT_TRUE(test::waitUntil([&] { return server_->figures().clients == 0; }));
  expectAlive();
}

}  // namespace
}  // namespace perilymph::broadcast

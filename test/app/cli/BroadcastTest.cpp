// SPDX-License-Identifier: BSD-3-Clause

// A simulated insertion, received by the client of the OpenIGTLink library.

#include <arpa/inet.h>
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlPolyDataMessage.h>
#include <igtlTransformMessage.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>

#include "Cli.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

/// A port of the loopback that is listened at until the end of the object.
class TakenPort {
public:
  TakenPort() : file_(::socket(AF_INET, SOCK_STREAM, 0))
  {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    EXPECT_EQ(::bind(file_, reinterpret_cast<sockaddr*>(&place), size), 0);
    EXPECT_EQ(::listen(file_, 1), 0);
    ::getsockname(file_, reinterpret_cast<sockaddr*>(&place), &size);
    port_ = ntohs(place.sin_port);
  }
  ~TakenPort() { ::close(file_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  int number() const { return port_; }

private:
  int file_;
  int port_ = 0;
};

int freePort() { return TakenPort().number(); }

/// The next message of a type and device.
template <class Message>
typename Message::Pointer receive(igtl::ClientSocket& socket, const std::string& name)
{
  for (int i = 0; i < 2000; ++i) {
    auto header = igtl::MessageHeader::New();
    header->InitPack();
    const int count = socket.Receive(header->GetPackPointer(), header->GetPackSize());
    if (count != header->GetPackSize()) {
      ADD_FAILURE() << count << " bytes of a header, errno " << errno;
      break;
    }
    header->Unpack();
    if (header->GetDeviceName() != name) {
      socket.Skip(header->GetBodySizeToRead());
      continue;
    }
    auto message = Message::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    socket.Receive(message->GetPackBodyPointer(), message->GetPackBodySize());
    EXPECT_NE(message->Unpack(1), 0) << "the check sum of " << name;
    return message;
  }
  ADD_FAILURE() << "No " << name << " came.";
  return Message::New();
}

TEST(SimulateForNavigation, SendsAnInsertionThatMovesAndTheCochleaOnRequest)
{
  const int port = freePort();
  ChildProcess program(
      cliCall({"simulate", "--scenario", "contour-published", "--igtl", std::to_string(port)}));
  ASSERT_TRUE(program.waitForOutput("Sending to OpenIGTLink clients at 127.0.0.1 port " +
                                        std::to_string(port) + ", in real time.",
                                    std::chrono::minutes(2)));
  auto socket = igtl::ClientSocket::New();
  ASSERT_EQ(socket->ConnectToServer("127.0.0.1", port), 0);
  socket->SetReceiveTimeout(20'000);

  igtl::Matrix4x4 first, later;
  receive<igtl::TransformMessage>(*socket, "PerilymphTip")->GetMatrix(first);
  for (int i = 0; i < 20; ++i)
    receive<igtl::TransformMessage>(*socket, "PerilymphTip")->GetMatrix(later);
  double moved = 0.0;
  for (int i = 0; i < 3; ++i) moved += std::pow(later[i][3] - first[i][3], 2);
  // At least 0.4 s at the scenario's 1 mm/s or more.
  EXPECT_GT(std::sqrt(moved), 0.1);

  auto request = igtl::GetPolyDataMessage::New();
  request->SetDeviceName("");
  request->Pack();
  socket->Send(request->GetPackPointer(), request->GetPackSize());
  const auto scala = receive<igtl::PolyDataMessage>(*socket, "PerilymphScala");
  EXPECT_GT(scala->GetPolygons()->GetNumberOfCells(), 1000u);
  program.send(SIGINT);
  EXPECT_EQ(program.wait(std::chrono::minutes(2)).err, "Interrupted; nothing was written.\n");
}

TEST(SimulateForNavigation, RefusesAPortThatIsTakenAndAnAddressThatIsNone)
{
  const TakenPort taken;
  const auto refused = cli(
      {"simulate", "--scenario", "contour-published", "--igtl", std::to_string(taken.number())});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("is taken by another program"));
  const auto named =
      cli({"simulate", "--scenario", "contour-published", "--igtl", "localhost:18944"});
  EXPECT_EQ(named.status, 1);
  EXPECT_THAT(named.err, HasSubstr("is not numeric"));
}

}  // namespace
}  // namespace perilymph::test

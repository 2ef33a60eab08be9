// SPDX-License-Identifier: BSD-3-Clause

// A simulated insertion, received by the client of the OpenIGTLink library.

#include <igtlPolyDataMessage.h>
#include <igtlTransformMessage.h>

#include <cmath>
#include <csignal>

#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/IgtlClient.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

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

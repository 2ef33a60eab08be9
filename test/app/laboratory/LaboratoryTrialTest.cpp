// SPDX-License-Identifier: BSD-3-Clause

// The test of a device that the command line offers, with each device of a laboratory.

#include <nlohmann/json.hpp>

#include "LaboratoryPeer.h"
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

class ALaboratoryDeviceAtTheCommandLine : public testing::TestWithParam<LaboratoryDevice> {
protected:
  LaboratoryPeer peer_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Of, ALaboratoryDeviceAtTheCommandLine,
                         testing::ValuesIn(laboratoryDevices()),
                         [](const auto& device) { return std::string(device.param.name); });

TEST_P(ALaboratoryDeviceAtTheCommandLine, IsListenedToAndPushesAlongAllItsAxes)
{
  peer_.state().buttons = 1;
  const TemporaryFolder folder;
  const std::string file = folder / "trial.json";
  const auto outcome = cli({"devices", "--plugin", peer_.library().string(), "--json", file});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::cout << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr(GetParam().shown));
  EXPECT_THAT(outcome.out, HasSubstr("rendered on 3 of 3 axes"));
  const auto test = nlohmann::json::parse(contentOf(file))["test"];
  EXPECT_EQ(test["force_axes_shown"], 3);
  // 0.5 N along each axis felt by the hand, and nothing after the last one.
  double largest = 0.0;
  for (std::size_t i = 0; i < peer_.state().count; ++i)
    largest = std::max(largest, peer_.state().log[i].magnitude);
  EXPECT_NEAR(largest, 0.5, 0.01 + GetParam().forceQuantum);
  EXPECT_EQ(peer_.force(), 0.0);
}

TEST_P(ALaboratoryDeviceAtTheCommandLine, ThatIsAbsentIsRefusedWithItsSentence)
{
  peer_.state().fault = PeerState::absent;
  const auto outcome = cli({"devices", "--plugin", peer_.library().string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().absent));
}

}  // namespace
}  // namespace perilymph::test

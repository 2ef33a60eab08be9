// SPDX-License-Identifier: BSD-3-Clause

// What holds for one device of a laboratory alone.

#include "LaboratoryRig.h"
#include "perilymph/haptics/CouplingLimit.h"

namespace perilymph::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

LaboratoryDevice deviceNamed(const std::string& name)
{
  for (const LaboratoryDevice& device : laboratoryDevices())
    if (device.name == name) return device;
  return {};
}

#ifdef PERILYMPH_HAS_FTDI
class AFalcon : public LaboratoryRig {
protected:
  void SetUp() override { use(deviceNamed("Falcon")); }
  void TearDown() override
  {
    LaboratoryRig::TearDown();
    ::unsetenv("PERILYMPH_FALCON_FIRMWARE");
    ::unsetenv("PERILYMPH_FALCON_FORCE_SCALE");
  }
};

TEST_F(AFalcon, WithoutFirmwareAsksForTheUsersCopy)
{
  state().hasFirmware = 0;
  EXPECT_THAT(refusal(), HasSubstr("Set PERILYMPH_FALCON_FIRMWARE"));
}

TEST_F(AFalcon, IsGivenTheFirmwareOfTheUserAndAnswers)
{
  state().hasFirmware = 0;
  const TemporaryFolder folder;
  const std::string path = folder / "firmware.bin";
  std::uint64_t sum = 0;
  std::ofstream file(path, std::ios::binary);
  for (int i = 0; i < 1000; ++i) {  // not a whole number of chunks
    const auto byte = static_cast<unsigned char>(7 * i);
    sum += byte;
    file.put(static_cast<char>(byte));
  }
  file.close();
  ::setenv("PERILYMPH_FALCON_FIRMWARE", path.c_str(), 1);
  ASSERT_NO_FATAL_FAILURE(open());
  EXPECT_EQ(state().firmwareBytes, 1000u);
  EXPECT_EQ(state().firmwareSum, sum);
  EXPECT_TRUE(tickUntil({}, [this] { return newest_.sequence > 0; }));
}

TEST_F(AFalcon, WhoseFirmwareCannotBeReadSaysWhich)
{
  state().hasFirmware = 0;
  ::setenv("PERILYMPH_FALCON_FIRMWARE", "/nothing/firmware.bin", 1);
  const std::string sentence = refusal();
  EXPECT_THAT(sentence, HasSubstr("/nothing/firmware.bin, cannot be read"));
  EXPECT_TRUE(isOneSentence(sentence)) << sentence;
}

TEST_F(AFalcon, HasNeitherPositionNorForceBeforeItIsHomed)
{
  state().isReady = 0;
  ASSERT_NO_FATAL_FAILURE(open());
  tickFor(pushed, milliseconds(300));
  EXPECT_EQ(newest_.sequence, 0u);
  EXPECT_EQ(peer_->force(), 0.0);
  state().isReady = 1;  // the grip was pulled out and pushed in
  EXPECT_TRUE(tickUntil({}, [this] { return newest_.sequence > 0; }));
  EXPECT_NEAR(newest_.position_D[2], 0.0, 1e-4);
}

TEST_F(AFalcon, LeavesNoAnswersBehindThatCameTooLate)
{
  // Each would delay all later positions by an exchange.
  ASSERT_NO_FATAL_FAILURE(push());
  state().fault = PeerState::silent;
  tickFor(pushed, milliseconds(300));
  EXPECT_GT(state().unread, 0u);
  state().fault = PeerState::none;
  EXPECT_TRUE(tickUntil(pushed, [this] { return peer_->force() > 0.4; }));
  tickFor(pushed, milliseconds(100));
  EXPECT_EQ(state().unread, 0u);
}

TEST_F(AFalcon, IsCorrectedByItsMeasuredForce)
{
  ::setenv("PERILYMPH_FALCON_FORCE_SCALE", "2", 1);
  ASSERT_NO_FATAL_FAILURE(open());
  EXPECT_TRUE(tickUntil(pushed, [this] { return std::fabs(peer_->force() - 1.0) < 4e-3; }));
}

TEST_F(AFalcon, RefusesAScaleThatIsNone)
{
  for (const char* wrong : {"", "a", "0", "1.5x", "11", "nan"}) {
    ::setenv("PERILYMPH_FALCON_FORCE_SCALE", wrong, 1);
    EXPECT_THAT(refusal(), HasSubstr("a number from 0.1 to 10")) << wrong;
  }
}
#endif

class AnInverse3 : public LaboratoryRig {
protected:
  void SetUp() override { use(deviceNamed("Inverse3")); }
};

TEST_F(AnInverse3, MeasuresTheDelayOfItsServiceWhichSoftensTheCoupling)
{
  ASSERT_NO_FATAL_FAILURE(load());
  const device::DeviceTraits fast = device_->traits();
  state().answerDelay = 8'000'000;  // [ns]
  ASSERT_NO_FATAL_FAILURE(load());
  const device::DeviceTraits slow = device_->traits();
  EXPECT_GE(slow.transportDelay, 8e-3);
  EXPECT_LT(fast.transportDelay, slow.transportDelay);
  // K = 3/4 b / (T/2 + delay) with b = 0.5 N.s/m, T = 1 ms: below 44 N/m for 8 ms.
  EXPECT_LT(haptics::couplingLimit(slow, 1e-3).stiffness, 0.375 / 8.5e-3);
  EXPECT_GT(haptics::couplingLimit(fast, 1e-3).stiffness,
            haptics::couplingLimit(slow, 1e-3).stiffness);
  std::cout << "Inverse3: delay " << 1e3 * fast.transportDelay << " ms, coupling "
            << haptics::couplingLimit(fast, 1e-3).stiffness << " N/m\n";
}

TEST_F(AnInverse3, WithoutAGripSaysWhatItIsNeededFor)
{
  state().isReady = 0;
  EXPECT_THAT(refusal(), HasSubstr("no VerseGrip, whose button is needed"));
}

TEST_F(AnInverse3, WithoutItsServiceSaysWhereItWasSought)
{
  const std::string port = std::to_string(peer_->service()->port());
  peer_->service()->end();
  const std::string sentence = refusal();
  EXPECT_THAT(sentence, HasSubstr("does not answer at 127.0.0.1:" + port));
  EXPECT_TRUE(isOneSentence(sentence)) << sentence;
}

TEST_F(AnInverse3, WhoseServiceEndsIsLost)
{
  ASSERT_NO_FATAL_FAILURE(push());
  peer_->service()->end();
  EXPECT_TRUE(tickUntil(pushed, [this] { return newest_.isValid == 0; }));
  EXPECT_TRUE(tickUntil(pushed, [this] { return !error().empty(); }));
}

TEST_F(AnInverse3, TurnsWithItsGrip)
{
  state().turn = 0.6;
  ASSERT_NO_FATAL_FAILURE(open());
  // About z by 0.6: w = cos 0.3, z = sin 0.3.
  EXPECT_TRUE(tickUntil({}, [this] {
    return std::fabs(newest_.rotation_D[0] - std::cos(0.3)) < 1e-9 &&
           std::fabs(newest_.rotation_D[3] - std::sin(0.3)) < 1e-9;
  })) << newest_.rotation_D[3];
}

class ATouch : public LaboratoryRig {
protected:
  void SetUp() override { use(deviceNamed("Touch")); }
};

TEST_F(ATouch, ThatIsNotCalibratedSaysHow)
{
  state().isReady = 0;
  EXPECT_THAT(refusal(), HasSubstr("put its stylet into the inkwell"));
}

TEST_F(ATouch, RendersNoMoreThanItsDriverStates)
{
  state().driverLimit = 1.2;
  ASSERT_NO_FATAL_FAILURE(open());
  EXPECT_TRUE(tickUntil({0.0, 3.0, 0.0}, [this] { return peer_->force() > 1.19; }));
  tickFor({0.0, 3.0, 0.0}, milliseconds(50));
  EXPECT_NEAR(peer_->force(), 1.2, 1e-9);
}

TEST_F(ATouch, TurnsWithItsStylet)
{
  for (const double turn : {0.6, 3.0, -2.5}) {  // also where w is small
    state().turn = turn;
    if (!device_) open();
    EXPECT_TRUE(tickUntil({}, [&] {
      const double sign = newest_.rotation_D[0] * std::cos(0.5 * turn) < 0.0 ? -1.0 : 1.0;
      return std::fabs(sign * newest_.rotation_D[0] - std::cos(0.5 * turn)) < 1e-9 &&
             std::fabs(sign * newest_.rotation_D[3] - std::sin(0.5 * turn)) < 1e-9;
    })) << turn;
  }
}

}  // namespace
}  // namespace perilymph::test

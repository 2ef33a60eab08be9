// SPDX-License-Identifier: BSD-3-Clause

// The Falcon's mechanism and packets against closed forms and documented examples.

#include "FalconKinematics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FalconModel.h"
#include "FalconPackets.h"

namespace perilymph::novint {
namespace {

using test::forceOf;
using test::thighAngle;

constexpr double centerZ = 0.125;

/// Positions over the workspace of 80 mm.
std::vector<Vector> workspace()
{
  std::vector<Vector> places;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k)
        if (i * i + j * j + k * k <= 16) places.push_back({0.01 * i, 0.01 * j, centerZ + 0.01 * k});
  return places;
}

Vector anglesAt(const Vector& place)
{
  return {thighAngle(0, place), thighAngle(1, place), thighAngle(2, place)};
}

TEST(FalconMechanism, FindsThePositionOfWhichTheLawOfCosinesGaveTheAngles)
{
  const FalconKinematics falcon;
  ASSERT_GT(workspace().size(), 250u);
  for (const Vector& place : workspace()) {
    const auto found = falcon.position(anglesAt(place), {0.0, 0.0, centerZ});
    ASSERT_TRUE(found);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((*found)[k], place[k], 1e-9);
  }
}

TEST(FalconMechanism, IsOnItsAxisWhereAllAnglesAreEqual)
{
  // There each arm is the same triangle: z = a sin q + sqrt(l^2 - (r - c + a cos q)^2), by the lengths
  // of libnifalcon; sideways -23.09 mm and -25 mm leave 1.91 mm.
  const FalconKinematics falcon;
  const double length = 0.0225 + std::sqrt(0.1025 * 0.1025 - 0.00191 * 0.00191);
  for (double degrees = -20.0; degrees <= 70.0; degrees += 5.0) {
    const double q = degrees / 180.0 * 3.14159265358979323846;
    const double across = 0.040 - 0.01443 + 0.060 * std::cos(q);
    const double z = 0.060 * std::sin(q) + std::sqrt(length * length - across * across);
    const auto found = falcon.position({q, q, q}, {0.0, 0.0, centerZ});
    ASSERT_TRUE(found) << degrees;
    EXPECT_NEAR((*found)[0], 0.0, 1e-9);
    EXPECT_NEAR((*found)[1], 0.0, 1e-9);
    EXPECT_NEAR((*found)[2], z, 1e-9);
  }
}

TEST(FalconMechanism, LosesNoPowerBetweenHandAndMotors)
{
  // F . v = torque . dq/dt for any motion, dq by differences of the closed form.
  const FalconKinematics falcon;
  const Vector force = {1.3, -0.7, 2.1};
  for (const Vector& place : workspace()) {
    const Vector torques = falcon.torques(anglesAt(place), place, force);
    for (const Vector& way : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0.3, -0.5, 0.8}}) {
      constexpr double step = 1e-6;
      Vector before = place, after = place;
      for (std::size_t k = 0; k < 3; ++k) {
        before[k] -= step * way[k];
        after[k] += step * way[k];
      }
      double byMotors = 0.0, byHand = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        byMotors += torques[i] * (thighAngle(i, after) - thighAngle(i, before)) / (2.0 * step);
        byHand += force[i] * way[i];
      }
      EXPECT_NEAR(byMotors, byHand, 1e-7);
    }
    const Vector felt = forceOf(torques, place);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(felt[k], force[k], 1e-7);
  }
}

TEST(FalconMechanism, HasNoPositionForAnglesThatItCannotTake)
{
  // A thigh straight up and two straight down tear it apart.
  EXPECT_FALSE(FalconKinematics().position({1.57, -1.57, -1.57}, {0.0, 0.0, centerZ}));
}

TEST(FalconMechanism, StandsAtThirtyFiveDegreesAtHomeAndTurnsByItsGear)
{
  EXPECT_NEAR(armAngle(0), 35.0 / 180.0 * 3.14159265358979323846, 1e-15);
  // A turn of the motor's shaft is 1280 counts, and turns the thigh by 14.25 / 110 of a turn.
  EXPECT_NEAR(armAngle(1280) - armAngle(0), 2.0 * 3.14159265358979323846 * 14.25 / 110.0, 1e-12);
}

Packet packetOf(const char* text)
{
  Packet packet;
  std::copy_n(text, 16, packet.begin());
  return packet;
}

TEST(FalconPacket, ReadsTheEncoderOfTheDocumentedExample)
{
  // libnifalcon, FalconFirmwareNovintSDK.h: the bytes 4A 46 4B 50 are 0xFA59, minus 1447.
  const auto state = decoded(packetOf("<JFKPAAAAAAAAAA>"));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->encoders, (Counts{-1447, 0, 0}));
  EXPECT_FALSE(state->isHomed);
  EXPECT_EQ(state->buttons, 0u);
}

TEST(FalconPacket, WithoutForcesIsTheDocumentedEmptyOneButForHoming)
{
  const Packet packet = encoded({0, 0, 0}, 0);
  EXPECT_EQ(std::string(packet.begin(), packet.end()), "<AAAAAAAAAAAABA>");
}

TEST(FalconPacket, CarriesNumbersOfSixteenBits)
{
  for (const int value : {-4096, -1, 0, 1, 1447, 4096}) {
    const Packet packet = encoded({value, -value, value / 2}, 0);
    const auto back = decoded(packet);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->encoders, (Counts{value, -value, value / 2}));
  }
}

TEST(FalconPacket, TellsButtonsAndHoming)
{
  // Buttons in the low half, the three encoders' marks above it; all letters count from 'A'.
  std::string text = "<AAAAAAAAAAAAAA>";
  text[13] = static_cast<char>('A' + 0x74);
  const auto state = decoded(packetOf(text.c_str()));
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->isHomed);
  EXPECT_EQ(state->buttons, 4u);
  text[13] = static_cast<char>('A' + 0x30);
  EXPECT_FALSE(decoded(packetOf(text.c_str()))->isHomed);
}

TEST(FalconPacket, ThatIsDamagedIsNone)
{
  EXPECT_FALSE(decoded(packetOf("AAAAAAAAAAAAAAA>")));
  EXPECT_FALSE(decoded(packetOf("<AAAAAAAAAAAAAAA")));
  EXPECT_FALSE(decoded(packetOf("<A@AAAAAAAAAAAA>")));
  EXPECT_FALSE(decoded(packetOf("<AQAAAAAAAAAAAA>")));
}

}  // namespace
}  // namespace perilymph::novint

// SPDX-License-Identifier: BSD-3-Clause

// With any samples of a device the force stays finite, within its limit, and without steps.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

using Kind = Command::Kind;

constexpr double rounding = 1e-9;

/// A faulty device: every few ticks another kind of invalid samples.
class HostileDevice {
public:
  explicit HostileDevice(unsigned seed) : random_(seed) {}

  device::DeviceSample next()
  {
    if (random_() % 50 == 0) mood_ = random_() % 10;
    device::DeviceSample sample;
    place_ -= 20e-6;
    sample.sequence = ++sequence_;
    sample.position_D = {0.0, 0.0, place_};
    sample.buttons = device::graspButton;
    sample.isValid = 1;
    const auto axis = random_() % 3;
    switch (mood_) {
      case 0:
        sample.position_D[axis] = std::nan("");
        break;
      case 1:
        sample.position_D[axis] = (random_() % 2 == 0 ? 1.0 : -1.0) * infinity;
        break;
      case 2:
        sample.position_D[axis] = 1e300;
        break;
      case 3:
        place_ += (random_() % 2 == 0 ? 1.0 : -1.0) * 3.0;
        break;  // meters
      case 4:
        sample.rotation_D = {0.0, 0.0, 0.0, 0.0};
        break;
      case 5:
        sample.rotation_D = {infinity, 0.0, std::nan(""), 1.0};
        break;
      case 6:
        sample.sequence = --sequence_;
        break;  // stale
      case 7:
        sample.isValid = random_() % 20 == 0 ? 0u : 1u;
        break;
      case 8:
        sample.buttons = static_cast<std::uint32_t>(random_());
        break;
      default:
        break;  // valid for a while
    }
    if (std::abs(place_) > 8.0) place_ = 0.0;
    return sample;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::mt19937 random_;
  unsigned long mood_ = 9;
  std::uint64_t sequence_ = 1;
  double place_ = 0.0;
};

/// Random commands with any values.
CommandList anyCommands(std::mt19937& random)
{
  CommandList list;
  if (random() % 300 != 0) return list;
  list.count = random() % 12 == 0 ? 4'000'000'000u : 2u;  // more than the capacity
  for (Command& command : list.items) {
    command.kind = static_cast<Kind>(random() % 11);
    const double values[] = {0.0, 1.0, -1.0, 1e-3, 1e300, std::nan("")};
    command.value = values[random() % 6];
  }
  return list;
}

class HostileSamples : public testing::TestWithParam<mechanics::Coupling> {};

TEST_P(HostileSamples, NeverGiveAForceThatIsNotFiniteOrTooGreatOrAStep)
{
  EngineSettings settings;
  settings.coupling = GetParam();
  settings.forceScale = 100.0;  // so that the limits are reached
  const double maxStep = settings.safety.maxSlew * 1e-3;
  const double maxForce = settings.safety.maxForce;
  const double maxFall = std::max(maxStep, maxForce * 1e-3 / settings.safety.offTime);

  double greatest = 0.0;
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::optional<InsertionEngine> engine;
    int ticksInFault = 0;
    HostileDevice device(seed);
    std::mt19937 random(seed + 100);
    Eigen::Vector3d before_D = Eigen::Vector3d::Zero();
    for (int i = 0; i < 10'000; ++i) {
      // After a fault another insertion begins, without force.
      if (!engine || (ticksInFault > 20 && before_D.isZero())) {
        engine.emplace(test::insertionInRing(), settings);
        ticksInFault = 0;
      }
      CommandList commands = anyCommands(random);
      if (engine->workflow() == Workflow::fault) ++ticksInFault;
      if (commands.count == 0) {
        commands.count = 2;
        commands.items[0].kind = Kind::arm;
        commands.items[1].kind = i % 20 == 0 ? Kind::resume : Kind::none;
      }
      const TickOutput output = engine->tick(device.next(), commands);
      const auto& force = output.wrench_D.force_D;
      const Eigen::Vector3d now_D(force[0], force[1], force[2]);
      ASSERT_TRUE(now_D.allFinite()) << "seed " << seed << ", tick " << i;
      ASSERT_LE(now_D.norm(), maxForce * (1.0 + rounding)) << "seed " << seed << ", tick " << i;
      // A force that is switched off may fall faster: to zero within offTime.
      const bool isEnding = now_D.norm() < before_D.norm();
      ASSERT_LE((now_D - before_D).norm(), (isEnding ? maxFall : maxStep) * (1.0 + rounding))
          << "seed " << seed << ", tick " << i;
      ASSERT_TRUE(std::isfinite(output.travel)) << "seed " << seed << ", tick " << i;
      before_D = now_D;
      greatest = std::max(greatest, now_D.norm());
    }
  }
  EXPECT_GT(greatest, 0.01);  // there were forces
}

TEST_P(HostileSamples, NeverMoveTheArrayByAJump)
{
  EngineSettings settings;
  settings.coupling = GetParam();
  InsertionEngine engine(test::insertionInTube(), settings);
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  CommandList arm;
  arm.count = 1;
  arm.items[0].kind = Kind::arm;
  engine.tick(sample, arm);
  std::mt19937 random(5);
  double before = engine.state().base_W.z();
  for (int i = 0; i < 2000; ++i) {
    ++sample.sequence;
    // the hand jumps to any position within a meter
    for (double& x : sample.position_D) x = static_cast<double>(random() % 2001) * 1e-3 - 1.0;
    engine.tick(sample, {});
    ASSERT_NEAR(engine.state().base_W.z(), before, 1.0 * 1e-3) << i;  // 1 m/s
    before = engine.state().base_W.z();
  }
}

TEST_P(HostileSamples, ASilentDeviceTakesTheForceToZeroAndBackWithoutASnap)
{
  EngineSettings settings;
  settings.coupling = GetParam();
  InsertionEngine engine(test::insertionInRing(), settings);
  device::DeviceSample sample;
  sample.isValid = 1;
  sample.buttons = device::graspButton;
  CommandList arm;
  arm.count = 1;
  arm.items[0].kind = Kind::arm;
  engine.tick(sample, arm);
  TickOutput output;
  for (int i = 0; i < 4000; ++i) {
    ++sample.sequence;
    sample.position_D[2] -= 2e-6;
    output = engine.tick(sample, {});
  }
  ASSERT_GT(output.wrench_D.force_D[2], 1e-3);
  ASSERT_LT(output.wrench_D.force_D[2], 0.1);  // so that one tick takes it to zero

  // two ticks without a new sample are jitter, the third is silence
  for (int i = 0; i < 2; ++i) EXPECT_EQ(engine.tick(sample, {}).status & staleSample, 0u);
  output = engine.tick(sample, {});
  EXPECT_NE(output.status & staleSample, 0u);
  EXPECT_EQ(output.wrench_D.force_D, (std::array<double, 3>{}));

  ++sample.sequence;
  output = engine.tick(sample, {});
  EXPECT_EQ(output.status & staleSample, 0u);
  ++sample.sequence;
  output = engine.tick(sample, {});
  EXPECT_NE(output.status & rampingIn, 0u);
  EXPECT_LT(output.wrench_D.force_D[2], 0.01 * output.force_W[2]);
}

INSTANTIATE_TEST_SUITE_P(Couplings, HostileSamples,
                         testing::Values(mechanics::Coupling::rigid, mechanics::Coupling::spring),
                         [](const auto& coupling) {
                           return coupling.param == mechanics::Coupling::rigid ? "Rigid" : "Spring";
                         });

}  // namespace
}  // namespace perilymph::haptics

// SPDX-License-Identifier: BSD-3-Clause

// Oracles: the passivity bound of Colgate and Schenkel, b > K T / 2, with a delay, by hand; and a
// separate integration of a handle on a sampled, delayed spring.

#include "perilymph/haptics/CouplingLimit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"

namespace perilymph::haptics {
namespace {

device::DeviceTraits forceDevice(double delay)
{
  device::DeviceTraits traits;
  traits.name = "Hand";
  traits.rendersForce = true;
  traits.maxForce = 3.3;
  traits.handleDamping = 0.5;
  traits.handleMass = 0.09;
  traits.transportDelay = delay;
  return traits;
}

TEST(CouplingLimit, IsNoneForAHandThatFeelsNothing)
{
  const CouplingLimit limit = couplingLimit({}, 1e-3);
  EXPECT_TRUE(std::isinf(limit.stiffness));
  EXPECT_TRUE(std::isinf(limit.damping));
}

TEST(CouplingLimit, IsThreeQuartersOfThePassiveStiffnessAtTheMeasuredDelay)
{
  // 0.75 b / (T/2 + td) = 0.75 x 0.5 / (0.0005 + 0.0017)
  EXPECT_NEAR(couplingLimit(forceDevice(1.7e-3), 1e-3).stiffness, 170.45, 0.01);
  EXPECT_NEAR(couplingLimit(forceDevice(0.0), 1e-3).stiffness, 750.0, 1e-9);
}

TEST(CouplingLimit, CountsTheWaitForATickThatReportsDoNotBegin)
{
  // ticks of 0.1 ms, reports of 1 ms: 0.75 x 0.5 / (0.00005 + 0.0005)
  EXPECT_NEAR(couplingLimit(forceDevice(0.0), 1e-4).stiffness, 681.82, 0.01);
}

TEST(CouplingLimit, CountsHalfAPeriodForEveryDeviceThatTicksDoNotFollow)
{
  // 0.75 b / (T/2 + P/2), whether the device is faster, slower, or only reports changes
  device::DeviceTraits traits = forceDevice(0.0);
  for (const double period : {0.5e-3, 2e-3}) {
    traits.nominalPeriod = period;
    EXPECT_NEAR(couplingLimit(traits, 1e-3).stiffness, 0.375 / (0.5e-3 + 0.5 * period), 1e-9);
  }
  traits.nominalPeriod = 1e-3;
  traits.reporting = device::Reporting::onWrite;
  EXPECT_NEAR(couplingLimit(traits, 1e-3).stiffness, 375.0, 1e-9);
}

TEST(CouplingLimit, AssumesALightAndUndampedHandleWhereNothingIsKnown)
{
  device::DeviceTraits unknown = forceDevice(1e-3);
  unknown.handleDamping = 0.0;
  unknown.handleMass = 0.0;
  const CouplingLimit limit = couplingLimit(unknown, 1e-3);
  EXPECT_EQ(limit.stiffness, couplingLimit(forceDevice(1e-3), 1e-3).stiffness);
  EXPECT_EQ(limit.damping, couplingLimit(forceDevice(1e-3), 1e-3).damping);
}

// Measured with a handle of 90 g and 0.5 N.s/m at a wall of 441 N/m, without damping by the host:
// peak-to-peak motion 0.012 mm with 30 us or 0.15 ms per report, 0.55 mm with 0.98 ms per report,
// 21.8 mm where a force needs three such reports; the last still 3.9 mm at 100 N/m.
TEST(CouplingLimit, AgreesWithWhatWasMeasuredOfFourWires)
{
  const auto limitAt = [](double write) {
    return couplingLimit(forceDevice(2.0 * write), 1e-3).stiffness;
  };
  EXPECT_GT(limitAt(0.03e-3), 441.0);
  EXPECT_GT(limitAt(0.15e-3), 441.0);
  EXPECT_LT(limitAt(0.98e-3), 441.0);
  EXPECT_LT(limitAt(2.995e-3), 100.0);
}

TEST(CouplingLimit, HoldsTheMakersBounds)
{
  device::DeviceTraits traits = forceDevice(0.0);
  traits.maxStiffness = 400.0;
  traits.maxDamping = 1.5;
  EXPECT_EQ(couplingLimit(traits, 1e-3).stiffness, 400.0);
  EXPECT_EQ(couplingLimit(traits, 1e-3).damping, 1.5);
  // a manufacturer's bound above what the delay allows changes nothing
  traits.maxStiffness = 5000.0;
  EXPECT_NEAR(couplingLimit(traits, 1e-3).stiffness, 750.0, 1e-9);
}

TEST(CouplingLimit, DescribesRequestedAndActualStiffnessAndTheReason)
{
  const CouplingLimit limit = couplingLimit(forceDevice(1.7e-3), 1e-3);
  EXPECT_EQ(
      couplingSentence(441.0, limit, "Hand"),
      "Hand renders 170 N/m of the 441 N/m asked for, because a force reaches the hand 2.20 ms "
      "late. What is felt is softer; the forces that are recorded stay physical.");
  EXPECT_EQ(couplingSentence(170.0, limit, "Hand"), "");
}

/// A spring and a damper by the smoothed velocity, sampled each tick, as the engine renders them.
class SampledCoupling {
public:
  SampledCoupling(double stiffness, double damping, double timeStep)
      : stiffness_(stiffness),
        damping_(damping),
        timeStep_(timeStep),
        fraction_(timeStep / (SampleValidator::velocityLag + timeStep))
  {
  }

  double force(double place)
  {
    velocity_ += fraction_ * ((place - before_) / timeStep_ - velocity_);
    before_ = place;
    return -stiffness_ * place - damping_ * velocity_;
  }

private:
  double stiffness_, damping_, timeStep_, fraction_;
  double before_ = 0.0, velocity_ = 0.0;
};

/// A handle pushed with 0.2 N against a coupling that is sampled each tick and acts `delay` later, on
/// touch only: its peak-to-peak motion in the last of twenty seconds [m].
double trembling(const device::DeviceTraits& traits, double stiffness, double timeStep,
                 double damping = 0.0)
{
  constexpr double step = 1e-5;  // [s]
  const auto stepsPerTick = static_cast<int>(std::lround(timeStep / step));
  const auto delayed = static_cast<std::size_t>(std::lround(traits.transportDelay / step));
  std::deque<double> forces(delayed + 1, 0.0);
  SampledCoupling coupling(stiffness, damping, timeStep);
  double place = 0.0, speed = 0.0, held = 0.0, minimum = 1.0, maximum = -1.0;
  for (int i = 0; i < 2'000'000; ++i) {
    if (i % stepsPerTick == 0) held = std::min(coupling.force(std::max(place, 0.0)), 0.0);
    forces.push_back(held);
    const double force = 0.2 + forces.front() - traits.handleDamping * speed;
    forces.pop_front();
    speed += step * force / traits.handleMass;
    place += step * speed;
    if (i < 1'900'000) continue;
    minimum = std::min(minimum, place);
    maximum = std::max(maximum, place);
  }
  return maximum - minimum;
}

TEST(CouplingLimit, KeepsAFreeHandleStillAgainstAWallWithAndWithoutTheShippedDamping)
{
  for (const double delay : {0.0, 0.5e-3, 1.7e-3, 3.5e-3})
    for (const double damping : {0.0, 1.0}) {
      const device::DeviceTraits traits = forceDevice(delay);
      const CouplingLimit limit = couplingLimit(traits, 1e-3);
      EXPECT_LE(damping, limit.damping) << delay;
      const double deflection = 0.2 / limit.stiffness;
      EXPECT_LT(trembling(traits, limit.stiffness, 1e-3, damping), 0.01 * deflection)
          << delay << ", damping " << damping;
    }
}

/// Energy that a coupling gives a handle, as part of what a damper of 1 N.s/m takes from it. The handle is at
/// places of a sine at the ticks and moves evenly between them, which costs it least: a straight sum over
/// time, no transform.
double givenBack(double stiffness, double damping, double delay, double turn)
{
  constexpr double timeStep = 1e-3, parts = 20.0;
  constexpr int ticks = 2'400, settled = 400;
  SampledCoupling coupling(stiffness, damping, timeStep);
  std::deque<double> forces(static_cast<std::size_t>(std::lround(delay / timeStep * parts)), 0.0);
  // a phase that drifts meets all places between ticks and motion at the highest frequency, too
  const auto placeAt = [turn](int tick) {
    return std::sin(turn * tick + 2.0 * pi * tick / (ticks - settled));
  };
  double given = 0.0, byDamper = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    const double held = coupling.force(placeAt(tick));
    const double moved = (placeAt(tick + 1) - placeAt(tick)) / parts;
    for (int i = 0; i < static_cast<int>(parts); ++i) {
      forces.push_back(held);
      if (tick >= settled) {
        given += forces.front() * moved;
        byDamper += moved * moved * parts / timeStep;
      }
      forces.pop_front();
    }
  }
  return given / byDamper;
}

TEST(PassiveHandleDamping, IsWhatTheWorstFrequencyGivesBack)
{
  struct Case {
    double stiffness, damping, delay;
    double above;  ///< The bound is exact without delay, and on the safe side of it with one.
  };
  for (const auto& [stiffness, damping, delay, above] :
       {Case{750.0, 0.0, 0.0, 1.001}, Case{750.0, 1.0, 0.0, 1.001}, Case{375.0, 1.0, 0.5e-3, 1.2},
        Case{170.0, 1.0, 1.7e-3, 1.1}}) {
    const double needed = passiveHandleDamping(stiffness, damping, delay, 1e-3);
    double worst = 0.0;
    for (int k = 1; k < 50; ++k)
      worst = std::max(worst, givenBack(stiffness, damping, delay, pi * k / 50.0));
    EXPECT_GE(needed, 0.999 * worst) << stiffness << ", " << damping << ", " << delay;
    EXPECT_LE(needed, above * worst) << stiffness << ", " << damping << ", " << delay;
  }
}

TEST(PassiveHandleDamping, IsHalfAStepOfTheSpringWithoutDelay)
{
  EXPECT_NEAR(passiveHandleDamping(750.0, 0.0, 0.0, 1e-3), 0.375, 1e-6);
  // the shipped damping of 1 N.s/m is stable, but not passive in a light handle of 0.5 N.s/m
  EXPECT_GT(passiveHandleDamping(750.0, 1.0, 0.0, 1e-3), 0.5);
  EXPECT_LT(passiveHandleDamping(441.0, 0.125, 0.0, 1e-3), 0.5);
}

TEST(CouplingLimit, IsNearTheStabilityLimit)
{
  const device::DeviceTraits traits = forceDevice(1.7e-3);
  EXPECT_GT(trembling(traits, 2.0 * couplingLimit(traits, 1e-3).stiffness, 1e-3), 1e-4);
}

TEST(SoftenedCoupling, IsLimitedByTheDevice)
{
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  settings.couplingStiffness = 441.0;
  settings.maxStiffness = 220.5;
  test::InsertionRig rig(test::insertionInRing(), settings, millimetersPerSecond(10));
  EXPECT_DOUBLE_EQ(rig.engine().couplingStiffness(), 220.5);
  rig.start();
  for (int i = 0; i < 1000 && rig.output().workflow != Workflow::inserting; ++i) rig.tick();
  ASSERT_EQ(rig.output().workflow, Workflow::inserting);
  EXPECT_NE(rig.tick().output.status & couplingSoftened, 0u);
}

TEST(SoftenedCoupling, IsLimitedForMagnifiedForces)
{
  // 2 x 441 N/m at the hand. The device renders 441 N/m, so the spring is half as stiff.
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  settings.couplingStiffness = 441.0;
  settings.maxStiffness = 441.0;
  EXPECT_DOUBLE_EQ(
      test::InsertionRig(test::insertionInTube(), settings).engine().couplingStiffness(), 441.0);
  settings.forceScale = 2.0;
  EXPECT_DOUBLE_EQ(
      test::InsertionRig(test::insertionInTube(), settings).engine().couplingStiffness(), 220.5);
}

TEST(SoftenedCoupling, StaysAsRequestedWhereTheDeviceRendersIt)
{
  EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  settings.maxStiffness = 1000.0;
  test::InsertionRig rig(test::insertionInTube(), settings);
  rig.start();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(rig.tick().output.status & couplingSoftened, 0u);
}

}  // namespace
}  // namespace perilymph::haptics

// SPDX-License-Identifier: BSD-3-Clause

// The virtual handle's motion compared with independent solutions of Newton's law.

#include "SlidingHandle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/test/Tolerance.h"

namespace perilymph::hidstack {
namespace {

constexpr HandleBody body;

/// m dv/dt = F - b v from rest, integrated by fourth-order Runge-Kutta.
struct Slide {
  double position = 0.0;
  double velocity = 0.0;
};
Slide slideFor(double duration, double force)
{
  constexpr int steps = 1000;
  const double h = duration / steps;
  const auto acceleration = [&](double v) { return (force - body.damping * v) / body.mass; };
  Slide slide;
  for (int i = 0; i < steps; ++i) {
    const double v = slide.velocity;
    const double k1 = acceleration(v), k2 = acceleration(v + 0.5 * h * k1);
    const double k3 = acceleration(v + 0.5 * h * k2), k4 = acceleration(v + h * k3);
    slide.position += h * v + h * h / 6.0 * (k1 + k2 + k3);
    slide.velocity += h / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return slide;
}

SlidingHandle pushedHandle(double push)
{
  SlidingHandle handle(body);
  handle.hold(false);
  handle.push(push);
  return handle;
}

TEST(SlidingHandle, MovesAsNewtonsLawSays)
{
  SlidingHandle handle = pushedHandle(0.2);
  handle.advanceTo(0.1);
  const Slide slide = slideFor(0.1, 0.2);
  EXPECT_NEAR(handle.position(), slide.position, test::tolerance(1e-12, "Runge-Kutta's error"));
  EXPECT_NEAR(handle.velocity(), slide.velocity, test::tolerance(1e-12, "Runge-Kutta's error"));
}

TEST(SlidingHandle, MovesTheSameInOneStepAsInManyUnevenOnes)
{
  SlidingHandle one = pushedHandle(0.2), many = pushedHandle(0.2);
  one.advanceTo(0.1);
  for (double time = 0.0; time < 0.1; time = 1.3 * time + 1e-5) many.advanceTo(time);
  many.advanceTo(0.1);
  EXPECT_NEAR(many.position(), one.position(), test::tolerance(1e-14, "rounding"));
}

TEST(SlidingHandle, StaysWhereItIsHeld)
{
  SlidingHandle handle = pushedHandle(0.2);
  handle.advanceTo(0.05);
  const double place = handle.position();
  handle.hold(true);
  handle.actuate(1.0);
  handle.advanceTo(0.06);
  EXPECT_EQ(handle.position(), place);
}

TEST(SlidingHandle, StandsBetweenAPushAndAnEqualForce)
{
  SlidingHandle handle = pushedHandle(0.2);
  handle.actuate(-0.2);
  handle.advanceTo(0.015);
  EXPECT_EQ(handle.position(), 0.0);
}

TEST(SlidingHandle, SwitchesOffAForceThatNobodyRenews)
{
  SlidingHandle handle = pushedHandle(0.0);
  handle.actuate(0.99);
  handle.advanceTo(1.0);
  EXPECT_TRUE(handle.hasTimedOut());
  EXPECT_EQ(handle.force(), 0.0);
  // Pushed for the watchdog's time, then slowed by the bearings alone: x = x1 + v1 m / b (1 - ...).
  const Slide pushed = slideFor(body.watchdog, 0.99);
  const double lag = body.mass / body.damping;
  const double place =
      pushed.position + pushed.velocity * lag * (1.0 - std::exp(-(1.0 - body.watchdog) / lag));
  EXPECT_NEAR(handle.position(), place, test::tolerance(1e-10, "Runge-Kutta's error"));
}

TEST(SlidingHandle, StopsAtTheEndOfItsRail)
{
  SlidingHandle handle = pushedHandle(3.0);
  handle.advanceTo(2.0);
  EXPECT_EQ(handle.position(), body.reach);
  EXPECT_EQ(handle.velocity(), 0.0);
}

}  // namespace
}  // namespace perilymph::hidstack

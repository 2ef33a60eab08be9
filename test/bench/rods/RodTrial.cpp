// SPDX-License-Identifier: BSD-3-Clause
#include "RodTrial.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::bench {
namespace {

/// Part of the slow push over which forces are averaged: three distances of a hundred nodes, because each
/// node adds something of its own when it passes the begin of the bend.
constexpr double comparedPart = 0.7;

/// Two ranges of the circle, one behind the other, in which the rod is an arc on the outer wall: its ends
/// cross the tube over 0.7 and 1.3 rad, and beside them the load ripples, because the wall yields.
constexpr double arcBegin = 2.2;  // [rad]
constexpr double arcWidth = 1.5;  // [rad]

/// Weight of a load in the range that begins at `from`. It is smooth, so that the sum does not depend on
/// how many nodes are in the range.
double weightIn(double angle, double from)
{
  const double part = (angle - from) / arcWidth;
  if (part < 0.0 || part > 1.0) return 0.0;
  return 0.5 - 0.5 * std::cos(2.0 * pi * part);
}

int ticksFor(double push, double speed)
{
  return static_cast<int>(std::lround(push / speed / rodTimeStep));
}

int quickTicks(const RodHand& hand) { return ticksFor(hand.quickPush, hand.quickSpeed); }

int slowTicks(const RodHand& hand) { return ticksFor(hand.slowPush, hand.slowSpeed); }

/// The end of an elastica that begins at a tip without moment.
struct Clamp {
  double angle = 0.0;   // of the rod [rad]
  double across = 0.0;  // distance of the tip from it, across the tube [m]
};

/// @param force  Normal force of the wall on the tip [N].
Clamp elastica(const RodTrial& trial, double length, double tipAngle, double force)
{
  constexpr int steps = 200;  // of Runge and Kutta, fourth order: twice as many change 1e-8 at most
  const double h = length / steps;
  using Three = std::array<double, 3>;  // a, a', x
  const auto rate = [&](const Three& at) {
    const double load = std::cos(at[0]) - trial.friction * std::sin(at[0]);
    return Three{at[1], force / trial.rod.bending * load, std::sin(at[0])};
  };
  const auto moved = [](const Three& from, double by, const Three& along) {
    return Three{from[0] + by * along[0], from[1] + by * along[1], from[2] + by * along[2]};
  };
  Three at{tipAngle, 0.0, 0.0};
  for (int i = 0; i < steps; ++i) {
    const Three a = rate(at);
    const Three b = rate(moved(at, 0.5 * h, a));
    const Three c = rate(moved(at, 0.5 * h, b));
    const Three d = rate(moved(at, h, c));
    for (std::size_t k = 0; k < 3; ++k) at[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  return {at[0], at[2]};
}

/// Where an increasing function is 0.
template <class Function>
double root(double low, double high, const Function& function)
{
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Normal force on the tip that presses on the wall [N].
double forceOfPressedTip(const RodTrial& trial)
{
  const double held = 0.5 * trial.spacing();
  const double bent = trial.rod.length - held;
  const double across = trial.tube.radius - trial.rod.radius - held * std::sin(trial.hand.turn);
  const auto tipAngle = [&](double force) {
    return root(-0.5 * pi, trial.hand.turn, [&](double angle) {
      return elastica(trial, bent, angle, force).angle - trial.hand.turn;
    });
  };
  // at most four times the force that would turn the tip of a cantilever, F L^2 / (2 EI), back by the turn
  const double most = 8.0 * trial.rod.bending * trial.hand.turn / (bent * bent);
  return root(0.0, most, [&](double force) {
    return across - elastica(trial, bent, tipAngle(force), force).across;
  });
}

double percentOff(double value, double exact) { return 100.0 * std::fabs(value / exact - 1.0); }

}  // namespace

RodTrial rodTrial(RodQuestion question, int nodes)
{
  RodTrial trial;
  trial.question = question;
  trial.nodes = nodes;
  if (question == RodQuestion::pressedTip) {
    trial.tube.radius = 5e-3;
    trial.startInside = 21.5e-3;
    trial.friction = 0.1;
    trial.hand.turn = 0.4;
    trial.hand.turnTicks = 400;
    trial.hand.quickPush = 2e-3;
    return trial;
  }
  // Play of 0.02 mm, and a bend of 7.9 rad with the radius of a middle turn: between the parts that cross
  // the tube an arc remains. The straight part holds what is not yet in the bend, so that it cannot buckle.
  trial.tube = {0.27e-3, 2e-3, 22e-3};
  trial.startInside = 21e-3;
  trial.friction = question == RodQuestion::capstan ? 0.1 : 0.0;
  trial.hand.quickPush = 16e-3;
  return trial;
}

int ticksOf(const RodTrial& trial)
{
  return trial.hand.turnTicks + quickTicks(trial.hand) + slowTicks(trial.hand);
}

RodHandAt handAt(const RodTrial& trial, int tick)
{
  const RodHand& hand = trial.hand;
  RodHandAt at;
  if (tick <= hand.turnTicks) {
    at.turnRate = hand.turn / (hand.turnTicks * rodTimeStep);
    at.turned = at.turnRate * rodTimeStep * tick;
    return at;
  }
  const int pushing = tick - hand.turnTicks;
  const int quick = std::min(pushing, quickTicks(hand));
  at.turned = hand.turn;
  at.speed = pushing == quick ? hand.quickSpeed : hand.slowSpeed;
  at.pushed = rodTimeStep * (hand.quickSpeed * quick + hand.slowSpeed * (pushing - quick));
  return at;
}

RodComparison::RodComparison(const RodTrial& trial)
    : trial_(trial), first_(ticksOf(trial) - static_cast<int>(comparedPart * slowTicks(trial.hand)))
{
}

void RodComparison::add(const RodForces& forces)
{
  count_ += 1.0;
  push_ += forces.push;
  pushSquares_ += forces.push * forces.push;
  side_ += forces.side;
  const RodTube& tube = trial_.tube;
  double angle = 0.0;  // along the circle, past its turns
  for (const RodForces::Load& load : forces.loads) {
    const Eigen::Vector3d& at = load.node_W;
    const double here =
        tube.bend > 0.0 ? std::atan2(-(at.z() + tube.lead), at.x() + tube.bend) : 0.0;
    angle += std::remainder(here - angle, 2.0 * pi);
    nearHand_ += weightIn(angle, arcBegin) * load.force;
    nearTip_ += weightIn(angle, arcBegin + arcWidth) * load.force;
    if (load.force <= 0.0) continue;
    const double out =
        angle > 0.0 ? std::hypot(at.x() + tube.bend, at.z() + tube.lead) - tube.bend : at.x();
    deepest_ = std::max(deepest_, std::hypot(out, at.y()) + trial_.rod.radius - tube.radius);
  }
}

RodError RodComparison::error() const
{
  const double push = push_ / count_;
  const double variance = std::max(0.0, pushSquares_ / count_ - push * push);
  RodError error;
  error.ripplePercent = 100.0 * std::sqrt(variance) / std::fabs(push);
  error.deepest = deepest_;
  if (trial_.question == RodQuestion::pressedTip) {
    const double force = forceOfPressedTip(trial_);
    error.percent =
        std::max(percentOff(side_ / count_, force), percentOff(push, trial_.friction * force));
  } else if (trial_.question == RodQuestion::pushForce) {
    const double radius = trial_.tube.bend + trial_.tube.radius - trial_.rod.radius;
    error.percent = percentOff(push, 0.5 * trial_.rod.bending / (radius * radius));
  } else {
    error.percent = percentOff(std::log(nearHand_ / nearTip_), trial_.friction * arcWidth);
  }
  return error;
}

}  // namespace perilymph::bench

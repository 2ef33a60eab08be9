// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The same rod in the same tubes by several engines, compared with closed forms. SI units.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "../BuiltOnce.h"

namespace perilymph::bench {

/// The rod, straight at rest and round: that of test::plainArray().
struct RodShape {
  double length = 22e-3;
  double radius = 0.25e-3;
  double bending = 1e-6;    ///< EI [N.m^2]
  double damping = 2e-3;    ///< Material damping over stiffness, as in mechanics [s].
  double density = 1150.0;  ///< That of silicone, as in mechanics [kg/m^3].
};

/// A round tube along -z from the origin: straight without end or, if it bends, straight over the length
/// `lead` and then a circle with that radius of its axis, which curves toward -x.
struct RodTube {
  double radius = 0.0;
  double bend = 0.0;  ///< 0: straight.
  double lead = 0.0;
};

/// Motion of the hand. It holds the first edge of the chain of nodes, on the axis of the tube; the rod
/// bends from the middle of that edge on. It turns the rod toward +x, then pushes it along -z, quickly
/// and at last so slowly that the damping of the material adds less than 1 % to the forces, which are
/// compared then.
struct RodHand {
  double turn = 0.0;  ///< [rad]
  int turnTicks = 0;
  double quickPush = 0.0;
  double quickSpeed = 10e-3;
  double slowPush = 1e-3;
  double slowSpeed = 0.5e-3;  ///< As of a careful insertion.
};

enum class RodQuestion {
  pressedTip,  ///< Force of a tip that is pressed on the wall and slides along it.
  pushForce,   ///< Force that pushes the rod into a bend without friction.
  capstan,     ///< Growth of the wall's load along the bend by friction.
};

struct RodTrial {
  RodQuestion question = RodQuestion::pressedTip;
  int nodes = 100;
  RodShape rod;
  RodTube tube;
  RodHand hand;
  double friction = 0.0;
  double startInside = 0.0;  ///< Depth of the tip at first.

  double spacing() const { return rod.length / (nodes - 1); }
};

inline constexpr double rodTimeStep = 1e-3;  ///< That of a haptic device [s].

RodTrial rodTrial(RodQuestion question, int nodes);

/// Number of time steps of a trial.
int ticksOf(const RodTrial& trial);

/// The hand at the end of a time step, counted from 1, and its rates within it.
struct RodHandAt {
  double turned = 0.0, turnRate = 0.0;
  double pushed = 0.0, speed = 0.0;
};
RodHandAt handAt(const RodTrial& trial, int tick);

/// What an engine returns after a time step.
struct RodForces {
  double push = 0.0;  ///< Force of the hand along -z [N].
  double side = 0.0;  ///< Force of the hand along +x [N].
  struct Load {
    Eigen::Vector3d node_W;
    double force = 0.0;  ///< Normal force of the wall on the node [N].
  };
  std::vector<Load> loads;  ///< One for each node, the tip last.
};

struct RodError {
  double percent = 0.0;        ///< Mean relative to the closed form.
  double ripplePercent = 0.0;  ///< Standard deviation of the push from tick to tick.
  double deepest = 0.0;        ///< Largest depth of a node in the wall [m].
};

/// Compares what an engine returns over the slow push with the closed form:
///
///     pressedTip  sideward force N and push mu N, the larger error. Euler's elastica (Timoshenko and Gere,
///                 Theory of Elastic Stability, 1961, 2.7): for the angle a of the rod,
///                 EI a'' = N (cos a - mu sin a), a = turn at the hand and a' = 0 at the tip.
///     pushForce   F = EI / (2 R^2), because each length ds that enters the bend takes up the energy
///                 EI ds / (2 R^2); R is the bend's radius and the play, because the rod lies outside.
///     capstan     q = q_tip exp(mu phi), the law of Euler and Eytelwein: the load q = P / R of an arc
///                 balances its compression P, and P' = mu q along it. Compared is mu phi, over 1.5 rad.
class RodComparison {
public:
  explicit RodComparison(const RodTrial& trial);

  bool isCompared(int tick) const { return tick > first_; }
  void add(const RodForces& forces);
  RodError error() const;

private:
  RodTrial trial_;
  int first_;
  double count_ = 0.0, push_ = 0.0, pushSquares_ = 0.0, side_ = 0.0;
  double nearHand_ = 0.0, nearTip_ = 0.0, deepest_ = 0.0;
};

/// Runs a trial once. `Rod` is built from the trial and has start(), tick(RodHandAt) and forces().
template <class Rod>
RodError errorOf(Rod& rod, const RodTrial& trial)
{
  RodComparison comparison(trial);
  rod.start();
  for (int tick = 1; tick <= ticksOf(trial); ++tick) {
    rod.tick(handAt(trial, tick));
    if (comparison.isCompared(tick)) comparison.add(rod.forces());
  }
  return comparison.error();
}

/// Times the ticks of an engine, and writes its errors into the row. The row fails if an error is larger
/// than `maxPercent` at 100 nodes, or with fewer nodes by the square of their distance.
template <class Rod>
void rodBy(benchmark::State& state, RodQuestion question, double maxPercent)
{
  const RodTrial trial = rodTrial(question, static_cast<int>(state.range(0)));
  Rod rod(trial);
  static BuiltOnce<std::pair<RodQuestion, int>, RodError> errors;
  const RodError& error =
      errors.of({question, trial.nodes}, [&](const auto&) { return errorOf(rod, trial); });
  const int ticks = ticksOf(trial);
  while (state.KeepRunningBatch(ticks)) {
    rod.start();
    for (int tick = 1; tick <= ticks; ++tick) rod.tick(handAt(trial, tick));
  }
  state.counters["error_percent"] = error.percent;
  state.counters["ripple_percent"] = error.ripplePercent;
  state.counters["deepest_um"] = 1e6 * error.deepest;
  const double coarser = 100.0 / trial.nodes;
  if (!(error.percent <= maxPercent * coarser * coarser))
    state.SkipWithError(("The error is " + std::to_string(error.percent) + " %.").c_str());
}

/// The rows of an engine.
inline void rodNodes(benchmark::internal::Benchmark* row)
{
  row->ArgName("nodes")->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMicrosecond);
}

}  // namespace perilymph::bench

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/TickBound.h"

#include <Eigen/QR>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "perilymph/mechanics/advance.h"
#include "perilymph/realtime/ThreadTime.h"

namespace perilymph::haptics {

namespace {

constexpr int ticksIn = 60;  ///< The array is inserted within these, to where it is measured.
constexpr double depthPart =
    0.8;  ///< Part of the insertable length there: most nodes touch the wall.
constexpr int ticksMeasured = 30;
/// Motion of the base from tick to tick, along and across [m]: 50 mm/s in steps of 1 ms, ten times a
/// fast insertion (a choice). With more, every evaluation searches the wall anew at all nodes.
constexpr double jerk = 0.05e-3;
/// Device, safety, snapshot and record take 9 % of a tick (counted instructions).
constexpr double loopShare = 1.1;

/// A force that is late by less is not felt: the period of the usual haptic loop (a choice). A device of a
/// shorter period gets the next force a little later at most.
constexpr double notFelt = 1e-3;  // [s]
/// So many measurements must say that a tick is too long: other work on the machine only adds to one.
constexpr int measurements = 5;
/// A build with sanitizers is tested, not felt: it may take so many times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slowness = 5.0;
#else
constexpr double slowness = 1.0;
#endif

/// When the factors of the stiffness are renewed.
enum class Factors { always, seldom };

/// The same model, solved to no tolerance: a tick goes on until its work is used or nothing moves.
mechanics::InsertionModel tireless(mechanics::InsertionModel model, Factors factors)
{
  mechanics::SolverParameters& solver = model.parts.solver;
  solver.forceTolerance = solver.motionTolerance = solver.motionFraction = 0.0;
  solver.atRest = solver.stuck = solver.settledForce = 0.0;
  const bool isAlways = factors == Factors::always;
  solver.farStep = isAlways ? 0.0 : 1.0;  // [m]
  solver.goodRatio = solver.keptRatio = isAlways ? 0.0 : 1.0;
  return model;
}

/// A measured tick.
struct Tick {
  double time;  // [s]
  int evaluations, factorizations;
};

/// Least squares of the relative error of time = constant + evaluations + factorizations, [s] each.
Eigen::Vector3d fit(const std::vector<Tick>& ticks)
{
  const auto rows = static_cast<Eigen::Index>(ticks.size());
  Eigen::MatrixX3d work(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Tick& tick = ticks[static_cast<std::size_t>(i)];
    work.row(i) << 1.0, tick.evaluations, tick.factorizations;
    work.row(i) /= tick.time;
  }
  return work.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(rows));
}

double timeOf(const Eigen::Vector3d& costs, double evaluations, double factorizations)
{
  return costs[0] + costs[1] * evaluations + costs[2] * factorizations;
}

std::string milliseconds(double time)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", time * 1e3);
  return text;
}

}  // namespace

std::optional<TickBound> measureTickBound(const mechanics::InsertionModel& model)
{
  if (model.points) return std::nullopt;
  mechanics::InsertionState state(model);
  mechanics::Drive drive;
  drive.handAxis_W = model.startAxis_W;
  drive.handCurl_W = model.startCurl_W;
  const auto moveTo = [&](double inward, double beside) {
    const Eigen::Vector3d place_W =
        model.startBase_W + inward * drive.handAxis_W + beside * drive.handCurl_W;
    drive.handVelocity_W = (place_W - drive.handPosition_W) / model.timeStep;
    drive.handPosition_W = place_W;
  };
  drive.handPosition_W = model.startBase_W;
  const double way = depthPart * (model.parts.array.insertable.si() - model.parts.startInside.si());
  for (int i = 1; i <= ticksIn; ++i) {
    moveTo(way * i / ticksIn, 0.0);
    mechanics::advance(model, state, drive);
  }

  std::vector<Tick> ticks;
  for (const Factors factors : {Factors::seldom, Factors::always}) {
    const mechanics::InsertionModel longest = tireless(model, factors);
    for (int i = 0; i < ticksMeasured; ++i) {
      moveTo(way + (i % 4 < 2 ? jerk : 0.0), i % 2 == 0 ? jerk : -jerk);
      const std::int64_t began = realtime::threadNanoseconds();
      mechanics::advance(longest, state, drive);
      const double took = 1e-9 * static_cast<double>(realtime::threadNanoseconds() - began);
      if (!state.readings.isFinite || !(took > 0.0)) return std::nullopt;
      ticks.push_back({took, state.readings.evaluations, state.readings.factorizations});
    }
  }
  Eigen::Vector3d costs = fit(ticks);
  // Other work on the machine makes ticks longer, in processor time too: the faster half is its own.
  const auto excess = [&costs](const Tick& tick) {
    return tick.time / timeOf(costs, tick.evaluations, tick.factorizations);
  };
  std::sort(ticks.begin(), ticks.end(),
            [&excess](const Tick& one, const Tick& other) { return excess(one) < excess(other); });
  ticks.resize(ticks.size() / 2);
  costs = fit(ticks).cwiseMax(0.0);

  TickBound bound;
  bound.evaluation = costs[1];
  bound.factorization = costs[2];
  for (const Tick& tick : ticks) {
    bound.evaluations = std::max(bound.evaluations, tick.evaluations);
    bound.factorizations = std::max(bound.factorizations, tick.factorizations);
  }
  const mechanics::SolverParameters& solver = model.parts.solver;
  bound.time = loopShare * timeOf(costs, solver.maxEvaluations, solver.maxFactorizations);
  return bound;
}

Result<void> checkTickBound(const mechanics::InsertionModel& model)
{
  const double longest = std::max(model.timeStep, notFelt);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < measurements; ++i) {
    const auto bound = measureTickBound(model);
    if (!bound || bound->time <= slowness * longest) return {};
    least = std::min(least, bound->time);
  }
  const int nodes = static_cast<int>(model.nodes * longest / least) / 10 * 10;
  return Error{
      "With %1 nodes a time step can take %2 ms on this machine, longer than %3 ms, so that the "
      "force at the device could be late. Set nodes to at most %4.",
      model.nodes, milliseconds(least), milliseconds(longest), std::max(nodes, 8)};
}

}  // namespace perilymph::haptics

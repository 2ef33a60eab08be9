#include "perilymph/mechanics/advance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/Contact.h"
#include "points/advancePoints.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

constexpr int mostIterations = 16;
constexpr int mostHalvings = 3;
constexpr double forceTolerance = 2e-6;   // [N]
constexpr double motionTolerance = 1e-9;  // [m]
constexpr double longestStep = 0.2e-3;    // [m] of one node in one Newton step

/// The forces and the matrix of one iteration, at state.position_W.
struct Balance {
  double worst;    ///< Greatest unbalanced force on a block [N].
  double squares;  ///< Sum of their squares [N^2].
};

/// Where the base would go by itself in spring coupling, and how hard it is held.
struct Base {
  bool isHeld;                ///< Rigid coupling.
  double inertia;             ///< m / dt^2 [N/m]
  double grip;                ///< Spring and damper [N/m]
  Eigen::Vector3d free_W;     ///< Where inertia alone takes it [m].
  Eigen::Vector3d gripped_W;  ///< Where the coupling pulls it [m].
};

Base baseOf(const InsertionModel& model, const InsertionState& state, const Drive& drive) noexcept
{
  const double dt = model.timeStep;
  Base base{};
  base.isHeld = drive.coupling == Coupling::rigid;
  base.inertia = model.baseMass / (dt * dt);
  base.grip = drive.couplingStiffness + drive.couplingDamping / dt;
  base.free_W = state.base_W + dt * state.baseVelocity_W;
  base.gripped_W = drive.handPosition_W;
  if (base.grip > 0.0)
    base.gripped_W = (drive.couplingStiffness * drive.handPosition_W +
                      drive.couplingDamping * (state.base_W / dt + drive.handVelocity_W)) /
                     base.grip;
  return base;
}

/// All forces on all nodes and the matrix of the Newton step. Leaves minus the residual in
/// room.system.right.
Balance balance(const InsertionModel& model, InsertionState& state, const Base& base,
                Compression compression) noexcept
{
  StepRoom& room = state.room;
  const auto n = static_cast<std::size_t>(model.nodes);
  const double dt = model.timeStep;
  room.system.clear();
  for (std::size_t i = 0; i < n; ++i) room.force_W[i].setZero();
  addRod(model, state.position_W, compression, room);
  addWall(model, state, state.position_W, room);

  // inertia and the perilymph's drag, and the nodes' forces gathered into blocks
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t block = blockOf(i);
    room.system.right[block] += room.force_W[i];
    if (i < 2) continue;
    const double inertia = model.mass[i] / (dt * dt);
    const double drag = model.drag[i] / dt;
    const Eigen::Vector3d moved = state.position_W[i] - room.before_W[i];
    room.system.right[block] -=
        (inertia + drag) * moved - (model.mass[i] / dt) * state.velocity_W[i];
    for (int k = 0; k < 3; ++k) room.system.diagonal[block](k, k) += inertia + drag;
  }
  if (base.isHeld) {
    room.system.right[0].setZero();
    room.system.diagonal[0].setIdentity();
    room.system.beside[1].setZero();
    room.system.beyond[2].setZero();
  } else {
    const Eigen::Vector3d& at = state.position_W[0];
    room.system.right[0] -= base.inertia * (at - base.free_W) + base.grip * (at - base.gripped_W);
    for (int k = 0; k < 3; ++k) room.system.diagonal[0](k, k) += base.inertia + base.grip;
  }

  Balance result{0.0, 0.0};
  for (std::size_t j = 0; j < room.system.blocks(); ++j) {
    const Eigen::Vector3d& force = room.system.right[j];
    for (int k = 0; k < 3; ++k) {
      const double size = std::fabs(force[k]);
      // written so that a not-a-number is kept, not lost
      if (!(size <= result.worst)) result.worst = size;
      result.squares += force[k] * force[k];
    }
  }
  return result;
}

/// Moves every node by a share of the Newton step that starts at room.start_W.
void moveBy(InsertionState& state, double share) noexcept
{
  const StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.position_W.size(); ++i)
    state.position_W[i] = room.start_W[i] + share * room.trial_W[blockOf(i)];
}

/// First guess: every node slides along the array by as much as the base advances.
void predict(const InsertionModel& model, InsertionState& state, const Drive& drive,
             const Base& base) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  StepRoom& room = state.room;
  Eigen::Vector3d to_W = drive.handPosition_W;
  if (!base.isHeld)
    to_W = (base.inertia * base.free_W + base.grip * base.gripped_W) / (base.inertia + base.grip);
  const Eigen::Vector3d motion = to_W - room.before_W[0];
  const double forward = motion.dot(drive.handAxis_W);
  for (std::size_t i = 2; i < n; ++i) {
    const Eigen::Vector3d tangent =
        (room.before_W[i] - room.before_W[i - 1]) / room.lengthBefore[i - 1];
    state.position_W[i] = room.before_W[i] + forward * tangent;
  }
  state.position_W[0] = to_W;
  state.position_W[1] = to_W + model.spacing * drive.handAxis_W;
}

/// Newton's method with a line search on the residual.
Balance solve(const InsertionModel& model, InsertionState& state, const Base& base,
              int& iterations) noexcept
{
  StepRoom& room = state.room;
  Balance now = balance(model, state, base, Compression::included);
  for (iterations = 0; iterations < mostIterations; ++iterations) {
    if (!(now.worst > forceTolerance)) break;

    if (!room.system.solve()) {
      // past its buckling load the exact matrix has no positive pivots; the safe one always has
      balance(model, state, base, Compression::leftOut);
      if (!room.system.solve()) break;
    }
    double longest = 0.0;
    for (std::size_t j = 0; j < room.system.blocks(); ++j) {
      room.trial_W[j] = room.system.right[j];
      longest = std::max(longest, room.trial_W[j].norm());
    }
    for (std::size_t i = 0; i < state.position_W.size(); ++i) room.start_W[i] = state.position_W[i];

    double share = longest > longestStep ? longestStep / longest : 1.0;
    moveBy(state, share);
    Balance next = balance(model, state, base, Compression::included);
    for (int halving = 0; halving < mostHalvings && !(next.squares <= now.squares); ++halving) {
      share *= 0.5;
      moveBy(state, share);
      next = balance(model, state, base, Compression::included);
    }
    now = next;
    if (share * longest < motionTolerance) {
      ++iterations;
      break;
    }
  }
  return now;
}

/// Length of array past the plane of the opening.
double depthOf(const InsertionModel& model, const InsertionState& state) noexcept
{
  const auto inside = [&](std::size_t i) {
    return (model.entry.origin_W - state.position_W[i]).dot(model.entry.out_W);
  };
  double after = inside(state.position_W.size() - 1);
  if (!(after > 0.0)) return 0.0;
  for (std::size_t i = state.position_W.size() - 1; i-- > 0;) {
    const double before = inside(i);
    if (before <= 0.0) {
      const double share = after / (after - before);
      return model.fromTip[i + 1] + share * model.spacing;
    }
    after = before;
  }
  return model.fromTip[0];
}

/// What the rest of the program wants to know of the step.
void read(const InsertionModel& model, InsertionState& state, const Drive& drive, const Base& base,
          const Balance& left, int iterations) noexcept
{
  const StepRoom& room = state.room;
  Readings& r = state.readings;
  r.iterations = iterations;
  r.residual = left.worst;
  // the hand holds nodes 0 and 1; in spring coupling it holds them through the spring
  const Eigen::Vector3d onBase_W = room.force_W[0] + room.force_W[1];
  r.handForce_W =
      base.isHeld ? onBase_W : Eigen::Vector3d(base.grip * (state.base_W - base.gripped_W));
  r.handTorque_W = (model.spacing * drive.handAxis_W).cross(room.force_W[1]);
  r.axialForce = r.handForce_W.dot(model.entry.out_W);
  r.speed = -state.baseVelocity_W.dot(model.entry.out_W);
  r.depth = depthOf(model, state);
  r.angularDepth = r.depth > 0.0 ? std::max(state.track.back().angle, 0.0) : 0.0;
  r.contacts = 0;
  r.wallForceMax = r.wallForceTotal = r.membraneForce = 0.0;
  for (std::size_t i = 0; i < state.normalForce.size(); ++i) {
    const double force = state.normalForce[i];
    if (!(force > 0.0)) continue;
    ++r.contacts;
    r.wallForceTotal += force;
    r.wallForceMax = std::max(r.wallForceMax, force);
    if (state.onMembrane[i] != 0) r.membraneForce += force;
  }
  const double sum = r.handForce_W.x() + r.handForce_W.y() + r.handForce_W.z() +
                     state.position_W.back().x() + state.position_W.back().y() +
                     state.position_W.back().z() + left.squares;
  r.isFinite = std::isfinite(sum);
}

}  // namespace

void advance(const InsertionModel& model, InsertionState& state, const Drive& drive) noexcept
{
  if (model.points) return advancePoints(model, state, drive);
  StepRoom& room = state.room;
  const std::size_t n = state.position_W.size();

  // what this step starts from
  for (std::size_t i = 0; i < n; ++i) room.before_W[i] = state.position_W[i];
  state.styletWithdrawal = drive.styletWithdrawal;
  setStiffness(model, drive.styletWithdrawal, room);
  setRestBends(model, state, drive.handCurl_W, room);
  rememberShape(model, state, room);
  const Base base = baseOf(model, state, drive);

  // predict the rod, then correct it against the wall
  predict(model, state, drive, base);
  int iterations = 0;
  const Balance left = solve(model, state, base, iterations);

  // what the next step starts from
  const double perTime = 1.0 / model.timeStep;
  state.baseVelocity_W = perTime * (state.position_W[0] - room.before_W[0]);
  state.base_W = state.position_W[0];
  for (std::size_t i = 0; i < n; ++i) {
    state.velocity_W[i] = perTime * (state.position_W[i] - room.before_W[i]);
    state.frictionSpring_W[i] = room.frictionSpring_W[i];
    state.isSliding[i] = room.isSliding[i];
    state.slipSpeed[i] = perTime * room.slip[i];
  }
  ++state.tick;
  read(model, state, drive, base, left, iterations);
}

}  // namespace perilymph::mechanics

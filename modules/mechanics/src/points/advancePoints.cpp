// SPDX-License-Identifier: BSD-3-Clause
#include "points/advancePoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "points/PointFriction.h"
#include "points/PointSetModel.h"

namespace perilymph::mechanics {
namespace {

/// Cosine of 45 degrees: a wall whose normal is closer to the outward direction is across the way
/// in.
constexpr double halfway = 0.70710678118654752;

/// The components of a vector along E's axes: x toward the outer wall, z out.
Eigen::Vector3d inEntry(const anatomy::Entry& entry, const Eigen::Vector3d& v_W) noexcept
{
  return {v_W.dot(entry.outward_W), v_W.dot(entry.vertical_W), v_W.dot(entry.out_W)};
}

Eigen::Vector3d fromEntry(const anatomy::Entry& entry, const Eigen::Vector3d& v_E) noexcept
{
  return v_E.x() * entry.outward_W + v_E.y() * entry.vertical_W + v_E.z() * entry.out_W;
}

/// Depth of a point past the plane of the opening [m].
double inside(const anatomy::Entry& entry, const Eigen::Vector3d& place_W) noexcept
{
  return (entry.origin_W - place_W).dot(entry.out_W);
}

/// Length of a straight carrier past the opening [m]: the insertion distance of the paper.
double insertionDistance(const InsertionModel& model, const Eigen::Vector3d& base_W,
                         const Eigen::Vector3d& axis_W) noexcept
{
  const double length = model.parts.array.length.si();
  const double inward = -axis_W.dot(model.entry.out_W);
  if (!(inward > 0.1)) return 0.0;  // held across or pointing outward: depth undefined
  return std::clamp(length + inside(model.entry, base_W) / inward, 0.0, length);
}

/// Length of the carrier that carries points [m]: the whole carrier; after the basal-turn collision
/// the part before the position of that collision.
double pointedLength(const InsertionModel& model, const PointSetState& set,
                     double insertion) noexcept
{
  const double length = model.parts.array.length.si();
  if (set.turnedAt < 0.0) return length;
  return std::clamp(length - (insertion - set.turnedAt), set.turnedAt, length);
}

Eigen::Vector3d carrierAxis(const PointSetState& set, const Eigen::Vector3d& handAxis_W) noexcept
{
  return (handAxis_W + set.turn_W.cross(handAxis_W)).normalized();
}

/// Next position of the tweezers. With rigid coupling it is the hand's; with spring coupling the
/// hand pulls the massless frame against the springs of all points.
Eigen::Vector3d nextBase(const InsertionModel& model, const InsertionState& state,
                         const Drive& drive, const Eigen::Vector3d& hand_W) noexcept
{
  if (drive.coupling == Coupling::rigid) return hand_W;
  const PointSetModel& law = *model.points;
  const PointSetState& set = state.points;
  const double step = law.substep;
  Eigen::Vector3d force_W = drive.couplingStiffness * (hand_W - state.base_W) +
                            drive.couplingDamping * drive.handVelocity_W + set.friction_W;
  for (std::size_t i = 0; i < state.position_W.size(); ++i)
    force_W += law.law.stiffness * (state.position_W[i] - set.place_W[i]) +
               law.law.damping * state.velocity_W[i];
  const auto points = static_cast<double>(state.position_W.size());
  const double hold = drive.couplingStiffness + drive.couplingDamping / step +
                      points * (law.law.stiffness + law.law.damping / step);
  return state.base_W + force_W / hold;
}

/// Contact of one point with the surface: moves its proxy and stores normal force, friction and
/// their sum in the state. Returns whether the wall there is across the way in.
bool meetSurface(const InsertionModel& model, InsertionState& state, std::size_t i,
                 PointWorkspace& workspace) noexcept
{
  const PointSetModel& law = *model.points;
  PointSetState& set = state.points;
  const Eigen::Vector3d& at_W = state.position_W[i];
  state.normalForce[i] = 0.0;
  state.wallForce_W[i].setZero();
  state.slipSpeed[i] = 0.0;
  const double depth = inside(model.entry, at_W);
  ProxyHold hold{at_W, Eigen::Vector3d::Zero(), false};
  if (depth > 0.0)
    hold = law.surface.follow(set.proxy_W[i], at_W, std::min(depth, law.law.radius),
                              workspace.allowed);
  const Eigen::Vector3d moved_W = hold.place_W - set.proxy_W[i];
  set.proxy_W[i] = hold.place_W;
  const double pressed = hold.pressed_W.norm();
  if (!hold.touches || !(pressed > 0.0)) {
    state.frictionSpring_W[i].setZero();
    state.isSliding[i] = 0;
    return false;
  }

  const Eigen::Vector3d normal_W = hold.pressed_W / pressed;
  const WallLaw& wall = model.parts.wall;
  // a surface pushes and never pulls, however fast the point moves away
  const double normal =
      std::max(0.0, wall.perSamplePoint.si() * pressed -
                        law.law.surfaceDamping * state.velocity_W[i].dot(normal_W));
  const Eigen::Vector3d stretch_W = state.frictionSpring_W[i] + moved_W;
  const PointFriction friction = pointFriction(stretch_W - normal_W * normal_W.dot(stretch_W),
                                               normal, wall.tangentialPerSamplePoint.si(),
                                               state.isSliding[i] != 0, model.parts.friction);
  state.frictionSpring_W[i] = friction.spring_W;
  state.isSliding[i] = friction.isSliding ? 1 : 0;
  state.slipSpeed[i] =
      friction.isSliding ? (moved_W - normal_W * normal_W.dot(moved_W)).norm() / law.substep : 0.0;
  state.normalForce[i] = normal;
  state.wallForce_W[i] = normal * normal_W + friction.force_W;
  return normal_W.dot(model.entry.out_W) >= halfway;
}

/// Moves one point under the forces on it. Returns its force on the carrier [N].
Eigen::Vector3d movePoint(const InsertionModel& model, InsertionState& state, std::size_t i,
                          const Eigen::Vector3d& placeVelocity_W) noexcept
{
  const PointSetModel& law = *model.points;
  PointSetState& set = state.points;
  const Eigen::Vector3d spring_W = law.law.stiffness * (set.place_W[i] - state.position_W[i]) +
                                   law.law.damping * (placeVelocity_W - state.velocity_W[i]);
  state.velocity_W[i] += (law.substep / law.pointMass) * (spring_W + state.wallForce_W[i]);
  state.position_W[i] += law.substep * state.velocity_W[i];

  const Eigen::Vector3d off_E = inEntry(model.entry, state.position_W[i] - set.place_W[i]);
  const Eigen::Vector3d max_E = 0.5 * law.law.box;
  Eigen::Vector3d kept_E;
  for (int k = 0; k < 3; ++k) kept_E[k] = std::clamp(off_E[k], -max_E[k], max_E[k]);
  if (kept_E[0] != off_E[0] || kept_E[1] != off_E[1] || kept_E[2] != off_E[2]) {
    state.position_W[i] = set.place_W[i] + fromEntry(model.entry, kept_E);
    state.velocity_W[i] = placeVelocity_W;
    ++set.atBounds;
  }
  return -spring_W;
}

/// Rotates the carrier in the tweezers under the points' moment and its own spring: implicitly,
/// because its inertia is small compared with the effect of the points' dampers in one step.
///
/// @param armSquares  Sum over the points of their squared distance from the tweezers [m^2].
void turnCarrier(const InsertionModel& model, PointSetState& set, double armSquares) noexcept
{
  const PointSetModel& law = *model.points;
  const double step = law.substep;
  const double damping = armSquares * law.law.damping;
  const double hold = damping + law.law.turningDamping +
                      step * (law.law.turningStiffness + armSquares * law.law.stiffness);
  const Eigen::Vector3d moment_E =
      inEntry(model.entry, set.moment_W - law.law.turningStiffness * set.turn_W);
  const Eigen::Vector3d before_E = inEntry(model.entry, set.turnRate_W);
  Eigen::Vector3d rate_E;
  for (int k = 0; k < 3; ++k) {
    const double inertia = law.inertia[k] / step;
    rate_E[k] = ((inertia + damping) * before_E[k] + moment_E[k]) / (inertia + hold);
  }
  set.turnRate_W = fromEntry(model.entry, rate_E);
  set.turn_W += step * set.turnRate_W;
  // the tip also stays within the bounds of movement
  const double maximum = 0.5 * law.law.box[2] / model.parts.array.length.si();
  const double size = set.turn_W.norm();
  if (size > maximum) {
    set.turn_W *= maximum / size;
    set.turnRate_W.setZero();
    ++set.atBounds;
  }
}

/// Adds the published friction: proportional to the transverse force, with the direction given by
/// the carrier's proxy relative to the device.
void addPublishedFriction(const InsertionModel& model, InsertionState& state) noexcept
{
  PointSetState& set = state.points;
  set.friction_W.setZero();
  double ahead = 0.0;  // displacement of the proxy along E.z, times the number of points
  double pushed = 0.0;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    ahead += (state.position_W[i] - set.place_W[i]).dot(model.entry.out_W);
    pushed += state.normalForce[i];
  }
  const double across = std::fabs(set.pull_W.dot(model.entry.outward_W));
  if (!(pushed > 0.0) || set.pull_W.dot(model.entry.out_W) == 0.0 || ahead == 0.0) return;
  const double fraction = ahead > 0.0 ? model.parts.friction.kineticCoefficient
                                      : -model.parts.friction.kineticCoefficient;
  set.friction_W = fraction * across * model.entry.out_W;
}

void advanceOnce(const InsertionModel& model, InsertionState& state, const Drive& drive,
                 const Eigen::Vector3d& hand_W, const Eigen::Vector3d& handAxis_W,
                 PointWorkspace& workspace) noexcept
{
  const double inverseTimeStep = 1.0 / model.points->substep;
  PointSetState& set = state.points;
  const std::size_t n = state.position_W.size();

  // first the carrier: new base position and anchors of the points
  const Eigen::Vector3d base_W = nextBase(model, state, drive, hand_W);
  state.baseVelocity_W = inverseTimeStep * (base_W - state.base_W);
  state.base_W = base_W;
  set.handAxis_W = handAxis_W;
  const Eigen::Vector3d axis_W = carrierAxis(set, handAxis_W);
  const double insertion = insertionDistance(model, base_W, handAxis_W);
  const double spacing = pointedLength(model, set, insertion) / static_cast<double>(n - 1);

  // then every point against the surface
  set.pull_W.setZero();
  set.moment_W.setZero();
  bool meetsTurn = false;
  double armSquares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d arm_W = (static_cast<double>(i) * spacing) * axis_W;
    const Eigen::Vector3d placeVelocity_W = inverseTimeStep * (base_W + arm_W - set.place_W[i]);
    set.place_W[i] = base_W + arm_W;
    if (meetSurface(model, state, i, workspace)) meetsTurn = true;
    const Eigen::Vector3d pull_W = movePoint(model, state, i, placeVelocity_W);
    set.pull_W += pull_W;
    set.moment_W += arm_W.cross(pull_W);
    armSquares += arm_W.squaredNorm();
  }

  // finally the rotation of the carrier
  turnCarrier(model, set, armSquares);
  addPublishedFriction(model, state);
  if (set.turnedAt < 0.0 && meetsTurn && set.pull_W.dot(model.entry.out_W) != 0.0)
    set.turnedAt = insertion;
}

void read(const InsertionModel& model, InsertionState& state) noexcept
{
  const PointSetState& set = state.points;
  Readings& r = state.readings;
  r = Readings{};
  r.iterations = model.points->substeps;
  r.handForce_W = set.pull_W + set.friction_W;
  r.handTorque_W = model.points->law.turningStiffness * set.turn_W +
                   model.points->law.turningDamping * set.turnRate_W;
  r.axialForce = r.handForce_W.dot(model.entry.out_W);
  r.speed = -state.baseVelocity_W.dot(model.entry.out_W);
  r.depth = insertionDistance(model, state.base_W, set.handAxis_W);
  const Eigen::Vector3d& foremost_W = state.position_W.back();
  if (r.depth > 0.0) r.angularDepth = std::max(0.0, arcTangent(foremost_W.y(), foremost_W.x()));
  for (const double force : state.normalForce) {
    if (!(force > 0.0)) continue;
    ++r.contacts;
    r.wallForceTotal += force;
    r.wallForceMax = std::max(r.wallForceMax, force);
  }
  // one value that is finite only if all are
  const Eigen::Vector3d all_W =
      r.handForce_W + r.handTorque_W + state.base_W + foremost_W + set.turn_W;
  const double sum = all_W.x() + all_W.y() + all_W.z() + r.depth + r.wallForceTotal;
  r.isFinite = std::isfinite(sum);
}

}  // namespace

void resetPoints(const InsertionModel& model, InsertionState& state,
                 PointWorkspace& workspace) noexcept
{
  PointSetState& set = state.points;
  set.hand_W = state.base_W;
  set.handAxis_W = model.startAxis_W;
  for (Eigen::Vector3d* vector :
       {&set.turn_W, &set.turnRate_W, &set.friction_W, &set.pull_W, &set.moment_W})
    vector->setZero();
  set.turnedAt = -1.0;
  set.atBounds = 0;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    const Eigen::Vector3d& at_W = state.position_W[i];
    set.place_W[i] = at_W;
    set.proxy_W[i] = at_W;
    if (!(inside(model.entry, at_W) > 0.0)) continue;
    // A proxy enters through the opening, even if a script starts a point beyond a wall.
    set.proxy_W[i] = model.entry.origin_W;
    constexpr int calls = 16;  // of some millimeter each
    for (int call = 0; call < calls; ++call)
      set.proxy_W[i] =
          model.points->surface
              .follow(set.proxy_W[i], at_W, model.points->law.radius, workspace.allowed)
              .place_W;
  }
}

void advancePoints(const InsertionModel& model, InsertionState& state, const Drive& drive,
                   PointWorkspace& workspace) noexcept
{
  PointSetState& set = state.points;
  const int substeps = model.points->substeps;
  const Eigen::Vector3d from_W = set.hand_W;
  const Eigen::Vector3d fromAxis_W = set.handAxis_W;
  for (int k = 1; k <= substeps; ++k) {
    if (k == substeps) {
      advanceOnce(model, state, drive, drive.handPosition_W, drive.handAxis_W, workspace);
      break;
    }
    const double fraction = static_cast<double>(k) / substeps;
    advanceOnce(model, state, drive, from_W + fraction * (drive.handPosition_W - from_W),
                (fromAxis_W + fraction * (drive.handAxis_W - fromAxis_W)).normalized(), workspace);
  }
  set.hand_W = drive.handPosition_W;
  state.styletWithdrawal = drive.styletWithdrawal;
  ++state.tick;
  read(model, state);
}

}  // namespace perilymph::mechanics

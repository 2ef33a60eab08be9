#include "Contact.h"

#include <algorithm>
#include <cmath>

#include "Clearance.h"
#include "friction/Friction.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {

NormalForce normalForce(double penetration, double stiffness, double onset) noexcept
{
  if (penetration <= 0.0) return {0.0, 0.0};
  if (penetration < onset)
    return {0.5 * stiffness * penetration * penetration / onset, stiffness * penetration / onset};
  return {stiffness * (penetration - 0.5 * onset), stiffness};
}

SoftPush softPush(double penetration, double bone, double share, const ModelParts& parts) noexcept
{
  const double onset = parts.wall.onset.si();
  const double hardening = parts.membrane->hardening.si();
  const double soft = bone * (parts.membrane->perSamplePoint.si() / parts.wall.perSamplePoint.si());
  const NormalForce onBone = normalForce(penetration, bone, onset);
  NormalForce onMembrane = normalForce(penetration, soft, onset);
  const double harder = soft * penetration * penetration / (hardening * hardening);
  onMembrane.force += harder * penetration;
  onMembrane.slope += 3.0 * harder;
  SoftPush push;
  push.onMembrane = share * onMembrane.force;
  push.normal.force = (1.0 - share) * onBone.force + push.onMembrane;
  push.normal.slope = (1.0 - share) * onBone.slope + share * onMembrane.slope;
  push.byShare = energyOf(penetration, soft, onset) + 0.25 * harder * penetration * penetration -
                 energyOf(penetration, bone, onset);
  return push;
}

double energyOf(double penetration, double stiffness, double onset) noexcept
{
  if (penetration <= 0.0) return 0.0;
  if (penetration < onset)
    return stiffness * penetration * penetration * penetration / (6.0 * onset);
  return stiffness * (0.5 * penetration * (penetration - onset) + onset * onset / 6.0);
}

void addWallForces(const InsertionModel& model, InsertionState& state,
                   const std::vector<Eigen::Vector3d>& position_W, StepRoom& room) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double onset = model.parts.wall.onset.si();
  findWall(model, state, room);

  room.touches = 0;
  for (std::size_t i = 0; i < n; ++i) {
    state.normalForce[i] = 0.0;
    state.wallForce_W[i].setZero();
    state.membraneForce[i] = 0.0;
    room.frictionSpring_W[i].setZero();
    room.isSliding[i] = 0;
    room.slip[i] = 0.0;
    const anatomy::WallPoint& wall = room.wall[i];
    if (!wall.isNear) continue;
    const double penetration = model.radius[i] - wall.distance;
    if (penetration <= 0.0) continue;

    // Right behind the opening the wall sets in over one node spacing, so that a node passing the
    // edge does not meet it all at once.
    const double inside = (model.entry.origin_W - position_W[i]).dot(model.entry.out_W);
    const double share = std::clamp(inside / model.spacing, 0.0, 1.0);
    NormalForce push = normalForce(penetration, share * model.wallStiffness[i], onset);
    double onMembrane = wall.onMembrane ? push.force : 0.0;
    if (model.membrane) {
      const MembraneShare membrane =
          model.membrane->shareAt(position_W[i], model.radius[i], state.track[i], wall.normal_W);
      const SoftPush soft =
          softPush(penetration, share * model.wallStiffness[i], membrane.share, model.parts);
      push = soft.normal;
      onMembrane = soft.onMembrane;
      state.wallForce_W[i] -= soft.byShare * membrane.gradient_W;
    }
    // on a concave wall a node that moves along it also meets the normal turning back
    const Eigen::Vector3d& gradient_W = wall.normal_W;
    Eigen::Matrix3d stiffness =
        push.slope * gradient_W * gradient_W.transpose() + push.force * wall.turning_W;

    // friction knows the whole pressure, also where two walls' pushes cancel
    const double steep = gradient_W.norm();
    const Eigen::Vector3d normal_W =
        steep > 1e-6 ? Eigen::Vector3d(gradient_W / steep) : Eigen::Vector3d::Zero();
    const Eigen::Vector3d moved = position_W[i] - room.before_W[i];
    const Eigen::Vector3d slip = moved - normal_W * normal_W.dot(moved);
    const Eigen::Vector3d& spring = state.frictionSpring_W[i];
    const FrictionStep friction =
        frictionStep(slip + spring - normal_W * normal_W.dot(spring), push.force,
                     share * model.wallTangential[i], state.isSliding[i] != 0, state.slipSpeed[i],
                     normal_W, model.parts.friction);
    stiffness += friction.stiffness;

    state.normalForce[i] = push.force;
    state.wallForce_W[i] += push.force * gradient_W + friction.force_W;
    state.membraneForce[i] = onMembrane;
    room.frictionSpring_W[i] = friction.spring_W;
    room.isSliding[i] = friction.isSliding ? 1 : 0;
    room.slip[i] = slip.norm();
    room.force_W[i] += state.wallForce_W[i];
    room.touching[room.touches] = i;
    room.wallStiffness[room.touches] = {stiffness(0, 0), stiffness(0, 1), stiffness(0, 2),
                                        stiffness(1, 1), stiffness(1, 2), stiffness(2, 2)};
    ++room.touches;
  }
}

void addWallStiffness(StepRoom& room) noexcept
{
  for (std::size_t k = 0; k < room.touches; ++k)
    room.matrix.diagonal[blockOf(room.touching[k])] += room.wallStiffness[k];
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Contact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "contact/Clearance.h"
#include "contact/OpenPartition.h"
#include "friction/FrictionStep.h"
#include "lanes/Flags.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

/// Reach of an oval section, with half axes a along d and b across, toward a wall with the gradient n
/// of D: the root of the mean square over the walls that touch it,
///
///     r^2 = a^2 X + b^2 Y,   X = (1 - |n|^2) + f (n.d)^2,   Y likewise,   f = (2 |n|^2 - 1) / |n|^2.
///
/// Against one wall, |n| = 1 and r is the section's support function. In a groove, n is the mean of two
/// unit normals; it gets short and changes its direction within micrometers, r does not.
SectionReach meanReachToward(double a, double b, double x, double y, double squaredNorm) noexcept
{
  const double single = std::min(squaredNorm, 1.0);
  const double f = (2.0 * single - 1.0) / squaredNorm;
  SectionReach reach{true, 0.0, 0.0};
  reach.length = std::sqrt(a * a * (1.0 - single + f * x * x) + b * b * (1.0 - single + f * y * y));
  reach.rate = (a * a - b * b) * f * x * y / reach.length;
  return reach;
}

}  // namespace

SectionReach reachToward(const InsertionModel& model, const InsertionState& state,
                         const RodKinematics& rod, std::size_t i, const Eigen::Vector3d& normal_W,
                         const SectionReach& before) noexcept
{
  const double within = model.halfWithin[i], across = model.halfAcross[i];
  SectionReach reach{true, std::max(within, across), 0.0};
  const std::size_t edge = i > 0 ? i - 1 : 0;
  const Eigen::Vector3d& d = state.curl_W[edge];
  const Eigen::Vector3d t = rod.tangent_W[edge];
  const double x = normal_W.dot(d);
  const double y = normal_W.dot(t.cross(d));
  const double size = x * x + y * y;
  if (within == across || !(size > 1e-12)) return reach;
  const double delay = model.parts.wall.sectionDelay.si();
  if (!(delay > 0.0)) {
    reach.length = std::sqrt((within * within * x * x + across * across * y * y) / size);
    reach.rate = (within * within - across * across) * x * y / (size * reach.length);
    return reach;
  }
  reach = meanReachToward(within, across, x, y, size);
  if (!before.isKnown) return reach;
  const double fraction = model.timeStep / (model.timeStep + delay);
  reach.length = before.length + fraction * (reach.length - before.length);
  reach.rate = before.rate + fraction * (reach.rate - before.rate);
  return reach;
}

namespace {

SymmetricBlock<double> asBlock(const Eigen::Matrix3d& m) noexcept
{
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

/// Fraction of its stiffness with which the wall acts on a node at a depth behind the opening. What an
/// array that is too thick for the duct pays there: Mouth.h. Bone beside the opening has no edge.
double wallFraction(double inside, bool isBeside, const InsertionModel& model) noexcept
{
  const double edge = isBeside ? 0.0 : model.parts.wall.edge.si();
  if (!(edge > 0.0)) return std::clamp(inside / model.spacing, 0.0, 1.0);
  const double part = std::clamp(inside / edge, 0.0, 1.0);
  return part * part;
}

/// Normal force of the wall on a node near it, if they touch.
void normalContact(const InsertionModel& model, InsertionState& state, const RodKinematics& rod,
                   std::size_t i, ContactSet& contacts, TouchingNode& touching) noexcept
{
  const Eigen::Vector3d& at_W = state.position_W[i];
  double half = model.radius[i];
  const Eigen::Vector3d gradient_W = contacts.normal_W[i];
  // bone beside the opening supports the center line, whatever the orientation of the section
  const bool isOval = model.isOval && state.isBeside[i] == 0;
  if (isOval) {
    SectionReach& reach = contacts.section[i];
    if (!reach.isKnown) reach = reachToward(model, state, rod, i, gradient_W, state.section[i]);
    half = reach.length;
  }
  const double penetration = half - contacts.distance[i];
  if (penetration <= 0.0) return;
  const double onset = model.parts.wall.lining.si();

  const double fraction = wallFraction(anatomy::behindOpening(model.entry, at_W, state.track[i]),
                                       state.isBeside[i] != 0, model);
  NormalForce push = normalForce(penetration, fraction * model.wallStiffness[i], onset);
  Eigen::Vector3d& force_W = state.wallForce_W[i];
  state.membraneForce[i] = contacts.wall[i].onMembrane ? push.force : 0.0;
  if (model.membrane) {
    const MembraneFraction membrane =
        model.membrane->fractionAt(at_W, model.radius[i], state.track[i], gradient_W);
    const SoftContactForce soft = softContactForce(penetration, fraction * model.wallStiffness[i],
                                                   membrane.fraction, model.parts);
    push = soft.normal;
    state.membraneForce[i] = soft.onMembrane;
    force_W -= soft.byFraction * membrane.gradient_W;
  }
  force_W += push.force * gradient_W;
  if (isOval) {
    // The torque on a section derives from the same energy; the second derivative of its reach is
    // at most its own excess.
    const double rate = contacts.section[i].rate;
    state.wallTorque[i] = {-push.force * rate,
                           push.slope * rate * rate +
                               push.force * std::fabs(model.halfWithin[i] - model.halfAcross[i])};
  }

  touching.isPressed = true;
  touching.push = push;
  state.normalForce[i] = push.force;
  const double steep = gradient_W.norm();
  state.wallNormal_W[i] =
      steep > 1e-6 ? Eigen::Vector3d(gradient_W / steep) : Eigen::Vector3d::Zero();
}

/// Friction on a node that touched the wall at the end of the last step. Its bound is the total
/// pressure, even where the forces of two walls cancel.
void friction(const InsertionModel& model, InsertionState& state, const StepStart& start,
              TouchingNode& touching, FrictionHistory& history) noexcept
{
  const std::size_t i = touching.node;
  const Eigen::Vector3d& normal_W = history.normalBefore_W[i];
  const Eigen::Vector3d moved = state.position_W[i] - start.position_W[i];
  const Eigen::Vector3d slip = moved - normal_W * normal_W.dot(moved);
  const Eigen::Vector3d& spring = state.frictionSpring_W[i];
  Eigen::Vector3d film_W = slip;
  if (!state.frictionFilm_W.empty()) {
    const Eigen::Vector3d& film = state.frictionFilm_W[i];
    film_W += film - normal_W * normal_W.dot(film);
  }
  touching.friction =
      frictionWithFilm(slip + spring - normal_W * normal_W.dot(spring), film_W,
                       history.pressedBefore[i], model.wallTangential[i],
                       {state.isSliding[i] != 0, state.slipSpeed[i]}, model.parts.friction, model);
  state.wallForce_W[i] += touching.friction.force_W();
  if (!touching.isPressed) return;  // a node that left the wall has no friction history
  history.spring_W[i] = touching.friction.plain.spring_W;
  history.film_W[i] = touching.friction.film.spring_W;
  history.isSliding[i] = touching.friction.plain.isSliding ? 1 : 0;
  history.slip[i] = slip.norm();
}

/// Stiffness of a contact: on a concave wall the normal rotates as the node moves along it.
SymmetricBlock<double> stiffnessOf(const TouchingNode& touching, const ContactSet& contacts,
                                   const FrictionHistory& history) noexcept
{
  SymmetricBlock<double> stiffness;
  const bool isOpen = !contacts.open.empty() && contacts.open[touching.node].isOpen;
  if (touching.isPressed && isOpen) {
    stiffness = contacts.open[touching.node].stiffness;
  } else if (touching.isPressed) {
    const double slope = touching.push.slope, force = touching.push.force;
    const Eigen::Vector3d g = contacts.normal_W[touching.node];
    const Eigen::Matrix3d& k = contacts.wall[touching.node].shapeOperator_W;
    stiffness = {slope * g[0] * g[0] + force * k(0, 0), slope * g[0] * g[1] + force * k(0, 1),
                 slope * g[0] * g[2] + force * k(0, 2), slope * g[1] * g[1] + force * k(1, 1),
                 slope * g[1] * g[2] + force * k(1, 2), slope * g[2] * g[2] + force * k(2, 2)};
  }
  if (history.pressedBefore[touching.node] > 0.0)
    stiffness += asBlock(touching.friction.stiffness(history.normalBefore_W[touching.node]));
  return stiffness;
}

/// No node touches the wall. Forces and friction springs are those of the touching nodes alone.
void removeContacts(bool isOval, ContactSet& contacts, InsertionState& state,
                    FrictionHistory& history) noexcept
{
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const std::size_t i = contacts.touching[k].node;
    state.wallForce_W[i].setZero();
    history.spring_W[i].setZero();
    history.film_W[i].setZero();
  }
  contacts.touches = 0;
  const std::size_t n = state.normalForce.size();
  std::fill_n(state.normalForce.data(), n, 0.0);
  std::fill_n(state.membraneForce.data(), n, 0.0);
  std::fill_n(history.isSliding.data(), n, 0);
  std::fill_n(history.slip.data(), n, 0.0);
  if (isOval) std::fill_n(state.wallTorque.data(), n, WallTorque{});
}

/// Finds the nodes that press or did so before. The section of an oval array must tell its reach itself,
/// and so must every node at an open partition.
void setMayTouch(const InsertionModel& model, bool isOpen, const FrictionHistory& history,
                 ContactSet& contacts) noexcept
{
  if (isOpen) {
    std::ranges::fill(contacts.mayTouch, yes);
    return;
  }
  inLanes(0, contacts.mayTouch.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const auto isNear = load<T>(contacts.isNear, i) == yes;
    const auto wasPressed = load<T>(history.pressedBefore, i) > 0.0;
    const auto isAway = load<T>(model.radius, i) <= load<T>(contacts.distance, i);
    store(flagsOf<T>(wasPressed | (model.isOval ? isNear : isNear & (isAway == 0))),
          contacts.mayTouch, i);
  });
}

}  // namespace

NormalForce normalForce(double penetration, double stiffness, double onset) noexcept
{
  if (penetration <= 0.0) return {0.0, 0.0};
  if (penetration < onset)
    return {0.5 * stiffness * penetration * penetration / onset, stiffness * penetration / onset};
  return {stiffness * (penetration - 0.5 * onset), stiffness};
}

SoftContactForce softContactForce(double penetration, double bone, double fraction,
                                  const ModelParts& parts) noexcept
{
  const double onset = parts.wall.lining.si();
  const double bareOnset = parts.wall.bareOnset().si();
  const double hardening = parts.membrane->hardening.si();
  const double soft = bone * (parts.membrane->perSamplePoint.si() / parts.wall.perSamplePoint.si());
  const NormalForce onBone = normalForce(penetration, bone, onset);
  NormalForce onMembrane = normalForce(penetration, soft, bareOnset);
  const double harder = soft * penetration * penetration / (hardening * hardening);
  onMembrane.force += harder * penetration;
  onMembrane.slope += 3.0 * harder;
  SoftContactForce push;
  push.onMembrane = fraction * onMembrane.force;
  push.normal.force = (1.0 - fraction) * onBone.force + push.onMembrane;
  push.normal.slope = (1.0 - fraction) * onBone.slope + fraction * onMembrane.slope;
  push.byFraction = energyOf(penetration, soft, bareOnset) +
                    0.25 * harder * penetration * penetration - energyOf(penetration, bone, onset);
  return push;
}

double energyOf(double penetration, double stiffness, double onset) noexcept
{
  if (penetration <= 0.0) return 0.0;
  if (penetration < onset)
    return stiffness * penetration * penetration * penetration / (6.0 * onset);
  return stiffness * (0.5 * penetration * (penetration - onset) + onset * onset / 6.0);
}

void addWallForces(const InsertionModel& model, InsertionState& state, const StepStart& start,
                   const RodKinematics& rod, ContactSet& contacts, FrictionHistory& history,
                   std::vector<Eigen::Vector3d>& force_W) noexcept
{
  findWall(model, start, state, contacts);

  const bool isOpen = state.partition.isRuptured();
  removeContacts(model.isOval, contacts, state, history);
  setMayTouch(model, isOpen, history, contacts);
  forEachNode(contacts.mayTouch, yes, [&](std::size_t i) {
    const bool hasFriction = history.pressedBefore[i] > 0.0;
    TouchingNode& touching = contacts.touching[contacts.touches];
    touching.node = i;
    touching.isPressed = false;
    if (isOpen && contacts.open[i].isOpen)
      touching.isPressed = openContact(model, state, rod, i, contacts);
    else if (contacts.isNear[i] == yes)
      normalContact(model, state, rod, i, contacts, touching);
    if (hasFriction) friction(model, state, start, touching, history);
    if (!touching.isPressed && !hasFriction) return;
    force_W[i] += state.wallForce_W[i];
    ++contacts.touches;
  });
}

double frictionLag(const InsertionModel& model, const InsertionState& state,
                   const ContactSet& contacts, const FrictionHistory& history) noexcept
{
  const double atRim = std::fabs(contacts.rim.normalForce - history.rimPressedBefore);
  double sum = model.passage ? 0.0 : atRim;
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const std::size_t i = contacts.touching[k].node;
    sum += std::fabs(state.normalForce[i] - history.pressedBefore[i]);
  }
  const double inPassage = model.passage ? model.passage->friction.staticCoefficient * atRim : 0.0;
  return model.parts.friction.staticCoefficient * sum + inPassage;
}

void renewFriction(const InsertionState& state, const ContactSet& contacts,
                   FrictionHistory& history) noexcept
{
  history.rimPressedBefore = contacts.rim.normalForce;
  history.rimNormalBefore_W = contacts.rim.normal_W;
  for (std::size_t i = 0; i < state.normalForce.size(); ++i) {
    history.pressedBefore[i] = state.normalForce[i];
    history.normalBefore_W[i] = state.wallNormal_W[i];
  }
}

void addWallStiffness(const ContactSet& contacts, const FrictionHistory& history,
                      BandMatrix& matrix) noexcept
{
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const TouchingNode& touching = contacts.touching[k];
    matrix.diagonal.add(blockOf(touching.node), stiffnessOf(touching, contacts, history));
  }
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Contact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/Clearance.h"
#include "contact/OpenPartition.h"
#include "friction/FrictionKernel.h"
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

/// Depth of a node, or of four, behind the opening: anatomy::behindOpening().
template <class T>
PERILYMPH_IN_LANES T depthBehind(const anatomy::Entry& entry, const InsertionState& state,
                                 std::size_t i) noexcept
{
  const Triple<T> at_W = load<T>(state.position_W, i);
  const Eigen::Vector3d &origin_W = entry.origin_W, &out_W = entry.out_W;
  const T behind = (origin_W[0] - at_W.x) * out_W[0] + (origin_W[1] - at_W.y) * out_W[1] +
                   (origin_W[2] - at_W.z) * out_W[2];
  const T isBehind = ofEachNode<T>(
      i, [&](std::size_t node) { return state.track[node].isNearOpening() ? no : yes; });
  return oneOf(isBehind == yes, larger(behind, 10e-3), behind);
}

/// Stiffness of the wall at a node, or at four, which begins behind the opening. What an array that is
/// too thick for the duct pays there: Mouth.h. Bone beside the opening has no edge.
template <class T>
PERILYMPH_IN_LANES T stiffnessBehind(const InsertionModel& model, const InsertionState& state,
                                     const ContactSet& contacts, std::size_t i) noexcept
{
  const double edge = model.parts.wall.edge.si();
  const T inside = depthBehind<T>(model.entry, state, i);
  const T beside = smaller(larger(T(inside / model.spacing), 0.0), 1.0);
  T fraction = beside;
  if (edge > 0.0) {
    const T part = smaller(larger(T(inside / edge), 0.0), 1.0);
    fraction = oneOf(load<T>(contacts.isBeside, i) == yes, beside, T(part * part));
  }
  return fraction * load<T>(model.wallStiffness, i);
}

/// NormalForce of a node, or of four, that is pressed.
template <class T>
struct Push {
  T force, slope;
};

template <class T>
PERILYMPH_IN_LANES Push<T> pushAt(const T& penetration, const T& stiffness, double onset) noexcept
{
  const auto isSoft = penetration < onset;
  return {oneOf(isSoft, T(0.5 * stiffness * penetration * penetration / onset),
                T(stiffness * (penetration - 0.5 * onset))),
          oneOf(isSoft, T(stiffness * penetration / onset), stiffness)};
}

/// Finds the reach of an oval section toward the wall.
void findHalf(const InsertionModel& model, const InsertionState& state, const RodKinematics& rod,
              std::size_t i, ContactSet& contacts) noexcept
{
  contacts.half[i] = model.radius[i];
  // bone beside the opening supports the center line, whatever the orientation of the section
  if (state.isBeside[i] != 0) return;
  SectionReach& reach = contacts.section[i];
  if (!reach.isKnown)
    reach = reachToward(model, state, rod, i, contacts.normal_W[i], state.section[i]);
  contacts.half[i] = reach.length;
}

/// Normal force of the wall on a node, or on four: of those of `mayPress` that touch it.
template <class T, class Condition>
PERILYMPH_IN_LANES void normalContact(const InsertionModel& model, InsertionState& state,
                                      const Condition& mayPress, std::size_t i,
                                      ContactSet& contacts) noexcept
{
  const T half = load<T>(model.isOval ? contacts.half : model.radius, i);
  const T penetration = half - load<T>(contacts.distance, i);
  const auto isPressed = mayPress & ((penetration <= 0.0) == 0);
  store(flagsOf<T>(isPressed), contacts.isPressed, i);
  if (!inAny(isPressed)) return;
  const T stiffness = stiffnessBehind<T>(model, state, contacts, i);
  const Push<T> push = pushAt(penetration, stiffness, model.parts.wall.lining.si());
  const Triple<T> gradient_W = load<T>(contacts.normal_W, i);
  const T onMembrane =
      ofEachNode<T>(i, [&](std::size_t node) { return contacts.wall[node].onMembrane ? yes : no; });
  const T force = oneOf(isPressed, push.force, T{});
  store(force, state.normalForce, i);
  store(push.slope, contacts.slope, i);
  store(oneOf(onMembrane == yes, force, T{}), state.membraneForce, i);
  store(oneOf(isPressed, Triple<T>{} + push.force * gradient_W, Triple<T>{}), state.wallForce_W, i);
  const T steep = root(dot(gradient_W, gradient_W));
  const Triple<T> unit{gradient_W.x / steep, gradient_W.y / steep, gradient_W.z / steep};
  const Triple<T> normal_W = oneOf(steep > 1e-6, unit, Triple<T>{});
  store(oneOf(isPressed, normal_W, load<T>(state.wallNormal_W, i)), state.wallNormal_W, i);
}

/// The force of a wall that is partly membrane, in place of that on bone.
void pressMembrane(const InsertionModel& model, InsertionState& state, std::size_t i,
                   ContactSet& contacts) noexcept
{
  const double half = model.isOval ? contacts.half[i] : model.radius[i];
  const Eigen::Vector3d gradient_W = contacts.normal_W[i];
  const MembraneFraction membrane =
      model.membrane->fractionAt(state.position_W[i], model.radius[i], state.track[i], gradient_W);
  const SoftContactForce soft = softContactForce(half - contacts.distance[i],
                                                 stiffnessBehind<double>(model, state, contacts, i),
                                                 membrane.fraction, model.parts);
  state.membraneForce[i] = soft.onMembrane;
  state.normalForce[i] = soft.normal.force;
  contacts.slope[i] = soft.normal.slope;
  Eigen::Vector3d& force_W = state.wallForce_W[i];
  force_W.setZero();
  force_W -= soft.byFraction * membrane.gradient_W;
  force_W += soft.normal.force * gradient_W;
}

/// The torque on an oval section derives from the same energy; the second derivative of its reach is at
/// most its own excess.
void turnSection(const InsertionModel& model, InsertionState& state, std::size_t i,
                 const ContactSet& contacts) noexcept
{
  if (state.isBeside[i] != 0) return;
  const double rate = contacts.section[i].rate, force = state.normalForce[i];
  state.wallTorque[i] = {-force * rate,
                         contacts.slope[i] * rate * rate +
                             force * std::fabs(model.halfWithin[i] - model.halfAcross[i])};
}

/// Friction on a node, or on four, that touched the wall at the end of the last step. Its bound is the
/// total pressure, even where the forces of two walls cancel.
template <class T, class Condition>
PERILYMPH_IN_LANES void friction(const InsertionModel& model, InsertionState& state,
                                 const StepStart& start, const Condition& hasFriction,
                                 std::size_t i, const ContactSet& contacts,
                                 FrictionHistory& history) noexcept
{
  const Triple<T> normal_W = load<T>(history.normalBefore_W, i);
  const Triple<T> moved = load<T>(state.position_W, i) - load<T>(start.position_W, i);
  const Triple<T> slip = moved - dot(normal_W, moved) * normal_W;
  const Triple<T> spring = load<T>(state.frictionSpring_W, i);
  const bool hasFilm = !state.frictionFilm_W.empty();
  Triple<T> film_W = slip;
  if (hasFilm) {
    const Triple<T> film = load<T>(state.frictionFilm_W, i);
    film_W = film_W + (film - dot(normal_W, film) * normal_W);
  }
  const T slid = loadBytes<T>(state.isSliding, i);
  const FrictionOf<T> found =
      frictionWithFilmAt<T>(slip + spring - dot(normal_W, spring) * normal_W, film_W,
                            load<T>(history.pressedBefore, i), load<T>(model.wallTangential, i),
                            {slid, load<T>(state.slipSpeed, i)}, model.parts.friction, model);
  const Triple<T> onWall = load<T>(state.wallForce_W, i);
  const Triple<T> force_W =
      model.film.fraction > 0.0 ? found.plain.force_W + found.film.force_W : found.plain.force_W;
  store(oneOf(hasFriction, onWall + force_W, onWall), state.wallForce_W, i);
  store(found.plain, history.plain, i);
  if (model.film.fraction > 0.0) store(found.film, history.film, i);
  // a node that left the wall has no friction history
  const auto keeps = hasFriction & (load<T>(contacts.isPressed, i) == yes);
  store(oneOf(keeps, found.plain.spring_W, Triple<T>{}), history.spring_W, i);
  store(oneOf(keeps, found.film.spring_W, Triple<T>{}), history.film_W, i);
  store(oneOf(keeps, root(dot(slip, slip)), T{}), history.slip, i);
  storeBytes(flagsOf<T>(keeps & (found.plain.isSliding == yes)), history.isSliding, i);
}

/// Stiffness of a contact: on a concave wall the normal rotates as the node moves along it.
SymmetricBlock<double> stiffnessOf(const InsertionState& state, bool hasFilm, std::size_t i,
                                   const ContactSet& contacts,
                                   const FrictionHistory& history) noexcept
{
  SymmetricBlock<double> stiffness;
  const bool isOpen = !contacts.open.empty() && contacts.open[i].isOpen;
  const bool isPressed = contacts.isPressed[i] == yes;
  if (isPressed && isOpen) {
    stiffness = contacts.open[i].stiffness;
  } else if (isPressed) {
    const double slope = contacts.slope[i], force = state.normalForce[i];
    const Eigen::Vector3d g = contacts.normal_W[i];
    const Eigen::Matrix3d& k = contacts.wall[i].shapeOperator_W;
    stiffness = {slope * g[0] * g[0] + force * k(0, 0), slope * g[0] * g[1] + force * k(0, 1),
                 slope * g[0] * g[2] + force * k(0, 2), slope * g[1] * g[1] + force * k(1, 1),
                 slope * g[1] * g[2] + force * k(1, 2), slope * g[2] * g[2] + force * k(2, 2)};
  }
  if (history.pressedBefore[i] > 0.0) {
    const Eigen::Vector3d& normal_W = history.normalBefore_W[i];
    const Eigen::Matrix3d plain = history.plain.at(i, normal_W);
    stiffness += asBlock(hasFilm ? Eigen::Matrix3d(plain + history.film.at(i, normal_W)) : plain);
  }
  return stiffness;
}

/// No node touches the wall. Forces and friction springs are those of the touching nodes alone.
void removeContacts(bool isOval, ContactSet& contacts, InsertionState& state,
                    FrictionHistory& history) noexcept
{
  Eigen::Vector3d* force_W = state.wallForce_W.data();
  Eigen::Vector3d *spring_W = history.spring_W.data(), *film_W = history.film_W.data();
  for (const std::size_t i : std::span(contacts.touching).first(contacts.touches)) {
    force_W[i].setZero();
    spring_W[i].setZero();
    film_W[i].setZero();
  }
  contacts.touches = 0;
  std::ranges::fill(history.isSliding, 0);
  if (isOval) std::ranges::fill(state.wallTorque, WallTorque{});
}

/// Forces of the wall on a node, or on four: on those that press or did so before. The section of an
/// oval array must tell its reach itself.
template <class T>
PERILYMPH_IN_LANES void touch(const InsertionModel& model, InsertionState& state,
                              const StepStart& start, const RodKinematics& rod, std::size_t first,
                              ContactSet& contacts, FrictionHistory& history,
                              std::vector<Eigen::Vector3d>& force_W) noexcept
{
  constexpr std::size_t lanes = sizeof(T) / sizeof(double);
  store(T{}, state.normalForce, first);
  store(T{}, state.membraneForce, first);
  store(T{}, history.slip, first);
  const bool isOpen = state.partition.isRuptured();
  const auto isAway = load<T>(model.radius, first) <= load<T>(contacts.distance, first);
  const auto isNear = load<T>(contacts.isNear, first) == yes;
  const auto hasFriction = load<T>(history.pressedBefore, first) > 0.0;
  auto mayPress = model.isOval ? isNear : isNear & (isAway == 0);
  if (isOpen)
    mayPress = isNear & (ofEachNode<T>(first, [&](std::size_t i) {
                           return contacts.open[i].isOpen ? yes : no;
                         }) == no);
  else if (!inAny(mayPress | hasFriction))
    return;
  if (model.isOval) {
    store(flagsOf<T>(mayPress), contacts.mayPress, first);
    for (std::size_t i = first; i < first + lanes; ++i)
      if (contacts.mayPress[i] == yes) findHalf(model, state, rod, i, contacts);
  }
  normalContact<T>(model, state, mayPress, first, contacts);
  if (model.membrane || model.isOval || isOpen)
    for (std::size_t i = first; i < first + lanes; ++i) {
      const bool isPressed = contacts.isPressed[i] == yes;
      if (isPressed && model.membrane) pressMembrane(model, state, i, contacts);
      if (isPressed && model.isOval) turnSection(model, state, i, contacts);
      if (isOpen && contacts.open[i].isOpen)
        contacts.isPressed[i] = openContact(model, state, rod, i, contacts) ? yes : no;
    }
  if (inAny(hasFriction)) friction<T>(model, state, start, hasFriction, first, contacts, history);

  const auto touches = hasFriction | (load<T>(contacts.isPressed, first) == yes);
  const Triple<T> force = load<T>(force_W, first);
  store(oneOf(touches, force + load<T>(state.wallForce_W, first), force), force_W, first);
  for (std::size_t i = first; i < first + lanes; ++i) {
    contacts.touching[contacts.touches] = i;
    if (contacts.isPressed[i] == yes || history.pressedBefore[i] > 0.0) ++contacts.touches;
  }
}

}  // namespace

NormalForce normalForce(double penetration, double stiffness, double onset) noexcept
{
  if (penetration <= 0.0) return {0.0, 0.0};
  const Push<double> push = pushAt(penetration, stiffness, onset);
  return {push.force, push.slope};
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

  removeContacts(model.isOval, contacts, state, history);
  inLanesInPlace(0, state.position_W.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    touch<decltype(lane)>(model, state, start, rod, i, contacts, history, force_W);
  });
}

double frictionLag(const InsertionModel& model, const InsertionState& state,
                   const ContactSet& contacts, const FrictionHistory& history) noexcept
{
  const double atRim = std::fabs(contacts.rim.normalForce - history.rimPressedBefore);
  double sum = model.passage ? 0.0 : atRim;
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const std::size_t i = contacts.touching[k];
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

void addWallStiffness(const InsertionState& state, bool hasFilm, const ContactSet& contacts,
                      const FrictionHistory& history, BandMatrix& matrix) noexcept
{
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const std::size_t i = contacts.touching[k];
    matrix.diagonal.add(blockOf(i), stiffnessOf(state, hasFilm, i, contacts, history));
  }
}

}  // namespace perilymph::mechanics

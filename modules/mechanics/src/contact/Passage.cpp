// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Passage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "PublishedCarrier.h"
#include "contact/Contact.h"
#include "contact/Rim.h"
#include "friction/FrictionStep.h"
#include "perilymph/foundation/Math.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

constexpr double minDistance = 1e-9;   // [m]; avoids division by zero
constexpr double tableSpacing = 2e-6;  // [m]; a hundredth of a rib's flank

/// A value of the array at a distance from its tip, and its derivative.
struct Along {
  double value;
  double slope;
};

Along interpolate(const std::vector<double>& table, double spacing, double fromTip) noexcept
{
  const double place = std::clamp(fromTip / spacing, 0.0, static_cast<double>(table.size() - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const double slope = table[i + 1] - table[i];
  return {table[i] + (place - static_cast<double>(i)) * slope, slope / spacing};
}

/// Fraction of its stiffness with which a ring acts, by the depth of the tip behind it.
Along setIn(double depth, double tipRadius) noexcept
{
  const double t = std::clamp(depth / tipRadius, 0.0, 1.0);
  return {t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / tipRadius};
}

/// Distance that the axis of the array may have from that of the hole before they touch, and its
/// derivative: the clearance w of the carrier, less the height r of a rib,
///
///     w - r + r^2 / (4 w)     for r < 2 w, then 0,
///
/// so that a rib takes over the support as smoothly as it comes.
Along slackOf(double clearance, double clearanceRate, double rib, double ribRate) noexcept
{
  if (!(clearance > 0.5 * rib)) return {0.0, 0.0};
  const double ratio = 0.5 * rib / clearance;
  return {clearance - rib + 0.5 * rib * ratio,
          (1.0 - ratio * ratio) * clearanceRate + (ratio - 1.0) * ribRate};
}

/// The forces and the stiffness at a crossing with one ring.
struct RingContact {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();      ///< On the crossing [N].
  Eigen::Matrix3d stiffness_W = Eigen::Matrix3d::Zero();  ///< [N/m]
  Eigen::Vector3d tipForce_W = Eigen::Vector3d::Zero();   ///< On the tip, while the ring sets in.
  double normalForce = 0.0;                               ///< [N]
};

/// Rate at which the array crosses a ring's plane; an array lying in the plane does not cross it.
double steepnessOf(const InsertionModel& model, const Crossing& crossing) noexcept
{
  return std::min(model.entry.out_W.dot(crossing.along_W), -0.1 * model.spacing);
}

/// Adds the contact of one side of the array with the ring.
///
/// @param depth  Of the tip behind the ring [m].
void addSide(const InsertionModel& model, const Crossing& crossing, std::size_t ring, double depth,
             RingContact& contact) noexcept
{
  const PassageModel& passage = *model.passage;
  const Eigen::Vector3d& n_W = model.entry.out_W;
  Eigen::Vector3d out = -model.openingCenter_W;
  out += crossing.at_W;
  out -= n_W * n_W.dot(out);
  const double distance = out.norm();
  const bool isEdge = ring == 0 || ring + 1 == passage.rings;
  const double clearance = passage.radius - crossing.radius;
  const double highest = isEdge ? 0.0 : model.parts.array.ribHeight.si();
  if (distance <= slackOf(clearance, 0.0, highest, 0.0).value) return;  // whatever rib is there
  const RibProfile rib = isEdge ? RibProfile{0.0, 0.0} : ribsAt(model, crossing.fromTip);
  const Along slack =
      slackOf(clearance, -crossing.radiusRate, rib.height, -model.spacing * rib.slope);
  const double overlap = distance - slack.value;
  const NormalForce law =
      normalForce(overlap, passage.stiffness[ring], model.parts.wall.bareOnset().si());
  if (!(law.force > 0.0) || distance < minDistance) return;

  // a tip outside touches the outer edge as a sphere before: that ring acts at once
  const Along fraction = ring == 0 ? Along{1.0, 0.0} : setIn(depth, model.radius.back());
  const double steep = steepnessOf(model, crossing);
  const Eigen::Vector3d u_W = out / distance;
  const Eigen::Vector3d b_W = n_W.cross(u_W);
  const Eigen::Vector3d gradient_W =
      u_W - ((u_W.dot(crossing.along_W) - slack.slope) / steep) * n_W;
  const Eigen::Vector3d around_W = b_W - (b_W.dot(crossing.along_W) / steep) * n_W;
  const double force = fraction.value * law.force;
  contact.force_W -= force * gradient_W;
  contact.stiffness_W += fraction.value * law.slope * gradient_W * gradient_W.transpose() +
                         (force / distance) * around_W * around_W.transpose();
  contact.tipForce_W +=
      fraction.slope *
      energyOf(overlap, passage.stiffness[ring], model.parts.wall.bareOnset().si()) * n_W;
  contact.normalForce += force * gradient_W.norm();
}

/// Adds the force by which the squeezed array resists to entering at the outer edge (`sign` 1), or
/// is relieved by leaving at the inner edge (-1).
void addSqueeze(const InsertionModel& model, const Crossing& crossing, double sign,
                RingContact& contact) noexcept
{
  const PassageModel& passage = *model.passage;
  const Eigen::Vector3d& n_W = model.entry.out_W;
  const Along m = interpolate(passage.interference, passage.spacing, crossing.fromTip);
  if (!(m.value > 0.0)) return;
  const double perLength = 2.0 * pi * passage.modulus * m.value * m.value;
  const double slope = 4.0 * pi * passage.modulus * m.value * m.slope;
  // advance of the array's length by motion along n
  const double advance = model.spacing / -steepnessOf(model, crossing);
  contact.force_W += (sign * advance * perLength) * n_W;
  contact.stiffness_W += (advance * advance * std::max(sign * slope, 0.0)) * n_W * n_W.transpose();
}

/// Slip speed at which the loss at the inner edge has grown to 0.7 of its value [m/s]: the Stribeck speed
/// of the friction law (choice, low). With a hundredth of it steps that reverse there found no balance.
constexpr double lossSpeed = 1e-4;

/// Adds the hysteresis of what is released at the inner edge: a fraction of that force, against the
/// slip of the step. It takes energy in both directions and gives none.
void addExitLoss(const InsertionModel& model, const Crossing& crossing, double slip,
                 RingContact& contact) noexcept
{
  const PassageModel& passage = *model.passage;
  const Eigen::Vector3d& n_W = model.entry.out_W;
  const Along m = interpolate(passage.interference, passage.spacing, crossing.fromTip);
  if (!(m.value > 0.0)) return;
  const double advance = model.spacing / -steepnessOf(model, crossing);
  const double lost = passage.exitLoss * advance * 2.0 * pi * passage.modulus * m.value * m.value;
  const double softness = lossSpeed * model.timeStep;
  const double length = std::sqrt(slip * slip + softness * softness);
  const double ratio = softness / length;
  contact.force_W -= (lost * slip / length) * n_W;
  contact.stiffness_W += (lost * ratio * ratio / length) * n_W * n_W.transpose();
}

/// Friction along the passage.
Friction frictionAlong(const InsertionModel& model, const InsertionState& state,
                       const StepStart& start, const FrictionHistory& history,
                       const Crossing& outer, double& slip) noexcept
{
  const Eigen::Vector3d& n_W = model.entry.out_W;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < outer.count; ++k) {
    const std::size_t node = outer.first + k;
    moved += outer.weight[k] * (state.position_W[node] - start.position_W[node]);
  }
  slip = n_W.dot(moved);
  if (!(history.rimPressedBefore > 0.0)) return {};
  const double stretch = slip + n_W.dot(state.rim.spring_W);
  const double film = slip + n_W.dot(state.rim.film_W);
  return frictionWithFilm(stretch * n_W, film * n_W, history.rimPressedBefore,
                          model.parts.wall.tangentialPerSamplePoint.si(),
                          {state.rim.isSliding, state.rim.slipSpeed}, model.passage->friction,
                          model);
}

void store(const Crossing& crossing, const Eigen::Matrix3d& s, RimStiffness& stiffness) noexcept
{
  stiffness.first = crossing.first;
  stiffness.count = crossing.count;
  for (std::size_t k = 0; k < crossing.count; ++k) stiffness.weight[k] = crossing.weight[k];
  stiffness.stiffness = {s(0, 0), s(0, 1), s(0, 2), s(1, 1), s(1, 2), s(2, 2)};
}

}  // namespace

std::optional<PassageModel> passageOf(const InsertionModel& model)
{
  if (!model.parts.opening || !(model.parts.opening->passage.si() > 0.0)) return std::nullopt;
  const Opening& opening = *model.parts.opening;
  PassageModel passage;
  passage.radius = 0.5 * opening.width.si();
  passage.modulus = opening.passageModulus.si();
  passage.friction = model.parts.friction;
  passage.exitLoss = opening.ribExitLoss;
  if (opening.passageFriction) {
    const double coefficient = *opening.passageFriction;
    passage.friction = {coefficient, coefficient, coefficient, model.parts.friction.stribeck};
  }
  const double length = opening.passage.si();
  // a length of whole spacings may be a rounding above them
  const double onWall = std::clamp(std::ceil(length / passageRingSpacing - 1e-6), 1.0,
                                   static_cast<double>(maxPassageRings - 2));
  const double piece = length / onWall;
  passage.rings = static_cast<std::size_t>(onWall) + 2;
  for (std::size_t k = 1; k + 1 < passage.rings; ++k) {
    passage.plane[k] = -(static_cast<double>(k) - 0.5) * piece;
    passage.stiffness[k] = model.parts.wall.perSamplePoint.si() * (piece / samplePointSpacing);
  }
  passage.plane[passage.rings - 1] = -length;
  passage.stiffness[0] = model.parts.wall.rimStiffness().si();
  passage.stiffness[passage.rings - 1] = passage.stiffness[0];

  const electrode::ArrayDesign& array = model.parts.array;
  const double arrayLength = array.length.si();
  const auto pieces = static_cast<std::size_t>(std::ceil(arrayLength / tableSpacing));
  passage.spacing = arrayLength / static_cast<double>(pieces);
  double sum = 0.0;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double fromTip = static_cast<double>(i) * passage.spacing;
    const electrode::Section section = array.sectionAt(Length::fromSi(fromTip));
    const double radius = 0.5 * std::max(section.within.si(), section.across.si());
    const double m = std::max(radius + ribsAt(model, fromTip).height - passage.radius, 0.0);
    const double before = i > 0 ? passage.interference.back() : 0.0;
    // 2 pi R times the pressure 2 E m / R
    sum += 4.0 * pi * passage.modulus * 0.5 * (before + m) * passage.spacing;
    passage.interference.push_back(m);
    passage.radialForce.push_back(sum);
  }
  return passage;
}

void addPassageForces(const InsertionModel& model, const InsertionState& state,
                      const StepStart& start, const FrictionHistory& history, const Crossing& outer,
                      ContactSet& contacts, std::vector<Eigen::Vector3d>& force_W) noexcept
{
  const PassageModel& passage = *model.passage;
  const std::vector<Eigen::Vector3d>& x = state.position_W;
  const std::size_t tip = x.size() - 1;
  double slip = 0.0;
  const Friction friction = frictionAlong(model, state, start, history, outer, slip);
  Eigen::Vector3d total_W = Eigen::Vector3d::Zero();
  double normal = 0.0, inner = 0.0;
  Crossing crossing = outer;
  for (std::size_t k = 0; k < passage.rings; ++k) {
    const double plane = passage.plane[k];
    const double depth = plane - contacts.height[tip];
    // the rings lie one behind the other
    if (k > 0) crossing = crossingBehind(model, x, contacts.height, plane, crossing);
    if (crossing.count == 0) break;
    RingContact contact;
    addSide(model, crossing, k, depth, contact);
    if (k == 0) {
      addSqueeze(model, crossing, 1.0, contact);
      contact.force_W += friction.force_W();
      const Eigen::Vector3d& n_W = model.entry.out_W;
      const double along = n_W.dot(friction.stiffness(model.entry.outward_W) * n_W);
      contact.stiffness_W += along * n_W * n_W.transpose();
    } else if (k + 1 == passage.rings) {
      addSqueeze(model, crossing, -1.0, contact);
      if (passage.exitLoss > 0.0) addExitLoss(model, crossing, slip, contact);
      inner = interpolate(passage.radialForce, passage.spacing, crossing.fromTip).value;
    } else if (!(contact.normalForce > 0.0)) {
      continue;
    }
    for (std::size_t j = 0; j < crossing.count; ++j)
      force_W[crossing.first + j] += crossing.weight[j] * contact.force_W;
    force_W[tip] += contact.tipForce_W;
    store(crossing, contact.stiffness_W,
          k == 0 ? contacts.rimStiffness : contacts.innerRings[k - 1]);
    normal += contact.normalForce;
    total_W += contact.force_W + contact.tipForce_W;
  }
  normal += interpolate(passage.radialForce, passage.spacing, outer.fromTip).value - inner;

  if (normal > 0.0) {
    contacts.rim.spring_W = friction.plain.spring_W;
    contacts.rim.film_W = friction.film.spring_W;
    contacts.rim.isSliding = friction.plain.isSliding;
    contacts.rim.slipSpeed = std::fabs(slip) / model.timeStep;
    contacts.rim.normal_W = model.entry.outward_W;
  }
  contacts.rim.normalForce = normal;
  contacts.rim.force_W = total_W;
}

}  // namespace perilymph::mechanics

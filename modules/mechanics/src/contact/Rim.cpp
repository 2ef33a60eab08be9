// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Rim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/Contact.h"
#include "contact/Crossing.h"
#include "contact/Mouth.h"
#include "contact/Passage.h"
#include "friction/FrictionStep.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

constexpr double minBending = 1e-6;  // [m]; avoids division by zero

/// A force on the array: energy grows with `overlap`, whose gradient by the crossing is given.
struct ContactForce {
  NormalForce law{0.0, 0.0};
  Eigen::Vector3d gradient_W = Eigen::Vector3d::Zero();
};

/// Normal component of a rim contact.
struct RimContactForce {
  ContactForce near, opposite;
  Eigen::Vector3d normal_W;                           ///< Unit; friction is perpendicular to it.
  Eigen::Matrix3d shape_W = Eigen::Matrix3d::Zero();  ///< Stiffness due to the rotation of the
                                                      ///< normal [N/m].
};

/// Computes normal forces, stiffness and friction between rim and array at a crossing.
void rimContact(const InsertionModel& model, const InsertionState& state, const StepStart& start,
                const FrictionHistory& history, const Crossing& crossing,
                const RimContactForce& contact, ContactSet& contacts,
                std::vector<Eigen::Vector3d>& force_W) noexcept
{
  const ContactForce& near = contact.near;
  const ContactForce& opposite = contact.opposite;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < crossing.count; ++k) {
    const std::size_t node = crossing.first + k;
    moved += crossing.weight[k] * (state.position_W[node] - start.position_W[node]);
  }
  const double normal =
      near.law.force * near.gradient_W.norm() + opposite.law.force * opposite.gradient_W.norm();
  // the bound of friction is the pressure of the previous step, as at the wall
  const Eigen::Vector3d& across_W = history.rimNormalBefore_W;
  const Eigen::Vector3d slip = moved - across_W * across_W.dot(moved);
  const Eigen::Vector3d& spring = state.rim.spring_W;
  const Eigen::Vector3d& film = state.rim.film_W;
  Friction friction;
  if (history.rimPressedBefore > 0.0)
    friction =
        frictionWithFilm(slip + spring - across_W * across_W.dot(spring),
                         slip + film - across_W * across_W.dot(film), history.rimPressedBefore,
                         model.parts.wall.tangentialPerSamplePoint.si(),
                         {state.rim.isSliding, state.rim.slipSpeed}, model.parts.friction, model);

  const Eigen::Vector3d pushed_W = -near.law.force * near.gradient_W -
                                   opposite.law.force * opposite.gradient_W + friction.force_W();
  const Eigen::Matrix3d stiffness =
      near.law.slope * near.gradient_W * near.gradient_W.transpose() +
      opposite.law.slope * opposite.gradient_W * opposite.gradient_W.transpose() + contact.shape_W +
      friction.stiffness(across_W);
  for (std::size_t k = 0; k < crossing.count; ++k)
    force_W[crossing.first + k] += crossing.weight[k] * pushed_W;
  RimStiffness& left = contacts.rimStiffness;
  left.first = crossing.first;
  left.count = crossing.count;
  for (std::size_t k = 0; k < crossing.count; ++k) left.weight[k] = crossing.weight[k];
  left.stiffness = {stiffness(0, 0), stiffness(0, 1), stiffness(0, 2),
                    stiffness(1, 1), stiffness(1, 2), stiffness(2, 2)};

  if (normal > 0.0) {
    contacts.rim.spring_W = friction.plain.spring_W;
    contacts.rim.film_W = friction.film.spring_W;
    contacts.rim.isSliding = friction.plain.isSliding;
    contacts.rim.slipSpeed = slip.norm() / model.timeStep;
    contacts.rim.normal_W = contact.normal_W;
  }
  contacts.rim.normalForce = normal;
  contacts.rim.force_W = pushed_W;
}

/// Contact of a tip that is still outside: a sphere against the rounded rim and the bone around it.
void tipContact(const InsertionModel& model, const InsertionState& state, const StepStart& start,
                const FrictionHistory& history, double above, ContactSet& contacts,
                std::vector<Eigen::Vector3d>& force_W) noexcept
{
  const std::vector<Eigen::Vector3d>& x = state.position_W;
  const Opening& opening = *model.parts.opening;
  const double edgeRadius = opening.edgeRadius.si();
  const double reach = model.radius.back() + edgeRadius;
  if (above >= reach) return;
  const Eigen::Vector3d out = x.back() - model.openingCenter_W;
  const EllipseFoot foot =
      nearestOnEllipse(out.dot(model.entry.outward_W), out.dot(model.entry.vertical_W),
                       0.5 * opening.width.si(), 0.5 * opening.height.si());
  const double aside = std::max(foot.distance + edgeRadius, 0.0);
  const double distance = std::sqrt(above * above + aside * aside);
  if (distance >= reach) return;

  RimContactForce contact;
  contact.near.law = normalForce(reach - distance, model.parts.wall.rimStiffness().si(),
                                 model.parts.wall.bareOnset().si());
  const Eigen::Vector3d u_W =
      foot.normal[0] * model.entry.outward_W + foot.normal[1] * model.entry.vertical_W;
  contact.near.gradient_W =
      distance > 0.0 ? Eigen::Vector3d((aside * u_W - above * model.entry.out_W) / distance) : u_W;
  const Eigen::Vector3d b_W = model.entry.out_W.cross(u_W);
  const double around = distance > 0.0 ? contact.near.law.force * aside /
                                             (distance * std::max(foot.bending, minBending))
                                       : 0.0;
  Crossing crossing;
  crossing.first = x.size() - 1;
  crossing.count = 1;
  crossing.weight[0] = 1.0;
  contact.normal_W = contact.near.gradient_W;
  contact.shape_W = around * b_W * b_W.transpose();
  rimContact(model, state, start, history, crossing, contact, contacts, force_W);
}

}  // namespace

EllipseFoot nearestOnEllipse(double x, double y, double a, double b) noexcept
{
  // start from the normal of the concentric ellipse through the point; at the center, from the
  // short axis
  double u0 = x / (a * a), u1 = y / (b * b);
  const double size = std::sqrt(u0 * u0 + u1 * u1);
  if (size * std::min(a, b) > 1e-9) {
    u0 /= size;
    u1 /= size;
  } else {
    u0 = a < b ? 1.0 : 0.0;
    u1 = a < b ? 0.0 : 1.0;
  }
  double h = 0.0, rate = 0.0, bending = 0.0;
  int iterations = 8;
  for (int i = 0;; ++i) {
    h = std::sqrt(a * a * u0 * u0 + b * b * u1 * u1);
    rate = (b * b - a * a) * u0 * u1 / h;
    const double along = x * u0 + y * u1;
    // second derivative of h by the angle, from h^2 = a^2 u0^2 + b^2 u1^2
    const double second = ((b * b - a * a) * (u0 * u0 - u1 * u1) - rate * rate) / h;
    bending = second + along;
    if (i == iterations) break;
    const double gradient = y * u0 - x * u1 - rate;
    const double steep = bending > minBending ? bending : 0.05 * std::min(a, b);
    const double turn = std::clamp(gradient / steep, -0.5, 0.5);
    // Newton's next step would be of the order of its square
    if (std::fabs(turn) < 1e-8) iterations = i + 1;
    const double v0 = u0 - turn * u1, v1 = u1 + turn * u0;
    const double scale = 1.0 / std::sqrt(v0 * v0 + v1 * v1);
    u0 = scale * v0;
    u1 = scale * v1;
  }
  return {{u0, u1}, h - (x * u0 + y * u1), rate, bending};
}

RibProfile ribsAt(const InsertionModel& model, double fromTip) noexcept
{
  const electrode::ArrayDesign& array = model.parts.array;
  const double height = array.ribHeight.si();
  RibProfile profile{0.0, 0.0};
  if (!(height > 0.0)) return profile;
  // the rounded rim touches the rib earlier by its own radius
  const double reach = 0.5 * array.ribLength.si() + model.parts.opening->edgeRadius.si();
  for (const Length& rib : array.ribsFromTip) {
    const double off = fromTip - rib.si();
    if (std::fabs(off) >= reach) continue;
    const double q = off / reach;
    const double inside = 1.0 - q * q;
    if (inside <= 0.0) continue;
    profile.height += height * inside * inside;
    profile.slope -= height * 4.0 * q * inside / reach;
  }
  return profile;
}

void addRimForces(const InsertionModel& model, const InsertionState& state, const StepStart& start,
                  const FrictionHistory& history, ContactSet& contacts,
                  std::vector<Eigen::Vector3d>& force_W) noexcept
{
  const std::vector<Eigen::Vector3d>& x = state.position_W;
  contacts.rim = RimContact{};
  contacts.rimStiffness = RimStiffness{};
  if (model.passage) contacts.innerRings.fill(RimStiffness{});
  const bool isTight = std::isfinite(model.mouthRadius);
  if (!model.parts.opening && !isTight) return;
  Crossing crossing = crossingOf(model, x, contacts.height, state.rim.fromTip);
  contacts.rim.fromTip = crossing.fromTip;
  if (isTight) addMouthForces(model, crossing, force_W);
  if (!model.parts.opening) return;
  if (crossing.count == 0) {
    const double tip = contacts.height.back();
    if (!(tip < 0.0)) tipContact(model, state, start, history, tip, contacts, force_W);
    return;
  }

  if (model.passage) {
    addPassageForces(model, state, start, history, crossing, contacts, force_W);
    return;
  }
  const RibProfile rib = ribsAt(model, crossing.fromTip);
  crossing.radius += rib.height;
  crossing.radiusRate -= model.spacing * rib.slope;

  const Opening& opening = *model.parts.opening;
  const Eigen::Vector3d& n_W = model.entry.out_W;
  Eigen::Vector3d out = -model.openingCenter_W;
  for (std::size_t k = 0; k < crossing.count; ++k)
    out += crossing.weight[k] * x[crossing.first + k];
  const EllipseFoot foot =
      nearestOnEllipse(out.dot(model.entry.outward_W), out.dot(model.entry.vertical_W),
                       0.5 * opening.width.si(), 0.5 * opening.height.si());
  const double overlap = crossing.radius - foot.distance;
  if (overlap <= 0.0 && !(history.rimPressedBefore > 0.0)) return;

  const double stiffness = model.parts.wall.rimStiffness().si();
  const double onset = model.parts.wall.bareOnset().si();
  const Eigen::Vector3d u_W =
      foot.normal[0] * model.entry.outward_W + foot.normal[1] * model.entry.vertical_W;
  const Eigen::Vector3d b_W = n_W.cross(u_W);
  const double bending = std::max(foot.bending, minBending);
  // rate at which the array crosses the plane; an array lying in the plane does not cross it
  const double steep = std::min(n_W.dot(crossing.along_W), -0.1 * model.spacing);
  const auto gradientOf = [&](const Eigen::Vector3d& across_W, double radiusRate) {
    return Eigen::Vector3d(across_W -
                           ((across_W.dot(crossing.along_W) + radiusRate) / steep) * n_W);
  };

  RimContactForce contact;
  ContactForce& near = contact.near;
  ContactForce& opposite = contact.opposite;
  near.law = normalForce(overlap, stiffness, onset);
  near.gradient_W = gradientOf(u_W, crossing.radiusRate);
  // the opposite point moves with the nearest one
  const double alongNormal = out.dot(u_W);
  const double overlapThere = crossing.radius - foot.distance - 2.0 * alongNormal;
  opposite.law = normalForce(overlapThere, stiffness, onset);
  if (opposite.law.force > 0.0)
    opposite.gradient_W =
        gradientOf(-u_W - (2.0 * foot.reachRate / bending) * b_W, crossing.radiusRate);

  // friction acts along a tilted flank; between two flanks the tilts cancel
  const double both = near.law.force + opposite.law.force;
  const double tilt =
      near.gradient_W.dot(n_W) * near.law.force - opposite.gradient_W.dot(n_W) * opposite.law.force;
  contact.normal_W = both > 0.0 ? Eigen::Vector3d((u_W + (tilt / both) * n_W).normalized()) : u_W;
  const Eigen::Vector3d around_W = gradientOf(b_W, 0.0);
  const double curving = std::max(near.law.force - opposite.law.force, 0.0) / bending;
  contact.shape_W = curving * around_W * around_W.transpose();
  rimContact(model, state, start, history, crossing, contact, contacts, force_W);
}

namespace {

void addStiffness(const RimStiffness& rim, BandMatrix& matrix) noexcept
{
  const auto times = [&rim](double w) {
    const SymmetricBlock<double>& s = rim.stiffness;
    return SymmetricBlock<double>{w * s.xx, w * s.xy, w * s.xz, w * s.yy, w * s.yz, w * s.zz};
  };
  for (std::size_t i = 0; i < rim.count; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const SymmetricBlock<double> both = times(rim.weight[i] * rim.weight[j]);
      const Block<double> full{both.xx, both.xy, both.xz, both.xy, both.yy,
                               both.yz, both.xz, both.yz, both.zz};
      const std::size_t row = blockOf(rim.first + i), column = blockOf(rim.first + j);
      if (row == column) {
        matrix.diagonal.add(row, both);
        if (i != j) matrix.diagonal.add(row, both);  // both nodes belong to the base
      } else if (row == column + 1) {
        matrix.beside.add(row, full);
      } else {
        matrix.beyond.add(row, full);
      }
    }
}

}  // namespace

void addRimStiffness(const InsertionModel& model, const ContactSet& contacts,
                     BandMatrix& matrix) noexcept
{
  addStiffness(contacts.rimStiffness, matrix);
  if (!model.passage) return;
  for (const RimStiffness& ring : contacts.innerRings) addStiffness(ring, matrix);
}

}  // namespace perilymph::mechanics

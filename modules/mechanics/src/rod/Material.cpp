// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Material.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

constexpr double maxTurn = 0.2;  // maximum rotation of an edge in a step [rad]

/// Angle with the given sine and cosine; a series for small angles, as between two edges.
double angleOf(double sine, double cosine) noexcept
{
  const double x = sine * sine;
  // truncation error below 3e-10 of the angle
  if (cosine > 0.0 && x < 0.01)
    return sine * (1.0 + x * (1.0 / 6.0 + x * (3.0 / 40.0 + x * (5.0 / 112.0))));
  return arcTangent(sine, cosine);
}

/// The component of d perpendicular to t, normalized.
Vector3d across(const Vector3d& d, const Vector3d& t) noexcept
{
  const Vector3d rest = d - d.dot(t) * t;
  const double size = rest.squaredNorm();
  // from step to step the component along t is tiny: the first terms of the root suffice
  const double scale =
      std::fabs(size - 1.0) < 1e-5 ? 1.5 - 0.5 * size : 1.0 / std::sqrt(std::max(size, 1e-12));
  return scale * rest;
}

/// The two edges that meet at a node: tangents, directions of curl, and the directions
/// perpendicular to both.
struct TurningJoint {
  const Vector3d& p;
  const Vector3d& t;
  const Vector3d& d;
  const Vector3d& e;
  const Vector3d& dAcross;  ///< p x d
  const Vector3d& eAcross;  ///< t x e

  TurningJoint(const InsertionState& state, const RodKinematics& rod, std::size_t i) noexcept
      : p(rod.edge[i - 1].tangent_W),
        t(rod.edge[i].tangent_W),
        d(state.curl_W[i - 1]),
        e(state.curl_W[i]),
        dAcross(rod.curlAcross_W[i - 1]),
        eAcross(rod.curlAcross_W[i])
  {
  }
};

/// Angle from d, rotated with p into t by the smallest rotation, to e.
double twistOf(const TurningJoint& joint, double inverseSum) noexcept
{
  const double back = joint.d.dot(joint.t) * inverseSum;
  const double sine = back * joint.p.dot(joint.eAcross) - joint.d.dot(joint.eAcross);
  const double cosine = joint.d.dot(joint.e) - back * joint.p.dot(joint.e);
  return angleOf(sine, cosine);
}

/// Direction of the larger EI of an oval section: that of the curl, or perpendicular to it.
Vector3d stifferWay(const InsertionModel& model, const TurningJoint& joint, std::size_t i) noexcept
{
  if (model.stifferAcross[i] == 0) return 0.5 * (joint.d + joint.e);
  return 0.5 * (joint.p.cross(joint.d) + joint.t.cross(joint.e));
}

/// Derivatives of the energy of the joint at node i by the rotation of its two edges.
struct TurnEnergy {
  double last = 0.0, next = 0.0;          ///< First derivatives [N.m].
  double both = 0.0;                      ///< A quarter of the second derivative by a common
                                          ///< rotation.
  double lastStep = 0.0, nextStep = 0.0;  ///< Second derivatives are products of these two.
};

/// Derivatives of the bending energy 1/2 (EI/h) |w - h kappa (d + e)/2|^2 by the rotation.
TurnEnergy bendingByTurn(const InsertionModel& model, const SectionStiffness& section,
                         const RodKinematics& rod, const TurningJoint& joint,
                         std::size_t i) noexcept
{
  const double rest = section.restBend[i];
  const double moment = rest * section.bending[i] / model.spacing;
  const double c = rod.inverseSum[i];
  const auto& [p, t, d, e, dAcross, eAcross] = joint;
  TurnEnergy energy;
  energy.last = -moment * (c * t.dot(dAcross) - 0.25 * rest * e.dot(dAcross));
  energy.next = moment * (c * p.dot(eAcross) + 0.25 * rest * d.dot(eAcross));
  energy.both = 0.25 * std::max(moment * c * (t.dot(d) - p.dot(e)), 0.0);
  return energy;
}

/// Adds the derivatives of the excess bending energy of an oval section.
void addOval(const InsertionModel& model, const SectionStiffness& section, const RodKinematics& rod,
             const TurningJoint& joint, std::size_t i, TurnEnergy& energy) noexcept
{
  const double more = section.bendingExcess[i] / model.spacing;
  const double rest = section.restBend[i];
  const auto& [p, t, d, e, dAcross, eAcross] = joint;
  const Vector3d s = (2.0 * rod.inverseSum[i]) * (t - p) - (0.5 * rest) * (d + e);
  const double along = s.dot(stifferWay(model, joint, i));
  const bool isAcross = model.stifferAcross[i] != 0;
  const double lastRate = 0.5 * (isAcross ? -s.dot(d) - rest : s.dot(dAcross));
  const double nextRate = 0.5 * (isAcross ? -s.dot(e) - rest : s.dot(eAcross));
  energy.last += more * along * lastRate;
  energy.next += more * along * nextRate;
  const double root = std::sqrt(more);
  energy.lastStep = root * lastRate;
  energy.nextStep = root * nextRate;
}

TurnEnergy energyByTurn(const InsertionModel& model, const SectionStiffness& section,
                        const RodKinematics& rod, const TurningJoint& joint, std::size_t i) noexcept
{
  TurnEnergy energy = bendingByTurn(model, section, rod, joint, i);
  if (model.bendingExcess[i] > 0.0) addOval(model, section, rod, joint, i, energy);
  return energy;
}

/// Adds k b b^T for a twist with gradient b by the motion of the node after i relative to the node
/// before it.
void addTwist(BandMatrix& matrix, std::size_t i, const Vector3d& b, double k) noexcept
{
  const Vector3d l = k * b;
  const SymmetricBlock<double> block{l[0] * b[0], l[0] * b[1], l[0] * b[2],
                                     l[1] * b[1], l[1] * b[2], l[2] * b[2]};
  const std::size_t row = blockOf(i + 1), column = blockOf(i - 1);
  matrix.diagonal[row] += block;
  matrix.diagonal[column] += block;
  std::vector<Block<double>>& between = row == column + 1 ? matrix.beside : matrix.beyond;
  between[row] -=
      {block.xx, block.xy, block.xz, block.xy, block.yy, block.yz, block.xz, block.yz, block.zz};
}

/// Adds k g g^T for the gradients g of a joint by its three nodes.
void addRankOne(BandMatrix& matrix, std::size_t i, const std::array<Vector3d, 3>& g,
                double k) noexcept
{
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const Vector3d l = k * g[a];
      const Vector3d& r = g[b];
      const Block<double> block{l[0] * r[0], l[0] * r[1], l[0] * r[2], l[1] * r[0], l[1] * r[1],
                                l[1] * r[2], l[2] * r[0], l[2] * r[1], l[2] * r[2]};
      const std::size_t row = blockOf(i - 1 + a), column = blockOf(i - 1 + b);
      if (row == column) {
        matrix.diagonal[row] += {block.xx, 0.5 * (block.xy + block.yx), 0.5 * (block.xz + block.zx),
                                 block.yy, 0.5 * (block.yz + block.zy), block.zz};
        // both nodes belong to the base: their coupling counts twice
        if (a != b)
          matrix.diagonal[row] +=
              {block.xx, 0.5 * (block.xy + block.yx), 0.5 * (block.xz + block.zx),
               block.yy, 0.5 * (block.yz + block.zy), block.zz};
      } else if (row == column + 1) {
        matrix.beside[row] += block;
      } else {
        matrix.beyond[row] += block;
      }
    }
}

/// Transports each edge's direction of curl with the edge, and computes the perpendicular.
void followEdges(const Vector3d& handCurl_W, InsertionState& state, RodKinematics& rod) noexcept
{
  const std::size_t edges = state.curl_W.size() - 1;
  state.curl_W[0] = handCurl_W;
  for (std::size_t j = 0; j < edges; ++j) {
    const Vector3d& t = rod.edge[j].tangent_W;
    state.curl_W[j] = across(state.curl_W[j], t);
    rod.curlAcross_W[j] = t.cross(state.curl_W[j]);
  }
}

/// Computes the torque on each edge and its stiffness; coupling of neighbors in `turns.beside`.
void findTorques(const InsertionModel& model, const InsertionState& state,
                 const SectionStiffness& section, RodKinematics& rod, TwistSystem& turns) noexcept
{
  const auto edges = static_cast<std::size_t>(model.nodes - 1);
  const double inverseSpacing = 1.0 / model.spacing;
  turns.torque[0] = turns.stiffness[0] = 0.0;
  for (std::size_t i = 1; i < edges; ++i) {
    const TurningJoint joint(state, rod, i);
    rod.twist[i] = twistOf(joint, rod.inverseSum[i]);
    const double stiffness = model.twisting[i] * inverseSpacing;
    const double moment = stiffness * rod.twist[i];
    const TurnEnergy energy = energyByTurn(model, section, rod, joint, i);
    turns.torque[i - 1] += moment - energy.last;
    turns.stiffness[i - 1] += stiffness + energy.both + energy.lastStep * energy.lastStep;
    turns.torque[i] = -moment - energy.next;
    turns.stiffness[i] = stiffness + energy.both + energy.nextStep * energy.nextStep;
    turns.beside[i] = -stiffness + energy.both + energy.lastStep * energy.nextStep;
  }
  if (!model.isOval) return;
  for (std::size_t i = 1; i <= edges; ++i) {
    turns.torque[i - 1] += state.wallTorque[i].torque;
    turns.stiffness[i - 1] += state.wallTorque[i].stiffness;
  }
}

/// Rotates every edge except the first, which is held by the hand: tridiagonal elimination from the
/// tip.
void turnEdges(InsertionState& state, RodKinematics& rod, TwistSystem& turns) noexcept
{
  const std::size_t edges = state.curl_W.size() - 1;
  for (std::size_t j = edges - 1; j > 1; --j) {
    const double inverseStiffness = 1.0 / turns.stiffness[j];
    const double factor = turns.beside[j] * inverseStiffness;
    turns.stiffness[j - 1] -= factor * turns.beside[j];
    turns.torque[j - 1] -= factor * turns.torque[j];
    turns.torque[j] *= inverseStiffness;
    turns.beside[j] = factor;
  }
  turns.torque[1] /= turns.stiffness[1];
  double last = 0.0;
  for (std::size_t j = 1; j < edges; ++j) {
    const double turn = std::clamp(turns.torque[j] - turns.beside[j] * last, -maxTurn, maxTurn);
    const double x = turn * turn;
    const double sine = turn * (1.0 - x * (1.0 / 6.0 - x * (1.0 / 120.0)));
    const double cosine = 1.0 - x * (0.5 - x * (1.0 / 24.0 - x * (1.0 / 720.0)));
    state.curl_W[j] = cosine * state.curl_W[j] + sine * rod.curlAcross_W[j];
    rod.twist[j] += turn - last;
    last = turn;
  }
  state.curl_W[edges] = state.curl_W[edges - 1];
}

}  // namespace

void turnMaterial(const InsertionModel& model, const Vector3d& curl_W,
                  const SectionStiffness& section, InsertionState& state, RodKinematics& rod,
                  TwistSystem& turns) noexcept
{
  const auto edges = static_cast<std::size_t>(model.nodes - 1);
  const double inverseSpacing = 1.0 / model.spacing;
  followEdges(curl_W, state, rod);
  findTorques(model, state, section, rod, turns);
  turnEdges(state, rod, turns);
  for (std::size_t i = 1; i < edges; ++i) {
    rod.restBend_W[i] = (0.5 * section.restBend[i]) * (state.curl_W[i - 1] + state.curl_W[i]);
    rod.twistRate_W[i] = (inverseSpacing * rod.inverseSum[i]) *
                         rod.edge[i - 1].tangent_W.cross(rod.edge[i].tangent_W);
    if (model.bendingExcess[i] > 0.0)
      rod.stiffer_W[i] = stifferWay(model, TurningJoint(state, rod, i), i);
  }
  rod.curlAcross_W[1] = rod.edge[1].tangent_W.cross(state.curl_W[1]);
  rod.twistTorque = model.twisting[1] * inverseSpacing * rod.twist[1] -
                    energyByTurn(model, section, rod, TurningJoint(state, rod, 1), 1).last;
  if (model.isOval) rod.twistTorque += state.wallTorque[1].torque;
}

Vector3d ovalStress(const InsertionModel& model, const SectionStiffness& section,
                    const RodKinematics& rod, std::size_t i, const Vector3d& bend_W) noexcept
{
  const double damping = dampingTime / model.timeStep;
  const Vector3d& way = rod.stiffer_W[i];
  const double along =
      way.dot(bend_W - rod.restBend_W[i]) + damping * way.dot(bend_W - rod.bendBefore_W[i]);
  return (section.bendingExcess[i] / model.spacing * along) * way;
}

void addMaterialStiffness(const InsertionModel& model, const SectionStiffness& section,
                          const RodKinematics& rod, BandMatrix& matrix) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double damping = dampingTime / model.timeStep;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    addTwist(matrix, i, rod.twistRate_W[i], model.twisting[i] / model.spacing);
    if (!(model.bendingExcess[i] > 0.0)) continue;
    const RodEdge& last = rod.edge[i - 1];
    const RodEdge& next = rod.edge[i];
    const Vector3d& way = rod.stiffer_W[i];
    const double c = 2.0 / std::max(1.0 + last.tangent_W.dot(next.tangent_W), 1e-3);
    const Vector3d byNext =
        c * next.inverseLength * (way - way.dot(next.tangent_W) * next.tangent_W);
    const Vector3d byLast =
        c * last.inverseLength * (way - way.dot(last.tangent_W) * last.tangent_W);
    addRankOne(matrix, i, {byLast, -byLast - byNext, byNext},
               section.bendingExcess[i] / model.spacing * (1.0 + damping));
  }
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Material.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lanes/Flags.h"
#include "perilymph/foundation/Math.h"
#include "rod/Relaxation.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

// Maximum rotation of an edge in a step [rad]: the series of its sine and cosine hold within it.
constexpr double maxTurn = 0.2;

/// Angle with the given sine and cosine; a series for small angles, as between two edges.
template <class T>
PERILYMPH_IN_LANES T angleOf(const T& sine, const T& cosine) noexcept
{
  const T x = sine * sine;
  // truncation error below 3e-10 of the angle
  const auto isSmall = (cosine > 0.0) & (x < 0.01);
  if (!inAll(isSmall))
    return laneByLane(sine, cosine, [](double s, double c) {
      const double q = s * s;
      if (c > 0.0 && q < 0.01)
        return s * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (5.0 / 112.0))));
      return arcTangent(s, c);
    });
  return sine * (1.0 + x * (1.0 / 6.0 + x * (3.0 / 40.0 + x * (5.0 / 112.0))));
}

/// The component of d perpendicular to t, normalized.
template <class T>
PERILYMPH_IN_LANES Triple<T> across(const Triple<T>& d, const Triple<T>& t) noexcept
{
  const Triple<T> rest = d - dot(d, t) * t;
  const T size = dot(rest, rest);
  // from step to step the component along t is tiny: the first terms of the root suffice
  const T series = 1.5 - 0.5 * size;
  const auto isTiny = (size - 1.0 < 1e-5) & (1.0 - size < 1e-5);
  if (inAll(isTiny)) return series * rest;
  return oneOf(isTiny, series, T(1.0 / root(larger(size, 1e-12)))) * rest;
}

/// The two edges that meet at a node, or at four: tangents, directions of curl, and the directions
/// perpendicular to both.
template <class T>
struct TurningJoint {
  Triple<T> p;
  Triple<T> t;
  Triple<T> d;
  Triple<T> e;
  Triple<T> dAcross;  ///< p x d
  Triple<T> eAcross;  ///< t x e
  T inverseSum;       ///< 1 / (1 + p . t)

  PERILYMPH_IN_LANES TurningJoint(const InsertionState& state, const RodKinematics& rod,
                                  std::size_t i) noexcept
      : p(load<T>(rod.tangent_W, i - 1)),
        t(load<T>(rod.tangent_W, i)),
        d(load<T>(state.curl_W, i - 1)),
        e(load<T>(state.curl_W, i)),
        dAcross(load<T>(rod.curlAcross_W, i - 1)),
        eAcross(load<T>(rod.curlAcross_W, i)),
        inverseSum(load<T>(rod.inverseSum, i))
  {
  }
};

/// Angle from d, rotated with p into t by the smallest rotation, to e.
template <class T>
PERILYMPH_IN_LANES T twistOf(const TurningJoint<T>& joint) noexcept
{
  const T back = dot(joint.d, joint.t) * joint.inverseSum;
  const T sine = back * dot(joint.p, joint.eAcross) - dot(joint.d, joint.eAcross);
  const T cosine = dot(joint.d, joint.e) - back * dot(joint.p, joint.e);
  return angleOf(sine, cosine);
}

/// Whether the larger EI is across the plane of curl.
template <class T>
PERILYMPH_IN_LANES auto isStifferAcross(const InsertionModel& model, std::size_t i) noexcept
{
  return loadBytes<T>(model.stifferAcross, i) != 0.0;
}

/// Direction of the larger EI of an oval section: that of the curl, or perpendicular to it.
template <class T>
PERILYMPH_IN_LANES Triple<T> stifferWay(const InsertionModel& model, const TurningJoint<T>& joint,
                                        std::size_t i) noexcept
{
  const T half = T{} + 0.5;
  return oneOf(isStifferAcross<T>(model, i),
               half * (cross(joint.p, joint.d) + cross(joint.t, joint.e)),
               half * (joint.d + joint.e));
}

/// Derivatives of the energy of the joint at a node by the rotation of its two edges.
template <class T>
struct TurnEnergy {
  T last{}, next{};          ///< First derivatives [N.m].
  T both{};                  ///< A quarter of the second derivative by a common rotation.
  T lastStep{}, nextStep{};  ///< Second derivatives are products of these two.
};

/// Derivatives of the bending energy 1/2 (EI/h) |w - h kappa (d + e)/2|^2 by the rotation.
template <class T>
PERILYMPH_IN_LANES TurnEnergy<T> bendingByTurn(const SectionStiffness& section,
                                               const TurningJoint<T>& joint, std::size_t i) noexcept
{
  const T rest = load<T>(section.restBend, i);
  const T moment = load<T>(section.restMoment, i);
  const T c = joint.inverseSum;
  TurnEnergy<T> energy;
  if (section.holds) {
    const HeldJoint<T> held(joint, load<T>(section.heldAlong, i), load<T>(section.heldAcross, i));
    const T stiffness = load<T>(section.bending, i);
    energy.last =
        -stiffness * (c * dot(joint.t, held.lastRate) - 0.25 * dot(held.next, held.lastRate));
    energy.next =
        stiffness * (c * dot(joint.p, held.nextRate) + 0.25 * dot(held.last, held.nextRate));
    energy.both =
        0.25 * larger(stiffness * c * (dot(joint.t, held.last) - dot(joint.p, held.next)), 0.0);
    return energy;
  }
  energy.last =
      -moment * (c * dot(joint.t, joint.dAcross) - 0.25 * rest * dot(joint.e, joint.dAcross));
  energy.next =
      moment * (c * dot(joint.p, joint.eAcross) + 0.25 * rest * dot(joint.d, joint.eAcross));
  energy.both = 0.25 * larger(moment * c * (dot(joint.t, joint.d) - dot(joint.p, joint.e)), 0.0);
  return energy;
}

/// Adds the derivatives of the excess bending energy of an oval section.
template <class T>
PERILYMPH_IN_LANES void addOval(const InsertionModel& model, const SectionStiffness& section,
                                const TurningJoint<T>& joint, std::size_t i,
                                TurnEnergy<T>& energy) noexcept
{
  const T more = load<T>(section.bendingExcess, i);
  T rest = load<T>(section.restBend, i), aside{};
  const T twice = 2.0 * joint.inverseSum, half = 0.5 * rest;
  Triple<T> s = twice * (joint.t - joint.p) - half * (joint.d + joint.e);
  if (section.holds) {
    // what wires hold is none of the silicone's
    const HeldJoint<T> held(joint, load<T>(section.heldAlong, i) - load<T>(section.setAlong, i),
                            load<T>(section.heldAcross, i) - load<T>(section.setAcross, i));
    s = twice * (joint.t - joint.p) - (T{} + 0.5) * (held.last + held.next);
    rest = held.along;
    aside = held.across;
  }
  const auto isAcross = isStifferAcross<T>(model, i);
  const Triple<T> stiffer =
      (T{} + 0.5) * oneOf(isAcross, joint.dAcross + joint.eAcross, joint.d + joint.e);
  const T along = dot(s, stiffer);
  const T lastRate =
      0.5 * oneOf(isAcross, T(-dot(s, joint.d) - rest), T(dot(s, joint.dAcross) + aside));
  const T nextRate =
      0.5 * oneOf(isAcross, T(-dot(s, joint.e) - rest), T(dot(s, joint.eAcross) + aside));
  const T size = root(more);
  const auto isOval = load<T>(model.bendingExcess, i) > 0.0;
  energy.last = oneOf(isOval, T(energy.last + more * along * lastRate), energy.last);
  energy.next = oneOf(isOval, T(energy.next + more * along * nextRate), energy.next);
  energy.lastStep = oneOf(isOval, T(size * lastRate), energy.lastStep);
  energy.nextStep = oneOf(isOval, T(size * nextRate), energy.nextStep);
}

template <class T>
PERILYMPH_IN_LANES TurnEnergy<T> energyByTurn(const InsertionModel& model,
                                              const SectionStiffness& section,
                                              const TurningJoint<T>& joint, std::size_t i) noexcept
{
  TurnEnergy<T> energy = bendingByTurn(section, joint, i);
  if (model.isOval) addOval(model, section, joint, i, energy);
  return energy;
}

/// Transports each edge's direction of curl with the edge, and computes the perpendicular.
void followEdges(const Vector3d& handCurl_W, InsertionState& state, RodKinematics& rod) noexcept
{
  state.curl_W[0] = handCurl_W;
  inLanesInPlace(0, state.curl_W.size() - 1, [&](auto lane, std::size_t j) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> t = load<T>(rod.tangent_W, j);
    const Triple<T> d = across(load<T>(state.curl_W, j), t);
    store(d, state.curl_W, j);
    store(cross(t, d), rod.curlAcross_W, j);
  });
}

/// Computes the torque on each edge and its stiffness; coupling of neighbors in `turns.beside`.
void findTorques(const InsertionModel& model, const InsertionState& state,
                 const SectionStiffness& section, RodKinematics& rod, TwistSystem& turns) noexcept
{
  const auto edges = static_cast<std::size_t>(model.nodes - 1);
  const double inverseSpacing = 1.0 / model.spacing;
  turns.torque[0] = turns.stiffness[0] = 0.0;
  inLanes(1, edges, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const TurningJoint<T> joint(state, rod, i);
    const T twist = twistOf(joint);
    const T stiffness = load<T>(model.twisting, i) * inverseSpacing;
    const T moment = stiffness * twist;
    const TurnEnergy<T> energy = energyByTurn(model, section, joint, i);
    store(twist, rod.twist, i);
    store(T(moment - energy.last), turns.torqueByNext, i - 1);
    store(T(stiffness + energy.both + energy.lastStep * energy.lastStep), turns.stiffnessByNext,
          i - 1);
    store(T(-moment - energy.next), turns.torque, i);
    store(T(stiffness + energy.both + energy.nextStep * energy.nextStep), turns.stiffness, i);
    store(T(-stiffness + energy.both + energy.lastStep * energy.nextStep), turns.beside, i);
  });
  inLanesInPlace(0, edges - 1, [&](auto lane, std::size_t j) PERILYMPH_KERNEL {
    using T = decltype(lane);
    store(T(load<T>(turns.torque, j) + load<T>(turns.torqueByNext, j)), turns.torque, j);
    store(T(load<T>(turns.stiffness, j) + load<T>(turns.stiffnessByNext, j)), turns.stiffness, j);
  });
  if (!model.isOval) return;
  const WallTorque* wall = state.wallTorque.data() + 1;
  double *torque = turns.torque.data(), *stiffness = turns.stiffness.data();
  for (std::size_t j = 0; j < edges; ++j) {
    torque[j] += wall[j].torque;
    stiffness[j] += wall[j].stiffness;
  }
}

/// Two numbers: one for the edges from the base, one for those from the tip.
using Pair [[gnu::vector_size(16)]] = double;

/// Solves for the rotation of every edge except the first, which is held by the hand: tridiagonal
/// elimination from both ends at once, and of the two or three edges in the middle last. A factor
/// replaces the coupling that it came from.
void solveTurns(std::size_t last, TwistSystem& turns) noexcept
{
  double *stiffnessOf = turns.stiffness.data(), *torqueOf = turns.torque.data();
  double *besideOf = turns.beside.data(), *turnOf = turns.turn.data();
  const std::size_t steps = (last - 2) / 2;  // edges eliminated from each end
  Pair stiffness{stiffnessOf[1], stiffnessOf[last]};
  Pair torque{torqueOf[1], torqueOf[last]};
  for (std::size_t k = 0; k < steps; ++k) {
    const std::size_t base = 1 + k, tip = last - k;
    const Pair beside{besideOf[base + 1], besideOf[tip]};
    const Pair inverseStiffness = 1.0 / stiffness;
    const Pair factor = beside * inverseStiffness;
    const Pair turn = torque * inverseStiffness;
    stiffness = Pair{stiffnessOf[base + 1], stiffnessOf[tip - 1]} - factor * beside;
    torque = Pair{torqueOf[base + 1], torqueOf[tip - 1]} - factor * torque;
    torqueOf[base] = turn[0], torqueOf[tip] = turn[1];
    besideOf[base + 1] = factor[0], besideOf[tip] = factor[1];
  }

  // the middle, from its tip to its base and back
  const std::size_t first = 1 + steps, end = last - steps;
  stiffnessOf[first] = stiffness[0], stiffnessOf[end] = stiffness[1];
  torqueOf[first] = torque[0], torqueOf[end] = torque[1];
  for (std::size_t j = end; j > first; --j) {
    const double factor = besideOf[j] / stiffnessOf[j];
    stiffnessOf[j - 1] -= factor * besideOf[j];
    torqueOf[j - 1] -= factor * torqueOf[j];
    torqueOf[j] /= stiffnessOf[j];
    besideOf[j] = factor;
  }
  const auto limited = [](double turn) { return std::clamp(turn, -maxTurn, maxTurn); };
  turnOf[first] = limited(torqueOf[first] / stiffnessOf[first]);
  for (std::size_t j = first + 1; j <= end; ++j)
    turnOf[j] = limited(torqueOf[j] - besideOf[j] * turnOf[j - 1]);

  const Pair highest{maxTurn, maxTurn}, lowest = -highest;
  Pair turn{turnOf[first], turnOf[end]};
  for (std::size_t k = steps; k-- > 0;) {
    const std::size_t base = 1 + k, tip = last - k;
    turn = Pair{torqueOf[base], torqueOf[tip]} - Pair{besideOf[base + 1], besideOf[tip]} * turn;
    turn = lowest > turn ? lowest : turn;
    turn = highest < turn ? highest : turn;
    turnOf[base] = turn[0], turnOf[tip] = turn[1];
  }
}

/// Rotates the directions of curl, and twist with them.
void turnEdges(InsertionState& state, RodKinematics& rod, TwistSystem& turns) noexcept
{
  const std::size_t edges = state.curl_W.size() - 1;
  solveTurns(edges - 1, turns);
  inLanesInPlace(1, edges, [&](auto lane, std::size_t j) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T turn = load<T>(turns.turn, j);
    const T x = turn * turn;
    const T sine = turn * (1.0 - x * (1.0 / 6.0 - x * (1.0 / 120.0)));
    const T cosine = 1.0 - x * (0.5 - x * (1.0 / 24.0 - x * (1.0 / 720.0)));
    store(cosine * load<T>(state.curl_W, j) + sine * load<T>(rod.curlAcross_W, j), state.curl_W, j);
    store(T(load<T>(rod.twist, j) + (turn - load<T>(turns.turn, j - 1))), rod.twist, j);
  });
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
  inLanes(1, edges, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const TurningJoint<T> joint(state, rod, i);
    const T half = 0.5 * load<T>(section.restBend, i);
    const T scale = inverseSpacing * joint.inverseSum;
    store(half * (joint.d + joint.e), rod.restBend_W, i);
    store(scale * cross(joint.p, joint.t), rod.twistRate_W, i);
    if (model.isOval) store(stifferWay(model, joint, i), rod.stiffer_W, i);
  });
  if (section.holds) holdBends(model, state, section, rod);
  rod.curlAcross_W.set(1, rod.tangent_W[1].cross(state.curl_W[1]));
  const TurningJoint<double> first(state, rod, 1);
  rod.twistTorque = model.twisting[1] * inverseSpacing * rod.twist[1] -
                    energyByTurn(model, section, first, 1).last;
  if (model.isOval) rod.twistTorque += state.wallTorque[1].torque;
}

}  // namespace perilymph::mechanics

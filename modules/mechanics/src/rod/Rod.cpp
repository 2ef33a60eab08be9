// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Rod.h"

#include <algorithm>
#include <cmath>

#include "rod/Joint.h"
#include "rod/Material.h"
#include "rod/Relaxation.h"
#include "rod/Wires.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

/// Moments of a bent joint on its two links, as forces on their far ends.
template <class T>
struct JointForces {
  Triple<T> onNext_W;  ///< Subtracted from the node after.
  Triple<T> onLast_W;  ///< Subtracted from the node before.
};

/// The exact gradient of the bending energy, whose derivative by the bend is `stress`: the
/// derivatives of w by the tangents t and p are c (2 - w p^T) and -c (2 + w t^T).
template <class T>
PERILYMPH_IN_LANES JointForces<T> forcesOf(const Joint<T>& joint, const T& inverseNext,
                                           const T& inverseLast, const Triple<T>& bend_W,
                                           const Triple<T>& stress) noexcept
{
  const Triple<T>& t = joint.next;
  const Triple<T>& p = joint.last;
  const T a = 2.0 * joint.c * inverseNext;
  const T b = 2.0 * joint.c * inverseLast;
  const T half = 0.5 * dot(bend_W, stress);
  const T byNext = dot(t, stress) - half * joint.cosine;
  const T byLast = dot(p, stress) + half * joint.cosine;
  return {a * (stress - byNext * t - half * p), b * (stress - byLast * p + half * t)};
}

/// EI at a node whose segment is partly covered by the stylet: a part with and a part without it in
/// series.
double bendingOf(double carrier, double stylet, double covered) noexcept
{
  const double both = carrier + stylet;
  if (covered == 0.0) return carrier;
  if (covered == 1.0) return both;
  return carrier * both / (both - covered * stylet);
}

}  // namespace

void setStiffness(const InsertionModel& model, double styletWithdrawal, double released,
                  SectionStiffness& section) noexcept
{
  if (section.styletWithdrawal == styletWithdrawal && section.released == released) return;
  section.styletWithdrawal = styletWithdrawal;
  section.released = released;
  section.branches = 0;
  for (std::size_t k = 0; k < model.wires.size(); ++k)
    if (!model.wires[k].stiffness.empty()) section.branch[section.branches++] = k;
  if (model.styletMoment > 0.0) section.branch[section.branches++] = yieldingBranches - 1;
  section.holds = section.branches > 0 || model.parts.relaxation.bends();
  const double h = model.spacing;
  const double styletTip = model.styletFromTip + styletWithdrawal;
  for (std::size_t i = 0; i < section.bending.size(); ++i) {
    double covered = 0.0;
    if (model.styletBending > 0.0)
      covered = std::clamp((model.fromTip[i] - styletTip) / h + 0.5, 0.0, 1.0);
    const double bending = bendingOf(model.bendingCarrier[i], model.styletBending, covered);
    double excess = model.bendingExcess[i];
    if (excess > 0.0 && covered > 0.0 && covered < 1.0)
      excess = bendingOf(model.bendingCarrier[i] + excess, model.styletBending, covered) - bending;
    const double restBend =
        released * h * model.restCurvature[i] * (1.0 - covered * (1.0 - model.styletResidual));
    // what a step makes of a relaxing stiffness is constant in it
    double relaxing = model.bendingCarrier[i];
    for (std::size_t k = 0; k < model.wires.size() && !model.wires[k].stiffness.empty(); ++k) {
      section.yielding[k].stiffness[i] = model.wires[k].stiffness[i];
      section.yielding[k].moment[i] = model.wires[k].moment[i];
      relaxing -= h * model.wires[k].stiffness[i];
    }
    if (model.styletMoment > 0.0) {
      YieldingBranch& stylet = section.yielding.back();
      stylet.stiffness[i] = (bending - model.bendingCarrier[i]) / h;
      stylet.moment[i] = std::max(covered * model.styletMoment, 1e-12);
    }
    for (std::size_t b = 0; b < section.branches; ++b) {
      const std::size_t k = section.branch[b];
      const double largest =
          section.yielding[k].moment[i] / std::max(section.yielding[k].stiffness[i], 1e-30);
      section.elasticSquare[k][i] = largest * largest;
    }
    section.relaxing[i] = std::clamp(relaxing / bending, 0.0, 1.0);
    const double kept = relaxedStiffness(model, section.relaxing[i]);
    section.bending[i] = kept * bending / h;
    section.bendingExcess[i] = kept * excess / h;
    section.twisting[i] = model.twisting[i] / h;
    section.restBend[i] = restBend;
    section.restMoment[i] = kept * restBend * bending / h;
  }
  // one edge less than nodes
  for (std::size_t j = 0; j < model.stretching.size(); ++j)
    section.stretching[j] = model.stretching[j] / h;
}

void setRestShape(const InsertionModel& model, const Vector3d& curl_W,
                  const SectionStiffness& section, RodKinematics& rod) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  rod.lengthBefore = rod.length;
  inLanes(1, n - 1, [&rod](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Joint<T> joint(rod, i);
    store(joint.bend_W(), rod.bendBefore_W, i);
    store(joint.c, rod.inverseSum, i);
  });
  // a twisting array has its own material directions
  if (model.twists) return;
  Vector3d d = curl_W;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector3d p = rod.tangent_W[i - 1], t = rod.tangent_W[i];
    // the smallest rotation from p to t
    const Vector3d next = d - (d.dot(t) * rod.inverseSum[i]) * (p + t);
    rod.restBend_W.set(i, (0.5 * section.restBend[i]) * (d + next));
    d = next;
  }
}

void setEdges(const std::vector<Vector3d>& position_W, RodKinematics& rod) noexcept
{
  inLanes(0, position_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> along = load<T>(position_W, i + 1) - load<T>(position_W, i);
    const T length = root(along.x * along.x + along.y * along.y + along.z * along.z);
    const T inverse = 1.0 / length;
    store(length, rod.length, i);
    store(inverse, rod.inverseLength, i);
    store(inverse * along, rod.tangent_W, i);
  });
}

void setRodForces(const InsertionModel& model, const std::vector<Vector3d>& position_W,
                  const SectionStiffness& section, RodKinematics& rod,
                  std::vector<Vector3d>& force_W) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double h = model.spacing;
  const double damping = dampingTime / model.timeStep;
  setEdges(position_W, rod);

  // the first edge is in the tweezers: it neither stretches nor bends
  inLanes(1, n - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Joint<T> joint(rod, i);
    const T length = load<T>(rod.length, i);
    const T tension = load<T>(section.stretching, i) *
                      ((length - h) + damping * (length - load<T>(rod.lengthBefore, i)));
    store(tension, rod.tension, i);

    const Triple<T> w = joint.bend_W();
    const Triple<T> bent = w - load<T>(rod.restBend_W, i);
    const Triple<T> moved = w - load<T>(rod.bendBefore_W, i);
    const T stiffness = load<T>(section.bending, i);
    Triple<T> stress = stiffness * (bent + (T{} + damping) * moved);
    if (model.isOval) {
      const Triple<T> way = load<T>(rod.stiffer_W, i);
      T along = dot(way, bent) + damping * dot(way, moved);
      // the excess is the silicone's, which does not yield
      if (section.branches > 0) along = along + dot(way, load<T>(rod.set_W, i));
      const T moment = load<T>(section.bendingExcess, i) * along;
      stress = oneOf(load<T>(model.bendingExcess, i) > 0.0, stress + moment * way, stress);
    }
    yieldStress(section, rod, i, bent, stress);
    JointForces<T> bending = forcesOf(joint, load<T>(rod.inverseLength, i),
                                      load<T>(rod.inverseLength, i - 1), w, stress);
    if (model.twists) {
      const Triple<T> b = load<T>(rod.twistRate_W, i);
      const T twist =
          load<T>(rod.twist, i) + dot(b, load<T>(position_W, i + 1) - load<T>(position_W, i - 1));
      const T moment = load<T>(section.twisting, i) * twist;
      bending.onNext_W = bending.onNext_W + moment * b;
      bending.onLast_W = bending.onLast_W - moment * b;
    }
    const Triple<T> onNext = tension * joint.next + bending.onNext_W;
    store(onNext, rod.onNext_W, i);
    store(onNext + bending.onLast_W, rod.onNode_W, i);
    store(bending.onLast_W, rod.onLast_W, i);
  });

  inLanes(1, n - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> before = Triple<T>{} - load<T>(rod.onNext_W, i - 1);
    store(before + load<T>(rod.onNode_W, i) - load<T>(rod.onLast_W, i + 1), force_W, i);
  });
  force_W.front() = -rod.onLast_W[1];
  force_W.back() = -rod.onNext_W[n - 2];
}

}  // namespace perilymph::mechanics

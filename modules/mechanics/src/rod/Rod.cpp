// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Rod.h"

#include <algorithm>
#include <cmath>

#include "rod/Material.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

/// Two successive links and the discrete curvature between them.
struct Joint {
  const RodEdge& last;
  const RodEdge& next;
  double cosine;  ///< Cosine of the angle between them.
  double c;       ///< 1 / (1 + cosine)

  Joint(const RodEdge& before, const RodEdge& after) noexcept
      : last(before), next(after), cosine(before.tangent_W.dot(after.tangent_W))
  {
    c = 1.0 / std::max(1.0 + cosine, 1e-3);
  }

  /// Discrete curvature w = 2 (t - p) / (1 + t . p), a vector in the plane of both tangents that
  /// points to the inside of the bend. For small angles its length is the angle between them.
  Vector3d bend_W() const noexcept { return (2.0 * c) * (next.tangent_W - last.tangent_W); }
};

/// Tensile force of an edge, positive if it is longer than at rest [N].
double tensionOf(double stiffness, double rest, double length, double before,
                 double damping) noexcept
{
  return stiffness * ((length - rest) + damping * (length - before));
}

/// Moments of a bent joint on its two links, as forces on their far ends.
struct JointForces {
  Vector3d onNext_W;  ///< Subtracted from the node after.
  Vector3d onLast_W;  ///< Subtracted from the node before.
};

/// The exact gradient of the bending energy, whose derivative by the bend is `stress`: the
/// derivatives of w by the tangents t and p are c (2 - w p^T) and -c (2 + w t^T).
JointForces forcesOf(const Joint& joint, const Vector3d& bend_W, const Vector3d& stress) noexcept
{
  const Vector3d& t = joint.next.tangent_W;
  const Vector3d& p = joint.last.tangent_W;
  const double a = 2.0 * joint.c * joint.next.inverseLength;
  const double b = 2.0 * joint.c * joint.last.inverseLength;
  const double half = 0.5 * bend_W.dot(stress);
  return {a * (stress - t * (t.dot(stress) - half * joint.cosine) - half * p),
          b * (stress - p * (p.dot(stress) + half * joint.cosine) + half * t)};
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

/// scale (1 - t t^T): the projection perpendicular to t, scaled.
SymmetricBlock<double> across(const Vector3d& t, double scale) noexcept
{
  const double x = scale * t[0], y = scale * t[1], z = scale * t[2];
  return {scale - x * t[0], -x * t[1], -x * t[2], scale - y * t[1], -y * t[2], scale - z * t[2]};
}

/// scale (1 - t t^T) (1 - p p^T)
Block<double> acrossBoth(const Vector3d& t, const Vector3d& p, double cosine, double scale) noexcept
{
  const Vector3d u = scale * (cosine * p - t);
  const Vector3d v = scale * p;
  return {scale + t[0] * u[0] - v[0] * p[0], t[0] * u[1] - v[0] * p[1],
          t[0] * u[2] - v[0] * p[2],         t[1] * u[0] - v[1] * p[0],
          scale + t[1] * u[1] - v[1] * p[1], t[1] * u[2] - v[1] * p[2],
          t[2] * u[0] - v[2] * p[0],         t[2] * u[1] - v[2] * p[1],
          scale + t[2] * u[2] - v[2] * p[2]};
}

/// Derivative of an edge's force by the position of one of its ends: along it from the material,
/// across it from the tension.
SymmetricBlock<double> stiffnessOf(const RodEdge& edge, double along, double sideways) noexcept
{
  SymmetricBlock<double> block = across(edge.tangent_W, sideways - along);
  block.xx += along, block.yy += along, block.zz += along;
  return block;
}

Block<double> asBlock(const SymmetricBlock<double>& s) noexcept
{
  return {s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz};
}

/// a + a^T
SymmetricBlock<double> withMirror(const Block<double>& a) noexcept
{
  return {2.0 * a.xx, a.xy + a.yx, a.xz + a.zx, 2.0 * a.yy, a.yz + a.zy, 2.0 * a.zz};
}

/// Adds the stretching stiffness of the edge between the nodes i and i + 1.
void addStretching(const InsertionModel& model, std::size_t i, double damping,
                   Compression compression, const RodKinematics& rod, BandMatrix& matrix) noexcept
{
  const RodEdge& edge = rod.edge[i];
  const double tension =
      compression == Compression::included ? edge.tension : std::max(edge.tension, 0.0);
  const double along = model.stretching[i] / model.spacing * (1.0 + damping);
  const SymmetricBlock<double> block = stiffnessOf(edge, along, tension * edge.inverseLength);
  const std::size_t a = blockOf(i);
  matrix.diagonal[a] += block;
  matrix.diagonal[a + 1] += block;
  matrix.beside[a + 1] -= asBlock(block);
}

/// Adds the bending stiffness at node i, to first order in the angle between its links: w changes
/// by a P_t dx_next at the far end of one link and by b P_p dx_last at that of the other, where P_t
/// is the projection perpendicular to t.
void addBending(const InsertionModel& model, std::size_t i, double damping,
                const SectionStiffness& section, const RodKinematics& rod,
                BandMatrix& matrix) noexcept
{
  const Joint joint(rod.edge[i - 1], rod.edge[i]);
  const double k = section.bending[i] / model.spacing * (1.0 + damping);
  const double a = 2.0 * joint.c * joint.next.inverseLength;
  const double b = 2.0 * joint.c * joint.last.inverseLength;
  const SymmetricBlock<double> nextNext = across(joint.next.tangent_W, k * a * a);
  const SymmetricBlock<double> lastLast = across(joint.last.tangent_W, k * b * b);
  const Block<double> nextLast =
      acrossBoth(joint.next.tangent_W, joint.last.tangent_W, joint.cosine, k * a * b);

  // the node itself moves relative to both far ends
  SymmetricBlock<double> hereHere = withMirror(nextLast);
  hereHere += nextNext;
  hereHere += lastLast;
  Block<double> nextHere = asBlock(nextNext);
  nextHere += nextLast;
  Block<double> hereLast = asBlock(lastLast);
  hereLast += nextLast;

  const std::size_t next = blockOf(i + 1), here = blockOf(i), last = blockOf(i - 1);
  matrix.diagonal[next] += nextNext;
  matrix.diagonal[here] += hereHere;
  matrix.diagonal[last] += lastLast;
  matrix.beside[next] -= nextHere;
  if (here == last) {
    // both belong to the base: their interaction is internal
    matrix.diagonal[here] -= withMirror(hereLast);
    matrix.beside[next] += nextLast;
  } else {
    matrix.beside[here] -= hereLast;
    matrix.beyond[next] += nextLast;
  }
}

}  // namespace

void setStiffness(const InsertionModel& model, double styletWithdrawal, double released,
                  SectionStiffness& section) noexcept
{
  const double styletTip = model.styletFromTip + styletWithdrawal;
  for (std::size_t i = 0; i < section.bending.size(); ++i) {
    double covered = 0.0;
    if (model.styletBending > 0.0)
      covered = std::clamp((model.fromTip[i] - styletTip) / model.spacing + 0.5, 0.0, 1.0);
    section.bending[i] = bendingOf(model.bendingCarrier[i], model.styletBending, covered);
    section.bendingExcess[i] = model.bendingExcess[i];
    if (model.bendingExcess[i] > 0.0 && covered > 0.0 && covered < 1.0)
      section.bendingExcess[i] = bendingOf(model.bendingCarrier[i] + model.bendingExcess[i],
                                           model.styletBending, covered) -
                                 section.bending[i];
    section.restBend[i] = released * model.spacing * model.restCurvature[i] *
                          (1.0 - covered * (1.0 - model.styletResidual));
  }
}

void setRestShape(const InsertionModel& model, const std::vector<Vector3d>& position_W,
                  const Vector3d& curl_W, const SectionStiffness& section,
                  RodKinematics& rod) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  setEdges(position_W, rod);
  Vector3d d = curl_W;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    rod.lengthBefore[i] = rod.edge[i].length;
    if (i == 0) continue;
    const Joint joint(rod.edge[i - 1], rod.edge[i]);
    const Vector3d& p = joint.last.tangent_W;
    const Vector3d& t = joint.next.tangent_W;
    rod.bendBefore_W[i] = joint.bend_W();
    rod.inverseSum[i] = joint.c;
    // a twisting array has its own material directions
    if (model.twists) continue;
    // the smallest rotation from p to t
    const Vector3d next = d - (d.dot(t) * joint.c) * (p + t);
    rod.restBend_W[i] = (0.5 * section.restBend[i]) * (d + next);
    d = next;
  }
}

void setEdges(const std::vector<Vector3d>& position_W, RodKinematics& rod) noexcept
{
  for (std::size_t i = 0; i + 1 < position_W.size(); ++i) {
    const Vector3d along = position_W[i + 1] - position_W[i];
    RodEdge& edge = rod.edge[i];
    edge.length = std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    edge.inverseLength = 1.0 / edge.length;
    edge.tangent_W = edge.inverseLength * along;
  }
}

void addRodForces(const InsertionModel& model, const std::vector<Vector3d>& position_W,
                  const SectionStiffness& section, RodKinematics& rod,
                  std::vector<Vector3d>& force_W) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double h = model.spacing;
  const double damping = dampingTime / model.timeStep;
  setEdges(position_W, rod);

  // the first edge is in the tweezers: it neither stretches nor bends
  for (std::size_t i = 1; i + 1 < n; ++i) {
    RodEdge& edge = rod.edge[i];
    edge.tension = tensionOf(model.stretching[i] / h, h, edge.length, rod.lengthBefore[i], damping);
    const Vector3d pull_W = edge.tension * edge.tangent_W;

    const Joint joint(rod.edge[i - 1], edge);
    const Vector3d w = joint.bend_W();
    Vector3d stress =
        (section.bending[i] / h) * ((w - rod.restBend_W[i]) + damping * (w - rod.bendBefore_W[i]));
    if (model.bendingExcess[i] > 0.0) stress += ovalStress(model, section, rod, i, w);
    JointForces bending = forcesOf(joint, w, stress);
    if (model.twists) {
      const Vector3d& b = rod.twistRate_W[i];
      const double twist = rod.twist[i] + b.dot(position_W[i + 1] - position_W[i - 1]);
      const Vector3d shapeOperator_W = (model.twisting[i] / h * twist) * b;
      bending.onNext_W += shapeOperator_W;
      bending.onLast_W -= shapeOperator_W;
    }

    force_W[i - 1] -= bending.onLast_W;
    force_W[i] += pull_W + bending.onNext_W + bending.onLast_W;
    force_W[i + 1] -= pull_W + bending.onNext_W;
  }
}

void addRodStiffness(const InsertionModel& model, Compression compression,
                     const SectionStiffness& section, const RodKinematics& rod,
                     BandMatrix& matrix) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double damping = dampingTime / model.timeStep;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    addStretching(model, i, damping, compression, rod, matrix);
    addBending(model, i, damping, section, rod, matrix);
  }
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "rod/RodStiffness.h"

#include <limits>

#include "rod/Joint.h"
#include "rod/Rod.h"
#include "rod/Wires.h"

namespace perilymph::mechanics {
namespace {

/// scale (1 - t t^T): the projection perpendicular to t, scaled.
template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> across(const Triple<T>& t, const T& scale) noexcept
{
  const T x = scale * t.x, y = scale * t.y, z = scale * t.z;
  return {scale - x * t.x, -x * t.y, -x * t.z, scale - y * t.y, -y * t.z, scale - z * t.z};
}

/// scale (1 - t t^T) (1 - p p^T)
template <class T>
PERILYMPH_IN_LANES Block<T> acrossBoth(const Triple<T>& t, const Triple<T>& p, const T& cosine,
                                       const T& scale) noexcept
{
  const Triple<T> u = scale * (cosine * p - t);
  const Triple<T> v = scale * p;
  return {
      scale + t.x * u.x - v.x * p.x, t.x * u.y - v.x * p.y,         t.x * u.z - v.x * p.z,
      t.y * u.x - v.y * p.x,         scale + t.y * u.y - v.y * p.y, t.y * u.z - v.y * p.z,
      t.z * u.x - v.z * p.x,         t.z * u.y - v.z * p.y,         scale + t.z * u.z - v.z * p.z};
}

template <class T>
PERILYMPH_IN_LANES Block<T> asBlock(const SymmetricBlock<T>& s) noexcept
{
  return {s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz};
}

/// a + a^T
template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> withMirror(const Block<T>& a) noexcept
{
  return {2.0 * a.xx, a.xy + a.yx, a.xz + a.zx, 2.0 * a.yy, a.yz + a.zy, 2.0 * a.zz};
}

/// a b^T
template <class T>
PERILYMPH_IN_LANES Block<T> outer(const Triple<T>& a, const Triple<T>& b) noexcept
{
  return {a.x * b.x, a.x * b.y, a.x * b.z, a.y * b.x, a.y * b.y,
          a.y * b.z, a.z * b.x, a.z * b.y, a.z * b.z};
}

/// The symmetric part of a.
template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> symmetricPart(const Block<T>& a) noexcept
{
  return {a.xx, 0.5 * (a.xy + a.yx), 0.5 * (a.xz + a.zx), a.yy, 0.5 * (a.yz + a.zy), a.zz};
}

/// The stiffness of the edge after a node, or of the edges after four: along it from the material,
/// across it from the tension.
template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> stretchingAt(const RodKinematics& rod,
                                                  const JointStiffness& joints,
                                                  std::size_t i) noexcept
{
  const T along = load<T>(joints.along, i);
  SymmetricBlock<T> block = across(load<T>(rod.tangent_W, i), load<T>(joints.sideways, i));
  block.xx += along, block.yy += along, block.zz += along;
  return block;
}

/// What the bend of the joint at a node couples, by the motion of the nodes before and after it.
template <class T>
struct BendingBlocks {
  SymmetricBlock<T> nextNext, lastLast;
  Block<T> nextLast;

  PERILYMPH_IN_LANES BendingBlocks(const RodKinematics& rod, const JointStiffness& joints,
                                   std::size_t i) noexcept
  {
    const Triple<T> last = load<T>(rod.tangent_W, i - 1), next = load<T>(rod.tangent_W, i);
    nextNext = across(next, load<T>(joints.byNext, i));
    lastLast = across(last, load<T>(joints.byLast, i));
    nextLast = acrossBoth(next, last, load<T>(joints.cosine, i), load<T>(joints.byBoth, i));
  }

  // the node itself moves relative to both far ends
  PERILYMPH_IN_LANES SymmetricBlock<T> hereHere() const noexcept
  {
    SymmetricBlock<T> block = withMirror(nextLast);
    block += nextNext;
    block += lastLast;
    return block;
  }
  PERILYMPH_IN_LANES Block<T> nextHere() const noexcept
  {
    Block<T> block = asBlock(nextNext);
    block += nextLast;
    return block;
  }
  PERILYMPH_IN_LANES Block<T> hereLast() const noexcept
  {
    Block<T> block = asBlock(lastLast);
    block += nextLast;
    return block;
  }
};

/// k b b^T for the twist of the joint at a node, with the gradient b by the motion of the node after it
/// relative to the node before it.
template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> twistAt(const RodKinematics& rod, const JointStiffness& joints,
                                             std::size_t i) noexcept
{
  const Triple<T> b = load<T>(rod.twistRate_W, i);
  const Triple<T> l = load<T>(joints.twisting, i) * b;
  return {l.x * b.x, l.x * b.y, l.x * b.z, l.y * b.y, l.y * b.z, l.z * b.z};
}

/// k g g^T for the excess of an oval section, with the gradients g of the bend along its stiffer way by
/// the nodes before, at and after a joint.
template <class T>
struct ExcessBlocks {
  Triple<T> last, here, next;
  T stiffness;

  PERILYMPH_IN_LANES ExcessBlocks(const JointStiffness& joints, std::size_t i) noexcept
      : last(load<T>(joints.excessByLast_W, i)),
        next(load<T>(joints.excessByNext_W, i)),
        stiffness(load<T>(joints.excess, i))
  {
    here = Triple<T>{-last.x, -last.y, -last.z} - next;
  }

  PERILYMPH_IN_LANES Block<T> of(const Triple<T>& a, const Triple<T>& b) const noexcept
  {
    return outer(stiffness * a, b);
  }
};

/// Sets what the blocks are computed from, for each edge and joint.
void setJoints(const InsertionModel& model, Compression compression,
               const SectionStiffness& section, const RodKinematics& rod,
               JointStiffness& joints) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double damping = dampingTime / model.timeStep;
  const double least =
      compression == Compression::included ? -std::numeric_limits<double>::infinity() : 0.0;
  inLanes(1, n - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T along = load<T>(section.stretching, i) * (1.0 + damping);
    const T tension = larger(load<T>(rod.tension, i), least);
    store(along, joints.along, i);
    store(T(tension * load<T>(rod.inverseLength, i) - along), joints.sideways, i);
    store(T(load<T>(section.bending, i) * (1.0 + damping)), joints.bending, i);
  });
  if (section.branches > 0)
    for (std::size_t i = 1; i + 1 < n; ++i) joints.bending[i] -= lostByYielding(section, rod, i);
  inLanes(1, n - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Joint<T> joint(rod, i);
    const T a = 2.0 * joint.c * load<T>(rod.inverseLength, i);
    const T b = 2.0 * joint.c * load<T>(rod.inverseLength, i - 1);
    const T stiffness = load<T>(joints.bending, i);
    store(T(stiffness * a * a), joints.byNext, i);
    store(T(stiffness * b * b), joints.byLast, i);
    store(T(stiffness * a * b), joints.byBoth, i);
    store(joint.cosine, joints.cosine, i);
    if (model.twists) store(load<T>(section.twisting, i), joints.twisting, i);
    if (!model.isOval) return;
    const Triple<T> way = load<T>(rod.stiffer_W, i);
    const T c = 2.0 / larger(1.0 + joint.cosine, 1e-3);
    store(c * load<T>(rod.inverseLength, i) * (way - dot(way, joint.next) * joint.next),
          joints.excessByNext_W, i);
    store(c * load<T>(rod.inverseLength, i - 1) * (way - dot(way, joint.last) * joint.last),
          joints.excessByLast_W, i);
    store(T(oneOf(load<T>(model.bendingExcess, i) > 0.0,
                  T(load<T>(section.bendingExcess, i) * (1.0 + damping)), T{})),
          joints.excess, i);
  });
}

/// Sets the row of a node, or of four: what it shares with the two nodes before.
template <class T>
PERILYMPH_IN_LANES void setRow(const InsertionModel& model, const RodKinematics& rod,
                               const JointStiffness& joints, std::size_t i,
                               BandMatrix& matrix) noexcept
{
  const SymmetricBlock<T> stretching = stretchingAt<T>(rod, joints, i - 1);
  const BendingBlocks<T> before(rod, joints, i - 1), here(rod, joints, i);
  const SymmetricBlock<T> after = across(load<T>(rod.tangent_W, i), load<T>(joints.byLast, i + 1));
  SymmetricBlock<T> diagonal = stretching;
  diagonal += before.nextNext;
  diagonal += stretchingAt<T>(rod, joints, i);
  diagonal += here.hereHere();
  diagonal += after;
  Block<T> beside{};
  beside -= asBlock(stretching);
  beside -= before.nextHere();
  beside -= here.hereLast();
  Block<T> beyond = before.nextLast;
  if (model.twists) {
    const SymmetricBlock<T> twist = twistAt<T>(rod, joints, i - 1);
    diagonal += twist;
    beyond -= asBlock(twist);
  }
  if (model.isOval) {
    const ExcessBlocks<T> last(joints, i - 1), own(joints, i);
    diagonal += symmetricPart(last.of(last.next, last.next));
    diagonal += symmetricPart(own.of(own.here, own.here));
    beside += last.of(last.next, last.here);
    beside += own.of(own.here, own.last);
    beyond += last.of(last.next, last.last);
  }
  if (model.twists) diagonal += twistAt<T>(rod, joints, i + 1);
  if (model.isOval) {
    const ExcessBlocks<T> next(joints, i + 1);
    diagonal += symmetricPart(next.of(next.last, next.last));
  }
  store(diagonal, matrix.diagonal, i - 1);
  store(beside, matrix.beside, i - 1);
  store(beyond, matrix.beyond, i - 1);
}

/// Sets the row of the base, whose two nodes move together, and what the node after it shares with it.
void setBaseRow(const InsertionModel& model, const RodKinematics& rod, const JointStiffness& joints,
                BandMatrix& matrix) noexcept
{
  const SymmetricBlock<double> stretching = stretchingAt<double>(rod, joints, 1);
  const BendingBlocks<double> first(rod, joints, 1), second(rod, joints, 2);
  SymmetricBlock<double> diagonal = stretching;
  diagonal += first.hereHere();
  diagonal += first.lastLast;
  diagonal -= withMirror(first.hereLast());  // their interaction is internal
  diagonal += second.lastLast;
  Block<double> beside{};
  beside -= asBlock(stretching);
  beside -= first.nextHere();
  beside += first.nextLast;
  beside -= second.hereLast();
  if (model.twists) {
    const SymmetricBlock<double> twist = twistAt<double>(rod, joints, 1);
    diagonal += twist;
    beside -= asBlock(twist);
  }
  const ExcessBlocks<double> one(joints, 1), two(joints, 2);
  if (model.isOval) {
    const SymmetricBlock<double> coupling = symmetricPart(one.of(one.here, one.last));
    diagonal += symmetricPart(one.of(one.last, one.last));
    diagonal += coupling;
    diagonal += coupling;
    diagonal += symmetricPart(one.of(one.here, one.here));
    beside += one.of(one.next, one.last);
    beside += one.of(one.next, one.here);
    beside += two.of(two.here, two.last);
  }
  if (model.twists) diagonal += twistAt<double>(rod, joints, 2);
  if (model.isOval) diagonal += symmetricPart(two.of(two.last, two.last));
  matrix.diagonal.set(0, diagonal);
  matrix.beside.set(0, {});
  matrix.beside.set(1, beside);
  matrix.beyond.set(0, {});
  matrix.beyond.set(1, {});
}

}  // namespace

void setRodStiffness(const InsertionModel& model, Compression compression,
                     const SectionStiffness& section, const RodKinematics& rod,
                     JointStiffness& joints, BandMatrix& matrix) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  setJoints(model, compression, section, rod, joints);
  inLanes(2, n, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    setRow<decltype(lane)>(model, rod, joints, i, matrix);
  });
  setBaseRow(model, rod, joints, matrix);
  matrix.firstIsHeld = false;
  if (section.branches == 0) return;
  for (std::size_t i = 1; i + 1 < n; ++i) softenYielding(section, rod, i, matrix);
}

}  // namespace perilymph::mechanics

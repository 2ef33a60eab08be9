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

/// k g g^T for a stiffness in one direction, with the gradients g of the bend by the nodes before, at and
/// after a joint.
template <class T>
struct DirectedBlocks {
  Triple<T> last, here, next;
  T stiffness;

  PERILYMPH_IN_LANES DirectedBlocks(const DirectedStiffness& directed, std::size_t i) noexcept
      : last(load<T>(directed.byLast_W, i)),
        next(load<T>(directed.byNext_W, i)),
        stiffness(load<T>(directed.stiffness, i))
  {
    here = Triple<T>{-last.x, -last.y, -last.z} - next;
  }

  PERILYMPH_IN_LANES Block<T> of(const Triple<T>& a, const Triple<T>& b) const noexcept
  {
    return outer(stiffness * a, b);
  }
  /// The part of the row of the node after the joint.
  PERILYMPH_IN_LANES void addNext(SymmetricBlock<T>& diagonal, Block<T>& beside,
                                  Block<T>& beyond) const noexcept
  {
    diagonal += symmetricPart(of(next, next));
    beside += of(next, here);
    beyond += of(next, last);
  }
  /// The part of its own row.
  PERILYMPH_IN_LANES void addHere(SymmetricBlock<T>& diagonal, Block<T>& beside) const noexcept
  {
    diagonal += symmetricPart(of(here, here));
    beside += of(here, last);
  }
  PERILYMPH_IN_LANES void addLast(SymmetricBlock<T>& diagonal) const noexcept
  {
    diagonal += symmetricPart(of(last, last));
  }
  /// The part of the base, to which the node before the first joint and its own belong.
  PERILYMPH_IN_LANES void addBase(SymmetricBlock<T>& diagonal, Block<T>& beside) const noexcept
  {
    const SymmetricBlock<T> coupling = symmetricPart(of(here, last));
    addLast(diagonal);
    diagonal += coupling;
    diagonal += coupling;
    diagonal += symmetricPart(of(here, here));
    beside += of(next, last);
    beside += of(next, here);
  }
};

/// Sets a stiffness in the direction of a unit vector, at a joint or at four.
template <class T>
PERILYMPH_IN_LANES void setDirected(const RodKinematics& rod, const Joint<T>& joint, std::size_t i,
                                    const Triple<T>& way, const T& stiffness,
                                    DirectedStiffness& directed) noexcept
{
  const T c = 2.0 / larger(1.0 + joint.cosine, 1e-3);
  const T next = c * load<T>(rod.inverseLength, i), last = c * load<T>(rod.inverseLength, i - 1);
  store(stiffness, directed.stiffness, i);
  store(next * (way - dot(way, joint.next) * joint.next), directed.byNext_W, i);
  store(last * (way - dot(way, joint.last) * joint.last), directed.byLast_W, i);
}

/// Sets what the branches that yield lack at a joint, or at four, in the direction of their bends.
///
/// @return  What they lack in every direction: of a branch, s k (1 - n n^T) is left of k.
template <class T>
PERILYMPH_IN_LANES T setYielded(const SectionStiffness& section, const RodKinematics& rod,
                                const Joint<T>& joint, std::size_t i,
                                JointStiffness& joints) noexcept
{
  T lost{};
  const Triple<T> bent = joint.bend_W() - load<T>(rod.restBend_W, i);
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const Triple<T> x = bent + load<T>(rod.wireOffset_W[k], i);
    const auto isElastic = dot(x, x) <= load<T>(section.elasticSquare[k], i);
    joints.yields[k] = joints.yields[k] || !inAll(isElastic);
    const T stiffness = load<T>(section.yielding[k].stiffness, i);
    const T s = elasticFraction(x, stiffness, load<T>(section.yielding[k].moment, i));
    lost += oneOf(isElastic, T{}, T((1.0 - s) * stiffness));
    const Triple<T> way = oneOf(isElastic, Triple<T>{}, T(1.0 / root(dot(x, x))) * x);
    setDirected(rod, joint, i, way, T(oneOf(isElastic, T{}, T(-s * stiffness))), joints.yielded[k]);
  }
  return lost;
}

/// Calls a function with the blocks of each branch that yields, at a joint or at four.
template <class T, class Function>
PERILYMPH_IN_LANES void forEachYielded(const SectionStiffness& section,
                                       const JointStiffness& joints, std::size_t i,
                                       const Function& function) noexcept
{
  for (std::size_t b = 0; b < section.branches; ++b)
    if (joints.yields[section.branch[b]])
      function(DirectedBlocks<T>(joints.yielded[section.branch[b]], i));
}

/// Sets what the blocks are computed from, for each edge and joint.
void setJoints(const InsertionModel& model, Compression compression,
               const SectionStiffness& section, const RodKinematics& rod,
               JointStiffness& joints) noexcept
{
  const double damping = dampingTime / model.timeStep;
  const double least =
      compression == Compression::included ? -std::numeric_limits<double>::infinity() : 0.0;
  joints.yields.fill(false);
  inLanes(
      1, static_cast<std::size_t>(model.nodes) - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
        using T = decltype(lane);
        const T along = load<T>(section.stretching, i) * (1.0 + damping);
        const T tension = larger(load<T>(rod.tension, i), least);
        store(along, joints.along, i);
        store(T(tension * load<T>(rod.inverseLength, i) - along), joints.sideways, i);

        const Joint<T> joint(rod, i);
        T stiffness = load<T>(section.bending, i) * (1.0 + damping);
        if (section.branches > 0) stiffness -= setYielded(section, rod, joint, i, joints);
        const T a = 2.0 * joint.c * load<T>(rod.inverseLength, i);
        const T b = 2.0 * joint.c * load<T>(rod.inverseLength, i - 1);
        store(T(stiffness * a * a), joints.byNext, i);
        store(T(stiffness * b * b), joints.byLast, i);
        store(T(stiffness * a * b), joints.byBoth, i);
        store(joint.cosine, joints.cosine, i);
        if (model.twists) store(load<T>(section.twisting, i), joints.twisting, i);
        if (!model.isOval) return;
        const T excess = load<T>(section.bendingExcess, i) * (1.0 + damping);
        setDirected(rod, joint, i, load<T>(rod.stiffer_W, i),
                    T(oneOf(load<T>(model.bendingExcess, i) > 0.0, excess, T{})), joints.excess);
      });
}

/// Sets the row of a node, or of four: what it shares with the two nodes before. Sums begin with the
/// first joint and have the order stretching, yielding, bending; then twist and excess.
template <class T>
PERILYMPH_IN_LANES void setRow(const InsertionModel& model, const SectionStiffness& section,
                               const RodKinematics& rod, const JointStiffness& joints,
                               std::size_t i, BandMatrix& matrix) noexcept
{
  using Blocks = DirectedBlocks<T>;
  const SymmetricBlock<T> stretching = stretchingAt<T>(rod, joints, i - 1);
  const BendingBlocks<T> before(rod, joints, i - 1), here(rod, joints, i);
  SymmetricBlock<T> diagonal = stretching;
  Block<T> beside{}, beyond{};
  beside -= asBlock(stretching);
  forEachYielded<T>(section, joints, i - 1, [&](const Blocks& one) PERILYMPH_KERNEL {
    one.addNext(diagonal, beside, beyond);
  });
  diagonal += before.nextNext;
  beside -= before.nextHere();
  beyond += before.nextLast;
  diagonal += stretchingAt<T>(rod, joints, i);
  forEachYielded<T>(section, joints, i,
                    [&](const Blocks& one) PERILYMPH_KERNEL { one.addHere(diagonal, beside); });
  diagonal += here.hereHere();
  beside -= here.hereLast();
  forEachYielded<T>(section, joints, i + 1,
                    [&](const Blocks& one) PERILYMPH_KERNEL { one.addLast(diagonal); });
  diagonal += across(load<T>(rod.tangent_W, i), load<T>(joints.byLast, i + 1));
  if (model.twists) {
    const SymmetricBlock<T> twist = twistAt<T>(rod, joints, i - 1);
    diagonal += twist;
    beyond -= asBlock(twist);
  }
  if (model.isOval) {
    Blocks(joints.excess, i - 1).addNext(diagonal, beside, beyond);
    Blocks(joints.excess, i).addHere(diagonal, beside);
  }
  if (model.twists) diagonal += twistAt<T>(rod, joints, i + 1);
  if (model.isOval) Blocks(joints.excess, i + 1).addLast(diagonal);
  store(diagonal, matrix.diagonal, i - 1);
  store(beside, matrix.beside, i - 1);
  store(beyond, matrix.beyond, i - 1);
}

/// Sets the row of the base, whose two nodes move together, and what the node after it shares with it.
void setBaseRow(const InsertionModel& model, const SectionStiffness& section,
                const RodKinematics& rod, const JointStiffness& joints, BandMatrix& matrix) noexcept
{
  using Blocks = DirectedBlocks<double>;
  const SymmetricBlock<double> stretching = stretchingAt<double>(rod, joints, 1);
  const BendingBlocks<double> first(rod, joints, 1), second(rod, joints, 2);
  SymmetricBlock<double> diagonal = stretching;
  Block<double> beside{};
  beside -= asBlock(stretching);
  forEachYielded<double>(section, joints, 1,
                         [&](const Blocks& one) { one.addBase(diagonal, beside); });
  diagonal += first.hereHere();
  diagonal += first.lastLast;
  diagonal -= withMirror(first.hereLast());  // their interaction is internal
  beside -= first.nextHere();
  beside += first.nextLast;
  forEachYielded<double>(section, joints, 2, [&](const Blocks& one) {
    one.addLast(diagonal);
    beside += one.of(one.here, one.last);
  });
  diagonal += second.lastLast;
  beside -= second.hereLast();
  if (model.twists) {
    const SymmetricBlock<double> twist = twistAt<double>(rod, joints, 1);
    diagonal += twist;
    beside -= asBlock(twist);
  }
  const Blocks two(joints.excess, 2);
  if (model.isOval) {
    Blocks(joints.excess, 1).addBase(diagonal, beside);
    beside += two.of(two.here, two.last);
  }
  if (model.twists) diagonal += twistAt<double>(rod, joints, 2);
  if (model.isOval) two.addLast(diagonal);
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
  setJoints(model, compression, section, rod, joints);
  inLanes(2, static_cast<std::size_t>(model.nodes), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    setRow<decltype(lane)>(model, section, rod, joints, i, matrix);
  });
  setBaseRow(model, section, rod, joints, matrix);
  matrix.firstIsHeld = false;
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Wires.h"

#include <algorithm>
#include <cmath>

#include "rod/BendingAlong.h"
#include "rod/Joint.h"
#include "rod/Relaxation.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

double lengthOf(double along, double across) noexcept
{
  return std::sqrt(along * along + across * across);
}

}  // namespace

void setPlasticBend(const InsertionState& state, SectionStiffness& section) noexcept
{
  const auto& [single, bundle, stylet] = section.yielding;
  const auto& [q, r, s] = state.plasticBend;
  inLanesInPlace(0, section.restBend.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T inverse = 1.0 / load<T>(section.bending, i);
    const T a = inverse * load<T>(single.stiffness, i), b = inverse * load<T>(bundle.stiffness, i);
    const T c = inverse * load<T>(stylet.stiffness, i);
    const T along = a * load<T>(q.along, i) + b * load<T>(r.along, i) + c * load<T>(s.along, i);
    const T across = a * load<T>(q.across, i) + b * load<T>(r.across, i) + c * load<T>(s.across, i);
    store(along, section.setAlong, i);
    store(across, section.setAcross, i);
    store(T(load<T>(section.heldAlong, i) + along), section.heldAlong, i);
    store(T(load<T>(section.heldAcross, i) + across), section.heldAcross, i);
  });
}

void moveStylet(const InsertionModel& model, double withdrawn, SectionStiffness& section,
                const RodKinematics& rod, InsertionState& state) noexcept
{
  MaterialBend& plastic = state.plasticBend.back();
  section.setAlong = plastic.along;
  section.setAcross = plastic.across;
  const double last = static_cast<double>(section.setAlong.size() - 1);
  for (std::size_t i = 1; i + 1 < section.setAlong.size(); ++i) {
    // what is at this node now was farther at the tip
    const double from = static_cast<double>(i) + withdrawn / model.spacing;
    double along = 0.0, across = 0.0;
    if (from >= 0.0 && from < last) {
      const auto j = static_cast<std::size_t>(from);
      const double part = from - static_cast<double>(j);
      along = section.setAlong[j] + part * (section.setAlong[j + 1] - section.setAlong[j]);
      across = section.setAcross[j] + part * (section.setAcross[j + 1] - section.setAcross[j]);
    }
    // the stylet takes no energy from its motion: it is bent no more than what was here before
    const NodeAxes<double> axes(rod, state.curl_W, i);
    const Triple<double> w = load<double>(rod.bendBefore_W, i);
    const double bentAlong = dot(w, axes.along) - section.restBend[i];
    const double bentAcross = dot(w, axes.across);
    const double before =
        lengthOf(bentAlong - section.setAlong[i], bentAcross - section.setAcross[i]);
    const double now = lengthOf(bentAlong - along, bentAcross - across);
    const double kept = now > before ? before / now : 1.0;
    plastic.along[i] = bentAlong - kept * (bentAlong - along);
    plastic.across[i] = bentAcross - kept * (bentAcross - across);
  }
}

void offsetWires(const InsertionState& state, const SectionStiffness& section, RodKinematics& rod,
                 bool isOval) noexcept
{
  inLanes(1, state.curl_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> m = load<T>(rod.bendAlong_W, i), n = load<T>(rod.bendAcross_W, i);
    if (isOval)
      store(load<T>(section.setAlong, i) * m + load<T>(section.setAcross, i) * n, rod.set_W, i);
    const T along = load<T>(section.heldAlong, i) - load<T>(section.restBend, i);
    const T across = load<T>(section.heldAcross, i);
    for (std::size_t b = 0; b < section.branches; ++b) {
      const std::size_t k = section.branch[b];
      const T offAlong = along - load<T>(state.plasticBend[k].along, i);
      const T offAcross = across - load<T>(state.plasticBend[k].across, i);
      store(offAlong * m + offAcross * n, rod.wireOffset_W[k], i);
    }
  });
}

void softenYielding(const SectionStiffness& section, const RodKinematics& rod, std::size_t i,
                    BandMatrix& matrix) noexcept
{
  const Triple<double> bent = Joint<double>(rod, i).bend_W() - load<double>(rod.restBend_W, i);
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const double stiffness = section.yielding[k].stiffness[i];
    const Triple<double> x = bent + load<double>(rod.wireOffset_W[k], i);
    if (dot(x, x) <= section.elasticSquare[k][i]) continue;
    const double s = elasticFraction(x, stiffness, section.yielding[k].moment[i]);
    // s k (1 - n n^T) is left of k
    addBending(i, -(1.0 - s) * stiffness, rod, matrix);
    const double inverse = 1.0 / root(dot(x, x));
    addBendingAlong(matrix, rod, i, {inverse * x.x, inverse * x.y, inverse * x.z}, -s * stiffness);
  }
}

double yieldWires(const SectionStiffness& section, RodKinematics& rod,
                  InsertionState& state) noexcept
{
  bool areElastic = true;
  inLanesInPlace(1, state.curl_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> bent = Joint<T>(rod, i).bend_W() - load<T>(rod.restBend_W, i);
    T work{};
    for (std::size_t b = 0; b < section.branches; ++b) {
      const std::size_t k = section.branch[b];
      const Triple<T> x = bent + load<T>(rod.wireOffset_W[k], i);
      if (inAll(dot(x, x) <= load<T>(section.elasticSquare[k], i))) continue;
      areElastic = false;
      MaterialBend& plastic = state.plasticBend[k];
      const T moment = load<T>(section.yielding[k].moment, i);
      const T over = 1.0 - elasticFraction(x, load<T>(section.yielding[k].stiffness, i), moment);
      store(T(load<T>(plastic.along, i) + over * dot(x, load<T>(rod.bendAlong_W, i))),
            plastic.along, i);
      store(T(load<T>(plastic.across, i) + over * dot(x, load<T>(rod.bendAcross_W, i))),
            plastic.across, i);
      work = work + moment * over * root(dot(x, x));
    }
    store(work, rod.wireSlip, i);
  });
  double work = 0.0;
  if (areElastic) return work;
  for (std::size_t i = 1; i + 1 < state.curl_W.size(); ++i) work += rod.wireSlip[i];
  return work;
}

}  // namespace perilymph::mechanics

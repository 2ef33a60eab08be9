// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Relaxation.h"

#include <array>
#include <cmath>

#include "rod/Joint.h"
#include "rod/Wires.h"

namespace perilymph::mechanics {

bool RelaxationLaw::bends() const noexcept
{
  for (const MaxwellElement& term : bending)
    if (term.fraction > 0.0) return true;
  return false;
}

double relaxedStiffness(const InsertionModel& model, double relaxing) noexcept
{
  double lost = 0.0;
  for (const RelaxingStep& term : model.relaxing)
    lost += term.fraction * term.ratio / (1.0 + term.ratio);
  return 1.0 - relaxing * lost;
}

void setHeldBend(const InsertionModel& model, const InsertionState& state,
                 SectionStiffness& section) noexcept
{
  const bool relaxes = model.parts.relaxation.bends(), yields = section.branches > 0;
  const auto& [first, second] = model.relaxing;
  const double lost = 1.0 - relaxedStiffness(model, 1.0);
  const double firstWeight = first.fraction / (1.0 + first.ratio);
  const double secondWeight = second.fraction / (1.0 + second.ratio);
  inLanes(0, section.restBend.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    T along = load<T>(section.restBend, i), across{};
    if (yields) {
      const auto [setAlong, setAcross] = setOfWires<T>(state, section, i);
      store(setAlong, section.setAlong, i);
      store(setAcross, section.setAcross, i);
      along = along + setAlong;
      across = setAcross;
    }
    if (relaxes) {
      const T relaxing = load<T>(section.relaxing, i);
      const T scale = relaxing / (1.0 - lost * relaxing);
      const auto held = [&](const std::vector<double>& one,
                            const std::vector<double>& other) PERILYMPH_KERNEL {
        return scale * (firstWeight * load<T>(one, i) + secondWeight * load<T>(other, i));
      };
      along = along + held(state.relaxedBend[0].along, state.relaxedBend[1].along);
      across = across + held(state.relaxedBend[0].across, state.relaxedBend[1].across);
    }
    store(along, section.heldAlong, i);
    store(across, section.heldAcross, i);
  });
}

void holdBends(const InsertionModel& model, const InsertionState& state,
               const SectionStiffness& section, RodKinematics& rod) noexcept
{
  inLanesInPlace(1, state.curl_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const NodeAxes<T> axes(rod, state.curl_W, i);
    const auto& [along, across] = axes;
    const T heldAlong = load<T>(section.heldAlong, i) - load<T>(section.restBend, i);
    const T heldAcross = load<T>(section.heldAcross, i);
    store(along, rod.bendAlong_W, i);
    store(across, rod.bendAcross_W, i);
    store(load<T>(rod.restBend_W, i) + heldAlong * along + heldAcross * across, rod.restBend_W, i);
    if (section.branches > 0)
      offsetWires(state, section, rod, i, along, across, heldAlong, heldAcross, model.isOval);
  });
}

double commitBends(const InsertionModel& model, const SectionStiffness& section, RodKinematics& rod,
                   InsertionState& state) noexcept
{
  const bool relaxes = model.parts.relaxation.bends(), yields = section.branches > 0;
  const std::size_t end = state.curl_W.size() - 1;
  struct Element {
    std::size_t index;
    double kept, taken;
  };
  const auto elementOf = [&](std::size_t k) {
    const double kept = 1.0 / (1.0 + model.relaxing[k].ratio);
    return Element{k, kept, model.relaxing[k].ratio * kept};
  };
  const std::array elements{elementOf(0), elementOf(1)};
  inLanesInPlace(1, end, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> m = load<T>(rod.bendAlong_W, i), n = load<T>(rod.bendAcross_W, i);
    const Triple<T> bent = Joint<T>(rod, i).bend_W() - load<T>(rod.restBend_W, i);
    if (yields) store(yieldWires(section, rod, i, bent, m, n, state), rod.wireSlip, i);
    if (!relaxes) return;
    const T along = dot(bent, m) + load<T>(section.heldAlong, i) - load<T>(section.restBend, i);
    const T across = dot(bent, n) + load<T>(section.heldAcross, i);
    for (const auto& [k, kept, taken] : elements) {
      MaterialBend& relaxed = state.relaxedBend[k];
      store(T(kept * load<T>(relaxed.along, i) + taken * along), relaxed.along, i);
      store(T(kept * load<T>(relaxed.across, i) + taken * across), relaxed.across, i);
    }
  });
  double work = 0.0;
  for (std::size_t i = 1; yields && i < end; ++i) work += rod.wireSlip[i];
  return work;
}

}  // namespace perilymph::mechanics

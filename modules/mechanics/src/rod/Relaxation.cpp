// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Relaxation.h"

#include <algorithm>
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
  section.heldAlong = section.restBend;
  std::fill(section.heldAcross.begin(), section.heldAcross.end(), 0.0);
  if (section.branches > 0) setPlasticBend(state, section);
  if (!model.parts.relaxation.bends()) return;
  const auto& [first, second] = model.relaxing;
  const double lost = 1.0 - relaxedStiffness(model, 1.0);
  const double firstWeight = first.fraction / (1.0 + first.ratio);
  const double secondWeight = second.fraction / (1.0 + second.ratio);
  inLanesInPlace(0, section.restBend.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T relaxing = load<T>(section.relaxing, i);
    const T scale = relaxing / (1.0 - lost * relaxing);
    const auto held = [&](const std::vector<double>& one,
                          const std::vector<double>& other) PERILYMPH_KERNEL {
      return scale * (firstWeight * load<T>(one, i) + secondWeight * load<T>(other, i));
    };
    store(T(load<T>(section.heldAlong, i) +
            held(state.relaxedBend[0].along, state.relaxedBend[1].along)),
          section.heldAlong, i);
    store(T(load<T>(section.heldAcross, i) +
            held(state.relaxedBend[0].across, state.relaxedBend[1].across)),
          section.heldAcross, i);
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
  });
  if (section.branches > 0) offsetWires(state, section, rod, model.isOval);
}

void relaxBends(const InsertionModel& model, const SectionStiffness& section,
                const RodKinematics& rod, InsertionState& state) noexcept
{
  inLanesInPlace(1, state.curl_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> bent = Joint<T>(rod, i).bend_W() - load<T>(rod.restBend_W, i);
    const T along = dot(bent, load<T>(rod.bendAlong_W, i)) + load<T>(section.heldAlong, i) -
                    load<T>(section.restBend, i);
    const T across = dot(bent, load<T>(rod.bendAcross_W, i)) + load<T>(section.heldAcross, i);
    for (std::size_t k = 0; k < model.relaxing.size(); ++k) {
      const double ratio = model.relaxing[k].ratio;
      const double kept = 1.0 / (1.0 + ratio), taken = ratio * kept;
      MaterialBend& relaxed = state.relaxedBend[k];
      store(T(kept * load<T>(relaxed.along, i) + taken * along), relaxed.along, i);
      store(T(kept * load<T>(relaxed.across, i) + taken * across), relaxed.across, i);
    }
  });
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Wires.h"

#include <cmath>

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

}  // namespace perilymph::mechanics

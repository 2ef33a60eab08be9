// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Wires.h"

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

namespace {

/// Calls a function with each branch that yields at node i: its stiffness, the fraction of its elastic
/// moment, and the bend.
template <class Function>
void forEachYielding(const SectionStiffness& section, const RodKinematics& rod, std::size_t i,
                     const Function& function) noexcept
{
  const Triple<double> bent = Joint<double>(rod, i).bend_W() - load<double>(rod.restBend_W, i);
  for (std::size_t b = 0; b < section.branches; ++b) {
    const std::size_t k = section.branch[b];
    const double stiffness = section.yielding[k].stiffness[i];
    const Triple<double> x = bent + load<double>(rod.wireOffset_W[k], i);
    if (dot(x, x) <= section.elasticSquare[k][i]) continue;
    function(stiffness, elasticFraction(x, stiffness, section.yielding[k].moment[i]), x);
  }
}

}  // namespace

double lostByYielding(const SectionStiffness& section, const RodKinematics& rod,
                      std::size_t i) noexcept
{
  double lost = 0.0;
  forEachYielding(section, rod, i, [&](double stiffness, double s, const Triple<double>&) {
    lost += (1.0 - s) * stiffness;
  });
  return lost;
}

void softenYielding(const SectionStiffness& section, const RodKinematics& rod, std::size_t i,
                    BandMatrix& matrix) noexcept
{
  forEachYielding(section, rod, i, [&](double stiffness, double s, const Triple<double>& x) {
    const double inverse = 1.0 / root(dot(x, x));
    addBendingAlong(matrix, rod, i, {inverse * x.x, inverse * x.y, inverse * x.z}, -s * stiffness);
  });
}

}  // namespace perilymph::mechanics

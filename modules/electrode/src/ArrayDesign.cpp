// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/ArrayDesign.h"

#include <algorithm>
#include <cmath>

namespace perilymph::electrode {
namespace {

Length thicknessAt(const ArrayDesign& array, Length place)
{
  return array.thickness.fromTip.empty() ? array.diameter.at(place) : array.thickness.at(place);
}

}  // namespace

Length Stylet::wireDiameter() const
{
  if (diameter.si() > 0.0) return diameter;
  constexpr double platinum = 168e9;  // [Pa], as the wires of plugins/README.md
  return Length::fromSi(std::sqrt(std::sqrt(64.0 * bending.si() / (platinum * pi))));
}

double Stylet::yieldMoment() const
{
  const double d = wireDiameter().si();
  return yieldStress.value.si() * d * d * d / 6.0;
}

Wires::Branch Wires::singleAt(Length place) const
{
  const double d = diameter.si(), n = number.at(place);
  return {BendingStiffness::fromSi(n * modulus.si() * pi * d * d * d * d / 64.0),
          n * yieldStress.value.si() * d * d * d / 6.0};
}

Wires::Branch Wires::bundleAt(Length place) const
{
  const double d = diameter.si(), n = number.at(place), packed = n / 0.9;
  return {BendingStiffness::fromSi(coupling * n * n * modulus.si() * pi * d * d * d * d / 64.0),
          packed * std::sqrt(packed) * yieldStress.value.si() * d * d * d / 6.0};
}

Length ArrayDesign::tipRadius() const
{
  if (tip.radius > millimeters(0)) return tip.radius;
  const Length end = millimeters(0);
  return 0.5 * std::min(diameter.at(end), thicknessAt(*this, end));
}

Section ArrayDesign::sectionAt(Length place) const
{
  const auto tapered = [&](Length full, Length fullBehind) {
    if (place >= tip.taper || tip.taper <= millimeters(0)) return full;
    const double fraction = std::max(place / tip.taper, 0.0);
    const Length start = 2.0 * tipRadius();
    return std::min(full, start + fraction * (fullBehind - start));
  };
  return {tapered(diameter.at(place), diameter.at(tip.taper)),
          tapered(thicknessAt(*this, place), thicknessAt(*this, tip.taper))};
}

bool ArrayDesign::isRound() const
{
  if (thickness.fromTip.empty()) return true;
  const auto isRoundAt = [this](Length place) { return thickness.at(place) == diameter.at(place); };
  return std::all_of(thickness.fromTip.begin(), thickness.fromTip.end(), isRoundAt) &&
         std::all_of(diameter.fromTip.begin(), diameter.fromTip.end(), isRoundAt);
}

BendingStiffness ArrayDesign::bendingAcrossAt(Length place) const
{
  return bendingAcross.fromTip.empty() ? bending.at(place) : bendingAcross.at(place);
}

BendingStiffness ArrayDesign::twistingAt(Length place) const
{
  if (twisting) return twisting->at(place);
  // Ellipse with second moments I1 and I2: J = 4 I1 I2 / (I1 + I2). Incompressible: G = E / 3.
  const double within = bending.at(place).si();
  const double across = bendingAcrossAt(place).si();
  return BendingStiffness::fromSi(4.0 / 3.0 * within * across / (within + across));
}

}  // namespace perilymph::electrode

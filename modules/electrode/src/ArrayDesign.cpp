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

/// A quantity with a knot at a place, its values as they were.
template <class Value>
AlongArray<Value> withKnot(AlongArray<Value> along, Length place)
{
  const auto next = std::lower_bound(along.fromTip.begin(), along.fromTip.end(), place);
  if (next != along.fromTip.end() && *next == place) return along;
  const Value here = along.at(place);
  along.value.insert(along.value.begin() + (next - along.fromTip.begin()), here);
  along.fromTip.insert(next, place);
  return along;
}

/// A quantity in a straight line from the tip to a value at a place, and as before behind it.
AlongArray<Length> straightTo(const AlongArray<Length>& along, Length place, Length there)
{
  AlongArray<Length> straight{{millimeters(0), place}, {along.at(millimeters(0)), there}};
  for (std::size_t i = 0; i < along.fromTip.size(); ++i) {
    if (along.fromTip[i] <= place) continue;
    straight.fromTip.push_back(along.fromTip[i]);
    straight.value.push_back(along.value[i]);
  }
  return straight;
}

}  // namespace

Length Stylet::wireDiameter() const
{
  if (diameter.si() > 0.0) return diameter;
  constexpr double platinum = 168e9;  // [Pa], as the wires of the guide, method.md
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

ArrayDesign withTaper(ArrayDesign array, double fraction)
{
  if (!array.taper) return array;
  const TaperRange& range = *array.taper;
  const ArrayDesign former = array;
  const Length place = array.contactsFromTip.back(),
               width = range.thinnest + fraction * (range.thickest - range.thinnest),
               thickness = (width / former.diameter.at(place)) * thicknessAt(former, place);
  array.diameter = straightTo(former.diameter, place, width);
  if (!former.thickness.fromTip.empty())
    array.thickness = straightTo(former.thickness, place, thickness);
  array.bending = withKnot(former.bending, place);
  if (!former.bendingAcross.fromTip.empty())
    array.bendingAcross = withKnot(former.bendingAcross, place);
  const auto silicone = [&](const ArrayDesign& of, Length at, bool isAcross) {
    const double w = of.diameter.at(at).si(), t = thicknessAt(of, at).si();
    return range.carrier.si() * pi * (isAcross ? w * w * w * t : w * t * t * t) / 64.0;
  };
  for (auto* bending : {&array.bending, &array.bendingAcross})
    for (std::size_t i = 0; i < bending->fromTip.size(); ++i) {
      const Length at = bending->fromTip[i];
      const bool isAcross = bending == &array.bendingAcross;
      bending->value[i] = bending->value[i] + newtonSquareMeters(silicone(array, at, isAcross) -
                                                                 silicone(former, at, isAcross));
    }
  return array;
}

}  // namespace perilymph::electrode

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/WirePacking.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace perilymph::electrode {

namespace {

constexpr double siliconeModulus = 2e6, wireModulus = 168e9, wireDiameter = 25e-6;
/// E_w I_w of one wire [N m^2].
constexpr double oneWire =
    wireModulus * pi * wireDiameter * wireDiameter * wireDiameter * wireDiameter / 64.0;
/// Deviation from the model beyond which an array does not follow it: numbers in files are rounded to
/// three digits (choice, high).
constexpr double allowedDeviation = 0.1;

/// E_s I of the section, which bends within the plane of curl.
double siliconeAt(const ArrayDesign& array, Length fromTip)
{
  const double within =
      (array.thickness.fromTip.empty() ? array.diameter : array.thickness).at(fromTip).si();
  return siliconeModulus * pi * array.diameter.at(fromTip).si() * within * within * within / 64.0;
}

}  // namespace

double wiresAt(const ArrayDesign& array, Length fromTip)
{
  const auto& contacts = array.contactsFromTip;
  double wires = static_cast<double>(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (fromTip < contacts[i]) {
      wires = static_cast<double>(i);
      if (i > 0) wires += (fromTip - contacts[i - 1]) / (contacts[i] - contacts[i - 1]);
      break;
    }
  return std::max(1.0, wires);
}

std::optional<double> wirePacking(const ArrayDesign& array)
{
  if (!array.wires || array.hasStylet || array.yields() || array.contactsFromTip.empty() ||
      array.diameter.fromTip.empty())
    return std::nullopt;
  double sum = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < array.bending.fromTip.size(); ++i) {
    const Length place = array.bending.fromTip[i];
    const double wires = wiresAt(array, place), packed = oneWire * wires * wires;
    sum += packed * (array.bending.value[i].si() - siliconeAt(array, place) - oneWire * wires);
    weight += packed * packed;
  }
  const double packing = sum / weight;
  for (std::size_t i = 0; i < array.bending.fromTip.size(); ++i) {
    const Length place = array.bending.fromTip[i];
    const double wires = wiresAt(array, place), given = array.bending.value[i].si();
    const double modeled = siliconeAt(array, place) + oneWire * (wires + packing * wires * wires);
    if (!(std::fabs(modeled - given) <= allowedDeviation * given)) return std::nullopt;
  }
  return packing;
}

ArrayDesign withWirePacking(ArrayDesign array, double packing)
{
  const auto present = wirePacking(array);
  if (!present) return array;
  for (auto* bending : {&array.bending, &array.bendingAcross})
    for (std::size_t i = 0; i < bending->fromTip.size(); ++i) {
      const double wires = wiresAt(array, bending->fromTip[i]);
      bending->value[i] =
          bending->value[i] + newtonSquareMeters((packing - *present) * oneWire * wires * wires);
    }
  return array;
}

}  // namespace perilymph::electrode

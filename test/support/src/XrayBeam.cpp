// SPDX-License-Identifier: BSD-3-Clause
#include "XrayBeam.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace perilymph::test {
namespace {

/// Mass attenuation at an energy.
struct Attenuation {
  double energy_keV, coefficient_cm2_g;
};
using Table = std::vector<Attenuation>;

// J. H. Hubbell and S. M. Seltzer, NIST Standard Reference Database 126, as listed in public code; confidence high.
const Table& water()
{
  static const Table table{{30, 0.3756}, {40, 0.2683},  {50, 0.2269}, {60, 0.2059},
                           {80, 0.1837}, {100, 0.1707}, {150, 0.1505}};
  return table;
}
const Table& corticalBone()
{
  static const Table table{{30, 1.331},  {40, 0.6655},  {50, 0.4242}, {60, 0.3148},
                           {80, 0.2229}, {100, 0.1855}, {150, 0.1480}};
  return table;
}
const Table& aluminum()
{
  static const Table table{{30, 1.128},  {40, 0.5685},  {50, 0.3681}, {60, 0.2778},
                           {80, 0.2018}, {100, 0.1704}, {150, 0.1378}};
  return table;
}
const Table& platinum()
{
  static const Table table{{30, 26.41},    {40, 12.45}, {50, 6.954},  {60, 4.339}, {78.39, 2.203},
                           {78.39, 9.301}, {80, 8.731}, {100, 4.993}, {150, 1.795}};
  return table;
}
const Table& iridium()
{
  static const Table table{{30, 25.46},    {40, 11.99}, {50, 6.693},  {60, 4.176}, {76.11, 2.284},
                           {76.11, 9.728}, {80, 8.585}, {100, 4.855}, {150, 1.740}};
  return table;
}

/// Linear in the logarithms; at an edge the value below it.
double at(const Table& table, double energy)
{
  std::size_t i = 1;
  while (i + 1 < table.size() && table[i].energy_keV < energy) ++i;
  const Attenuation &a = table[i - 1], &b = table[i];
  const double t = std::log(energy / a.energy_keV) / std::log(b.energy_keV / a.energy_keV);
  return a.coefficient_cm2_g * std::pow(b.coefficient_cm2_g / a.coefficient_cm2_g, t);
}

/// Attenuation of the beam behind a head: per mm of water and of bone added to it.
struct Behind {
  double water, bone;
};
Behind behindHead(const XrayBeam& beam)
{
  constexpr double head_mm = 160.0, skull_mm = 20.0;
  double sum = 0.0, byWater = 0.0, byBone = 0.0;
  for (std::size_t e = 0; e < XrayBeam::bins; ++e) {
    const double water = static_cast<double>(beam.water[e]),
                 bone = static_cast<double>(beam.bone[e]);
    const double left =
        static_cast<double>(beam.weight[e]) * std::exp(-water * head_mm - bone * skull_mm);
    sum += left;
    byWater += left * water;
    byBone += left * bone;
  }
  return {byWater / sum, byBone / sum};
}

}  // namespace

double XrayBeam::reference() const { return behindHead(*this).water; }

double XrayBeam::boneHu() const
{
  const Behind behind = behindHead(*this);
  return 1000.0 * (behind.bone / behind.water - 1.0);
}

XrayBeam tubeBeam()
{
  constexpr double tube_keV = 120.0, filter_mm = 6.0, step_keV = 0.25;
  constexpr std::array<double, XrayBeam::bins + 1> edges{32.0,  45.0, 55.0, 65.0,  76.11,
                                                         78.39, 88.0, 98.0, 108.0, tube_keV};
  // Densities [g/cm^3]: NIST's table 1 for the elements; that of bone is a unit of the phantom.
  constexpr double aluminumDensity = 2.70, platinumDensity = 21.45, wireDensity = 21.55,
                   boneDensity = 2.0;
  XrayBeam beam;
  double whole = 0.0;
  for (std::size_t bin = 0; bin < XrayBeam::bins; ++bin) {
    double sum = 0.0, byWater = 0.0, byBone = 0.0, byPlatinum = 0.0, byWire = 0.0;
    for (double energy = edges[bin] + 0.5 * step_keV; energy < edges[bin + 1]; energy += step_keV) {
      const double photons = tube_keV / energy - 1.0;
      const double signal =
          energy * photons * std::exp(-0.1 * filter_mm * aluminumDensity * at(aluminum(), energy));
      sum += signal;
      byWater += signal * at(water(), energy);
      byBone += signal * boneDensity * at(corticalBone(), energy);
      byPlatinum += signal * platinumDensity * at(platinum(), energy);
      byWire += signal * wireDensity * (0.9 * at(platinum(), energy) + 0.1 * at(iridium(), energy));
    }
    const auto perMillimeter = [sum](double value) {
      return static_cast<float>(0.1 * value / sum);
    };
    beam.weight[bin] = static_cast<float>(sum);
    beam.water[bin] = perMillimeter(byWater);
    beam.bone[bin] = perMillimeter(byBone);
    beam.platinum[bin] = perMillimeter(byPlatinum);
    beam.wire[bin] = perMillimeter(byWire);
    whole += sum;
  }
  for (float& weight : beam.weight) weight /= static_cast<float>(whole);
  return beam;
}

}  // namespace perilymph::test

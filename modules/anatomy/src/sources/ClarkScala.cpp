// SPDX-License-Identifier: BSD-3-Clause
#include "sources/ClarkScala.h"

#include <array>
#include <cmath>

#include "lumen/OutlineTables.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "sources/CohenSpiral.h"
#include "sources/MeanOutlines.h"

namespace perilymph::anatomy {
namespace {

// Clark, Warren and Abbott 2011 (confidence medium: taken from public code that cites them). Cohen
// puts the round window at 13.47 degrees.
constexpr double roundWindow_deg = 10.3;
constexpr double climb_mm_deg = 0.003056;

// Medial shift of the section's center, Leon et al. 2014, J Med Devices 8:041010, Table 3
// (confidence medium: taken from public code that cites it).
struct Shift {
  double angle_deg, direction, size_mm;  // direction in radians, from medial toward the base
};
constexpr std::array<Shift, 38> shifts{
    {{6.8, 1.57, 0.00},   {9.5, 1.57, 0.00},   {15.1, 1.43, 0.00},  {19.0, 1.17, 0.00},
     {23.5, 0.97, 0.00},  {34.3, 0.56, 0.00},  {46.7, 0.00, 0.30},  {60.4, 0.02, 0.30},
     {75.3, 0.04, 0.28},  {91.3, 0.06, 0.26},  {108.4, 0.07, 0.24}, {126.1, 0.08, 0.28},
     {144.2, 0.09, 0.28}, {162.8, 0.10, 0.32}, {181.9, 0.11, 0.35}, {201.5, 0.12, 0.40},
     {221.6, 0.13, 0.50}, {242.4, 0.14, 0.55}, {263.7, 0.15, 0.62}, {285.8, 0.16, 0.62},
     {308.5, 0.17, 0.60}, {332.0, 0.18, 0.60}, {356.4, 0.19, 0.65}, {381.6, 0.20, 0.66},
     {407.8, 0.21, 0.67}, {435.1, 0.22, 0.68}, {463.6, 0.23, 0.65}, {493.4, 0.24, 0.65},
     {524.6, 0.25, 0.65}, {557.3, 0.26, 0.57}, {591.9, 0.27, 0.49}, {628.4, 0.28, 0.41},
     {667.2, 0.29, 0.33}, {708.6, 0.30, 0.25}, {753.0, 0.25, 0.17}, {800.9, 0.20, 0.09},
     {853.0, 0.15, 0.01}, {910.1, 0.10, 0.01}}};
// The table's corners are rounded over this half-width (ours; confidence medium).
constexpr double rounding_deg = 15.0;

SpiralPoint shiftAt(std::size_t row)
{
  const SineCosine direction = sineCosine(shifts[row].direction);
  const double size = shifts[row].size_mm / 1e3;
  return {-size * direction.cosine, -size * direction.sine};
}

/// Linear interpolation between the rows, extrapolated beyond the first and the last.
SpiralPoint shiftBetween(double angle_deg)
{
  if (angle_deg <= shifts.front().angle_deg) return shiftAt(0);
  std::size_t i = 1;
  while (i < shifts.size() && shifts[i].angle_deg < angle_deg) ++i;
  if (i == shifts.size()) return shiftAt(i - 1);
  const double fraction =
      (angle_deg - shifts[i - 1].angle_deg) / (shifts[i].angle_deg - shifts[i - 1].angle_deg);
  const SpiralPoint a = shiftAt(i - 1);
  const SpiralPoint b = shiftAt(i);
  return {a.radius + fraction * (b.radius - a.radius), a.height + fraction * (b.height - a.height)};
}

}  // namespace

SpiralPoint clarkSpiral(Angle spiral)
{
  return {cohenRadius(inDegrees(spiral)),
          climb_mm_deg * (inDegrees(spiral) - roundWindow_deg) / 1e3};
}

SpiralPoint medialShift(Angle spiral)
{
  // a weighted mean around the angle, with weights (1 - x^2)^2
  constexpr int steps = 30;
  SpiralPoint mean{0.0, 0.0};
  double weights = 0.0;
  for (int i = -steps + 1; i < steps; ++i) {
    const double x = static_cast<double>(i) / steps;
    const double weight = (1.0 - x * x) * (1.0 - x * x);
    const SpiralPoint shift = shiftBetween(inDegrees(spiral) + x * rounding_deg);
    mean.radius += weight * shift.radius;
    mean.height += weight * shift.height;
    weights += weight;
  }
  return {mean.radius / weights, mean.height / weights};
}

Result<std::shared_ptr<const ScalaTympani>> buildClark(Length leadIn)
{
  const auto sections = loadMeasuredSections();
  if (!sections) return sections.error();
  const MeanOutlines mean(*sections);
  const double last = MeanOutlines::lastAngle();
  const OutlineSource source = [&](double angle) {
    const Angle spiral = radians(angle) + degrees(roundWindow_deg);
    const SpiralPoint path = clarkSpiral(spiral);
    const SpiralPoint shift = medialShift(spiral);
    OutlineAtAngle here{mean.outline(angle), path.radius,
                        membraneWidth(angle, last) * MeanOutlines::capFraction(angle)};
    const HalfPlanePoint center = centroid(here.outline);
    for (HalfPlanePoint& corner : here.outline) {
      corner.r += path.radius + shift.radius - center.r;
      corner.z += path.height + shift.height - center.z;
    }
    return here;
  };
  return std::make_shared<const ScalaTympani>(
      tablesFrom(source, nameOf(AnatomySource::clark), last, leadIn.si()));
}

}  // namespace perilymph::anatomy

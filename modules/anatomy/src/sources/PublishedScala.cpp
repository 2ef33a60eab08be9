// SPDX-License-Identifier: BSD-3-Clause

// The published three-parameter scala tympani (Todd and Naghdy, section II.B): quarter-turn
// sections as percentages of the one at the round window, inner wall as percentages of the
// organ-of-Corti length, parabolic sides, flat basilar membrane. Each gap in the paper is filled by
// a named constant with its source.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lumen/LeadIn.h"
#include "numerics/KnotSpline.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Math.h"
#include "sources/CohenSpiral.h"

namespace perilymph::anatomy {
namespace {

// --- the paper's own numbers (confidence high) ---
constexpr double publishedLength = 35.58e-3;  // organ of Corti, Kawano 1996
constexpr double startSpiral_deg = 13.47;     // round window on the spiral, Cohen 1996
constexpr double totalHeight = 2.56e-3;       // of the center line, base to apex
constexpr double riseTangent =
    0.17632698070846498;  // tan 10 degrees, along the inner wall, first turn
constexpr double membraneWidthBase = 0.15e-3;
constexpr double membraneWidthApex = 0.52e-3;

// --- sections of the mean scala tympani (n = 15, Froehlich et al. 2024, doi
//     10.1371/journal.pone.0295121), radial width, axial height and inner wall [mm] at quarter
//     turns and at its end: the percentages the paper does not print (confidence high up to 675
//     degrees) ---
struct Quarter {
  double angle_deg, width_mm, height_mm, inner_mm;
};
constexpr std::array<Quarter, 9> quarters{{{0.0, 1.94, 1.85, 4.30},
                                           {90.0, 2.00, 1.18, 2.00},
                                           {180.0, 1.94, 0.94, 1.36},
                                           {270.0, 1.95, 0.94, 0.88},
                                           {360.0, 1.63, 0.98, 0.71},
                                           {450.0, 1.57, 1.08, 0.49},
                                           {540.0, 1.46, 0.88, 0.25},
                                           {630.0, 1.42, 0.90, 0.10},
                                           {675.0, 1.39, 0.90, 0.09}}};
// Beyond the last measured section width and height decrease to this fraction of it at the apex
// (ours; confidence low).
constexpr double apexTaper = 0.6;
// The stretch after the first turn over which the 10 degree rise changes to the tilt (ours;
// confidence low).
constexpr double tiltBlend_deg = 90.0;

constexpr double step_deg = 1.5;
constexpr int directions = 96;

/// The angle from the round window at which the plan curve reaches the published length [deg].
double lastAngle_deg()
{
  constexpr double fine_deg = 0.05;
  constexpr double fine = fine_deg * pi / 180.0;
  double length = 0.0;
  double angle_deg = 0.0;
  double radius = cohenRadius(startSpiral_deg);
  while (length < publishedLength) {
    const double next = cohenRadius(startSpiral_deg + angle_deg + fine_deg);
    const double across = next - radius;
    const double mean = 0.5 * (next + radius);
    length += std::sqrt(across * across + mean * mean * fine * fine);
    radius = next;
    angle_deg += fine_deg;
  }
  return angle_deg;
}

/// The positive root s of k s^2 + c s = w: the distance to a side in the direction of cosine c.
double distanceToSide(double cosine, double k, double halfWidth)
{
  return 2.0 * halfWidth / (cosine + std::sqrt(cosine * cosine + 4.0 * k * halfWidth));
}

/// Distance from the center to the outline of the published section in a direction. The sides are
/// parabolas from the walls at half height to the edges of a flat roof, the basilar membrane, whose
/// inner edge is at the section's center; the floor mirrors the roof.
double outlineRadius(double direction, double halfWidth, double halfHeight, double membrane)
{
  const SineCosine d = sineCosine(direction);
  const auto isInside = [&](double s) {
    const double u = s * d.cosine;
    const double v = s * d.sine / halfHeight;
    if (v > 1.0 || v < -1.0) return false;
    const double side = 1.0 - v * v;
    return u > -halfWidth * side && u < membrane + (halfWidth - membrane) * side;
  };
  // Recordings depend on the bisection's result to the last bit. Where a step lies farther from the
  // closed form than rounding can move it, the closed form answers for the test.
  const double perHeight = d.sine / halfHeight;
  const double slack = halfWidth - membrane;
  double surelyInside = 0.0, surelyOutside = std::numeric_limits<double>::infinity();
  if (slack >= 0.0) {                   // else the inner edge of the roof is beyond the wall
    constexpr double rounding = 1e-10;  // relative, a million times that of the test
    const double closed =
        std::min({1.0 / std::fabs(perHeight),
                  distanceToSide(d.cosine, slack * perHeight * perHeight, halfWidth),
                  distanceToSide(-d.cosine, halfWidth * perHeight * perHeight, halfWidth)});
    surelyInside = closed * (1.0 - rounding);
    surelyOutside = closed * (1.0 + rounding);
  }
  double inside = 0.0;
  double outside = halfWidth + halfHeight;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (inside + outside);
    if (middle == inside || (middle == outside && slack >= 0.0)) break;  // none is between
    const bool isIn = middle < surelyInside || (middle <= surelyOutside && isInside(middle));
    (isIn ? inside : outside) = middle;
  }
  return inside;
}

/// Heights of the center line at each section [m]: a rise of 10 degrees along the inner wall over
/// the first turn, then a tilt that yields the published total height.
std::vector<double> centerHeights(const std::vector<double>& innerRadius, double step,
                                  double height)
{
  const std::size_t sections = innerRadius.size();
  const double turn = 2.0 * pi;
  const double blend = tiltBlend_deg * pi / 180.0;

  // slope over the first turn; `base` ends where the tilt has replaced it
  std::vector<double> rise(sections, 0.0);
  std::vector<double> weight(sections, 0.0);  // weight of the tilt in the slope
  double lastSlope = 0.0;
  for (std::size_t i = 0; i < sections; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, sections - 1);
    const double across =
        (innerRadius[after] - innerRadius[before]) / (step * static_cast<double>(after - before));
    const double slope = riseTangent * std::sqrt(innerRadius[i] * innerRadius[i] + across * across);
    const double past = (step * static_cast<double>(i) - turn) / blend;
    if (past <= 0.0) lastSlope = slope;
    const double x = std::clamp(past, 0.0, 1.0);
    weight[i] = x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    rise[i] = past <= 0.0 ? slope : lastSlope * (1.0 - weight[i]);
  }
  // trapezoidal integration of both parts; the tilt's slope follows from the total
  double risen = 0.0, tilted = 0.0;
  for (std::size_t i = 1; i < sections; ++i) {
    risen += 0.5 * step * (rise[i] + rise[i - 1]);
    tilted += 0.5 * step * (weight[i] + weight[i - 1]);
  }
  const double tilt = (height - risen) / tilted;
  std::vector<double> heights(sections, 0.0);
  for (std::size_t i = 1; i < sections; ++i)
    heights[i] =
        heights[i - 1] + 0.5 * step * (rise[i] + rise[i - 1] + tilt * (weight[i] + weight[i - 1]));
  return heights;
}

}  // namespace

std::shared_ptr<const ScalaTympani> buildPublished(const Patient& patient, Length leadIn)
{
  const double lengthScale = patient.scalaTympaniLength.si() / publishedLength;
  const double width = patient.roundWindowWidth.si();
  const double height = patient.roundWindowHeight.si();

  // the paper's percentages over the angle
  const double end_deg = lastAngle_deg();
  std::vector<double> angles, widthRatio, heightRatio, innerRatio;
  for (const Quarter& quarter : quarters) {
    angles.push_back(quarter.angle_deg);
    widthRatio.push_back(quarter.width_mm / quarters[0].width_mm);
    heightRatio.push_back(quarter.height_mm / quarters[0].height_mm);
    // relative to the plan curve at the same angle, so that between quarter turns the inner wall
    // curves as the spiral does
    innerRatio.push_back(quarter.inner_mm / 1e3 / cohenRadius(startSpiral_deg + quarter.angle_deg));
  }
  angles.push_back(end_deg);
  widthRatio.push_back(widthRatio.back() * apexTaper);
  heightRatio.push_back(heightRatio.back() * apexTaper);
  innerRatio.push_back(innerRatio.back());
  const KnotSpline widths(angles, widthRatio);
  const KnotSpline heights(angles, heightRatio);
  const KnotSpline inner(angles, innerRatio);

  SectionTables tables;
  tables.name = patient.label;
  tables.leadIn = leadIn.si();
  tables.directions = directions;
  const auto sections = static_cast<std::size_t>(std::lround(end_deg / step_deg)) + 1;
  const double realStep_deg = end_deg / static_cast<double>(sections - 1);
  tables.step = realStep_deg * pi / 180.0;

  std::vector<double> innerRadius(sections);
  for (std::size_t i = 0; i < sections; ++i) {
    const double angle_deg = realStep_deg * static_cast<double>(i);
    const double plan = lengthScale * cohenRadius(startSpiral_deg + angle_deg);
    const double halfWidth = 0.5 * width * widths(angle_deg);
    const double halfHeight = 0.5 * height * heights(angle_deg);
    const double along = angle_deg / end_deg;
    const double membrane = membraneWidthBase + along * (membraneWidthApex - membraneWidthBase);
    innerRadius[i] = plan * inner(angle_deg);
    tables.planRadius.push_back(plan);
    tables.centerRadius.push_back(innerRadius[i] + halfWidth);
    tables.membraneInner.push_back(0.0);
    tables.membraneOuter.push_back(membrane);
    tables.membraneHeight.push_back(halfHeight);
    for (int k = 0; k < directions; ++k)
      tables.wallRadius.push_back(
          outlineRadius(2.0 * pi * k / directions, halfWidth, halfHeight, membrane));
  }
  tables.centerHeight = centerHeights(innerRadius, tables.step, lengthScale * totalHeight);
  easeIntoLeadIn(tables);
  return std::make_shared<ScalaTympani>(std::move(tables));
}

}  // namespace perilymph::anatomy

// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/OutlineTables.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "lumen/LeadIn.h"
#include "lumen/SectionWall.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {
namespace {

constexpr double step_deg = 1.5;
constexpr int directions = 120;

void requireSeenWhole(double radius, double angle)
{
  if (radius > 0.0) return;
  char sentence[120];
  std::snprintf(sentence, sizeof sentence,
                "The section at %.1f degrees cannot be seen whole from its center.",
                inDegrees(radians(angle)));
  throw std::invalid_argument(sentence);
}

/// Around a section the table values are spline coefficients, which rounds corners. Measured
/// outlines have no corners: subtracting a sixth of the second difference from the coefficients
/// makes the spline interpolate them, up to fourth order.
void passThroughOutlines(SectionTables& tables)
{
  const std::vector<double> radii = tables.wallRadius;
  const auto row = static_cast<std::size_t>(directions);
  for (std::size_t first = 0; first < radii.size(); first += row)
    for (std::size_t k = 0; k < row; ++k) {
      const double before = radii[first + (k + row - 1) % row];
      const double after = radii[first + (k + 1) % row];
      tables.wallRadius[first + k] -= (after - 2.0 * radii[first + k] + before) / 6.0;
    }
}

}  // namespace

SectionTables tablesFrom(const OutlineSource& source, const std::string& name, double lastAngle,
                         double leadIn)
{
  SectionTables tables;
  tables.name = name;
  tables.leadIn = leadIn;
  tables.directions = directions;
  const auto pieces = std::lround(inDegrees(radians(lastAngle)) / step_deg);
  tables.step = lastAngle / static_cast<double>(pieces);
  for (long i = 0; i <= pieces; ++i) {
    const double angle = tables.step * static_cast<double>(i);
    const OutlineAtAngle here = source(angle);
    const HalfPlanePoint center = centroid(here.outline);
    tables.centerRadius.push_back(center.r);
    tables.centerHeight.push_back(center.z);
    tables.planRadius.push_back(here.planRadius);
    tables.membraneInner.push_back(0.0);
    tables.membraneOuter.push_back(here.membraneWidth);
    tables.membraneHeight.push_back(roofAt(here.outline, center.r + 0.5 * here.membraneWidth) -
                                    center.z);
    std::size_t near = 0;
    for (const Direction& ray : directionsAround<directions>()) {
      tables.wallRadius.push_back(radiusIn(here.outline, center, ray.around, near));
      requireSeenWhole(tables.wallRadius.back(), angle);
    }
  }
  easeIntoLeadIn(tables);
  passThroughOutlines(tables);
  return tables;
}

}  // namespace perilymph::anatomy

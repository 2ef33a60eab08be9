// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesScore.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "statements/Warnings.h"

namespace perilymph::imaging {
namespace {

// A cochlea is 10 mm long in any direction; with its surroundings 25 mm show all of it.
constexpr double wholeExtent_mm = 25.0;
constexpr double coarseVoxel_mm = 0.65;  // as Flag::coarseVoxels of ct

std::string inMm(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

double shortestExtent_mm(const CtSeries& series)
{
  double extent = 1e9;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    extent =
        std::min(extent, series.size[static_cast<std::size_t>(axis)] * series.spacing_mm[axis]);
  return extent;
}

}  // namespace

bool isBoneKernel(const std::string& kernel)
{
  std::string upper;
  for (const char c : kernel)
    if (c != ' ') upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto begins = [&upper](const char* start) { return upper.rfind(start, 0) == 0; };
  // GE, and any maker that says so.
  if (upper.find("BONE") != std::string::npos || begins("EDGE") || begins("ULTRA")) return true;
  if (begins("INNEREAR") || begins("EAR")) return true;
  if (begins("FC")) {  // Canon: 30 to 35 and 80 to 86 are for bone and the inner ear
    const int number = std::atoi(upper.c_str() + 2);
    return (number >= 30 && number <= 35) || (number >= 80 && number <= 86);
  }
  if (begins("YD") || begins("YE") || upper == "D" || upper == "E") return true;  // Philips
  // Siemens: letters, then the sharpness, 60 and above for bone.
  if (begins("B") || begins("H") || begins("U") || begins("J")) {
    const std::size_t digits = upper.find_first_of("0123456789");
    return digits != std::string::npos && digits <= 2 && std::atoi(upper.c_str() + digits) >= 60;
  }
  return false;
}

double scoreOf(const CtSeries& series, bool isDerived)
{
  if (!series.obstacle.empty() || !(series.spacing_mm.minCoeff() > 0.0)) return 0.0;
  // 0.1 mm is as fine as scanners are; 1 mm is refused.
  const double voxel_mm = std::cbrt(series.spacing_mm.prod());
  const double fineness = std::clamp((1.0 - voxel_mm) / 0.9, 0.0, 1.0);
  const double extent = std::min(1.0, shortestExtent_mm(series) / wholeExtent_mm);
  return 60.0 * fineness + (isBoneKernel(series.kernel) ? 20.0 : 0.0) + 15.0 * extent +
         (isDerived ? 0.0 : 5.0);
}

void addSizeWarnings(CtSeries& series)
{
  if (!(series.spacing_mm.minCoeff() > 0.0)) return;
  if (series.spacing_mm.maxCoeff() > coarseVoxel_mm)
    series.warnings.push_back(Sentence(warnings::coarse, {inMm(series.spacing_mm.maxCoeff())}));
  if (shortestExtent_mm(series) < wholeExtent_mm)
    series.warnings.push_back(Sentence(warnings::thin, {inMm(shortestExtent_mm(series))}));
}

}  // namespace perilymph::imaging

#pragma once

// Numbers for people and for tables.

#include <charconv>
#include <cmath>
#include <string>

#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// With so many digits behind the point.
inline std::string fixed(double value, int digits)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

/// A travel in millimeters without the rounding errors of a multiple of the step.
inline double roundedMillimeters(double travel)
{
  return std::round(inMillimeters(meters(travel)) * 1e6) / 1e6;
}

}  // namespace perilymph::analysis

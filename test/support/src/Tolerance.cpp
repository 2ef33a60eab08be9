// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/Tolerance.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace perilymph::test {

namespace {

double scale()
{
  const char* const text = std::getenv("PERILYMPH_TOLERANCE_SCALE");
  if (text == nullptr || *text == '\0') return 1.0;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (*end != '\0' || !std::isfinite(value) || value < 0.0)
    throw std::invalid_argument("PERILYMPH_TOLERANCE_SCALE is '" + std::string(text) +
                                "'; it must be a number, 0 or more.");
  return value;
}

}  // namespace

double tolerance(double value, const char* reason)
{
  if (!(value >= 0.0))
    throw std::invalid_argument("A tolerance is " + std::to_string(value) +
                                "; it must be 0 or more.");
  if (reason == nullptr || *reason == '\0')
    throw std::invalid_argument("A tolerance needs its reason.");
  return value * scale();
}

}  // namespace perilymph::test

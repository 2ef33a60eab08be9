// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers in messages about imported surfaces.

#include <cstdio>
#include <string>

namespace perilymph::anatomy {

/// A number as printf() writes it.
inline std::string inText(double value, const char* format)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace perilymph::anatomy

#pragma once

// Numbers as people read them.

#include <string>

namespace perilymph::cli {

/// A number with a sensible number of digits after the point, for people.
std::string fixed(double value, int digits);

}  // namespace perilymph::cli

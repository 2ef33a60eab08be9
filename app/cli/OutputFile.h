#pragma once

// What every file that this program writes has in common.

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Whether a file could be written at a place, asked before the work that fills it. An empty name
/// means no file was asked for.
Result<Done> checkPlace(const std::string& file);

/// A number with a sensible number of digits after the point, for people.
std::string fixed(double value, int digits);

}  // namespace perilymph::cli

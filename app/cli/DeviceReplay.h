#pragma once

// A captured device read again, where the device is not.

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Prints what the tape is of and what its reports say; writes it as JSON if a file is named.
Result<Done> replayDevice(const std::string& tape, const std::string& json);

}  // namespace perilymph::cli

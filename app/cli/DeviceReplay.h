// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of a captured device without the device.

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Prints the tape's device and statistics of its reports; writes JSON if a file is named.
Result<void> replayDevice(const std::string& tape, const std::string& json);

}  // namespace perilymph::cli

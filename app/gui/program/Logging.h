// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Log file of the program.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes messages of the program and of Qt to perilymph.log in a folder, rotated at 1 MiB with
/// three older files. Qt's warnings are also written to standard error.
Result<void> startLog(const std::filesystem::path& folder);

}  // namespace perilymph::gui

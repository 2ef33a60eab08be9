// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is checked of a plug-in's file before any process loads it.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::device::plugin {

/// Checks that a file is a shared library that this user may read and that not every user may change.
/// The file is not loaded. The error continues "The plug-in is not taken:".
Result<void> checkFile(const std::filesystem::path& file);

}  // namespace perilymph::device::plugin

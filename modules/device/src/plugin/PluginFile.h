// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is checked of a plug-in's file before any process loads it.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::device::plugin {

/// Checks that a file is a shared library that this user may read and that nobody else may change or
/// replace: it belongs to this user, to root or to the owner of this program, as do the folders on the
/// way to it, through links too. The file is not loaded.
///
/// @return  Its absolute path without links. The error continues "The plug-in is not taken:".
Result<std::filesystem::path> checkedFile(const std::filesystem::path& file);

}  // namespace perilymph::device::plugin

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace perilymph {

/// The resources of this build: those beside the program, else those of the source tree. What
/// resourceRoot() returns without PERILYMPH_RESOURCES.
std::filesystem::path ownResourceRoot();

}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The progress of a work that consists of insertions.

#include <cstddef>
#include <functional>

namespace perilymph::analysis {

/// Receives the insertions that are done, and all, in the caller's thread, several times a second.
using RunProgress = std::function<void(std::size_t done, std::size_t all)>;

}  // namespace perilymph::analysis

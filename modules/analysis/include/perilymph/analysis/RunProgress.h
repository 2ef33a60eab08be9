// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs insertions on several threads.

#include <cstddef>
#include <functional>

#include "perilymph/foundation/InParallel.h"

namespace perilymph::analysis {

using perilymph::doInParallel;
using perilymph::PieceProgress;
using perilymph::processors;
/// PieceProgress for insertions of a longer work: done, and all.
using RunProgress = std::function<void(std::size_t done, std::size_t all)>;

}  // namespace perilymph::analysis

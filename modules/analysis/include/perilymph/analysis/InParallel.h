// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs independent pieces of work on several threads. The assignment of pieces to threads does not
// affect results: each piece writes to its own memory.

#include <atomic>
#include <functional>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Receives the number of done pieces in the caller's thread; returns false to stop.
using PieceProgress = std::function<bool(std::size_t done)>;

/// Runs the pieces 0 to count - 1. Returns the error of the first failed piece, in their order, or
/// that the work was stopped.
///
/// @param jobs  Threads; 0: one per processor.
/// @param work  Called in any thread; should end early when the flag is set.
Result<Done> doInParallel(
    std::size_t count, unsigned jobs,
    const std::function<Result<Done>(std::size_t, const std::atomic<bool>& isAsked)>& work,
    const PieceProgress& progress);

}  // namespace perilymph::analysis

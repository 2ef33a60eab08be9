#pragma once

// Many independent pieces of work on a few threads. Which thread does which piece leaves no trace:
// each piece writes to a place of its own.

#include <atomic>
#include <functional>

#include "perilymph/foundation/Result.h"

namespace perilymph::analysis {

/// Told, in the caller's thread, how many pieces are done; stops the work by giving false.
using PieceProgress = std::function<bool(std::size_t done)>;

/// Does the pieces 0 to count - 1. The error of the first piece, in their order, that failed; or
/// that the work was stopped.
///
/// @param jobs  Threads; 0 for as many as the machine has.
/// @param work  Called in any thread; should end early once the flag is set.
Result<Done> doInParallel(
    std::size_t count, unsigned jobs,
    const std::function<Result<Done>(std::size_t, const std::atomic<bool>& isAsked)>& work,
    const PieceProgress& progress);

}  // namespace perilymph::analysis

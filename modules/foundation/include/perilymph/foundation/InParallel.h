// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs independent pieces of work on several threads. The assignment of pieces to threads does not
// affect results: each piece writes to its own memory.

#include <cstddef>
#include <functional>
#include <stop_token>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// Processors of this machine, at least 1.
unsigned processors() noexcept;

/// Receives the number of done pieces, in the caller's thread, several times a second.
using PieceProgress = std::function<void(std::size_t done)>;

/// Runs the pieces 0 to count - 1. Returns the error of the first failed piece, in their order, or
/// that the work was stopped.
///
/// @param jobs  Threads; 0: one per processor.
/// @param work  Called in any thread; should end early when its token requests it: after `stop`, or
///              because another piece failed.
Result<void> doInParallel(
    std::size_t count, unsigned jobs,
    const std::function<Result<void>(std::size_t, const std::stop_token& stop)>& work,
    const PieceProgress& progress = {}, const std::stop_token& stop = {});

}  // namespace perilymph

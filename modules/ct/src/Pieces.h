// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pieces of a measurement that do not depend on each other, on several threads. Each writes to its own
// memory, and results are joined in the order of the pieces: no number of threads changes a bit.

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <stop_token>

#include "perilymph/foundation/InParallel.h"

namespace perilymph::ct {

/// Threads of a stage of the measurement.
enum class Threads {
  one,  ///< The caller's: it is itself one of several.
  all,  ///< One per processor.
};

/// Calls `work` for the pieces 0 to count - 1; some are left out after a request to stop.
///
/// @param progress  Called in the caller's thread.
inline void eachPiece(std::size_t count, Threads threads,
                      const std::function<void(std::size_t)>& work,
                      const PieceProgress& progress = {}, const std::stop_token& stop = {})
{
  if (threads == Threads::one) {
    for (std::size_t piece = 0; piece < count && !stop.stop_requested(); ++piece) work(piece);
    return;
  }
  const auto done = doInParallel(
      count, 0,
      [&work](std::size_t piece, const std::stop_token&) -> Result<void> {
        work(piece);
        return {};
      },
      progress, stop);
  // what the pieces can throw is a lack of memory
  if (!done && !stop.stop_requested()) throw std::runtime_error(done.error().message);
}

}  // namespace perilymph::ct

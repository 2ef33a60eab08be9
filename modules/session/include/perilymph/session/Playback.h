// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Playback of a recording: any tick with the shape of the array.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Recording.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Values come from the file; shapes are recomputed by the same tick function from the recorded
/// samples, without a device.
///
/// Ticks are indexed from the first in the file, 0. Two threads may use one playback: one calls
/// compute(), the other all other functions.
class Playback {
public:
  /// Opens a recording and builds its cochlea and model: takes some tenths of a second.
  static Result<std::unique_ptr<Playback>> open(const std::filesystem::path& file);
  ~Playback();

  const std::filesystem::path& file() const noexcept;
  const RecordingFacts& facts() const noexcept;
  const Scenario& scenario() const noexcept;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy() const noexcept;

  /// Number of ticks that can be shown: up to the first lost one, at least one.
  std::uint64_t ticks() const noexcept;
  double timeStep() const noexcept;  ///< [s]
  /// Index of the first tick in which the array moves.
  std::uint64_t beginning() const noexcept;

  /// Recorded outputs at equal steps, at most some thousand: for curves.
  struct Sample {
    std::uint64_t place = 0;
    haptics::TickOutput output;
    haptics::PeakForce peak;  ///< So far, of the ticks between samples, too.
  };
  const std::vector<Sample>& samples() const noexcept;

  /// Recomputes the whole recording, compares it bit by bit, and stores states from which show()
  /// can continue. `stop` ends it early, with an error.
  Result<Verification> compute(const std::stop_token& stop = {});
  /// Number of ticks for which show() is fast.
  std::uint64_t computedTicks() const noexcept;

  /// The snapshot of a tick; of the last one if the index is too large.
  Result<void> show(std::uint64_t place, haptics::Snapshot& picture);

private:
  Playback();
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::session

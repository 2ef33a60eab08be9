#pragma once

// A recording that can be looked at, at any of its ticks, with the shape of the array.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Recording.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Numbers come from the file, shapes are computed again by the very same tick. No device is
/// involved anywhere: what moved the array are the recorded samples.
///
/// Places count ticks from the first in the file, 0. Two threads may use one playback: one calls
/// compute(), one everything else.
class Playback {
public:
  /// Opens a recording and builds its cochlea and model: some tenths of a second.
  static Result<std::unique_ptr<Playback>> open(const std::filesystem::path& file);
  ~Playback();

  const std::filesystem::path& file() const noexcept;
  const RecordingFacts& facts() const noexcept;
  const Scenario& scenario() const noexcept;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy() const noexcept;

  /// How many ticks can be shown: all up to the first that was lost, at least one.
  std::uint64_t ticks() const noexcept;
  double timeStep() const noexcept;  ///< [s]
  /// The place of the first tick in which the array moves.
  std::uint64_t beginning() const noexcept;

  /// Recorded outputs in even steps, at most some thousand: for curves.
  struct Sample {
    std::uint64_t place = 0;
    haptics::TickOutput output;
  };
  const std::vector<Sample>& samples() const noexcept;

  /// Computes the whole recording again, compares it bit by bit, and leaves states on the way from
  /// which show() goes on. `progress(done, all)` stops it by giving false.
  Result<Verification> compute(
      const std::function<bool(std::uint64_t, std::uint64_t)>& progress = {});
  /// Up to here show() is quick.
  std::uint64_t computedTicks() const noexcept;

  /// The picture of a tick; the last one where there are fewer ticks.
  Result<Done> show(std::uint64_t place, haptics::Snapshot& picture);

private:
  Playback();
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::session

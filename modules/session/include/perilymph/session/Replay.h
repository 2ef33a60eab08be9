// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Verification of a recording by replay: the same bits, or the first difference.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// First difference between a replay and its recording.
struct Difference {
  std::uint64_t tick = 0;
  std::string field;     ///< Field of TickOutput, such as "force_W[2]".
  std::string recorded;  ///< The value and its bits.
  std::string computed;
};

struct Verification {
  std::uint64_t ticks = 0;          ///< In the file.
  std::uint64_t ticksCompared = 0;  ///< Up to the first difference or the first lost tick.
  std::uint64_t missingTicks = 0;   ///< Lost during recording, as stated by the recording.
  /// The file is consistent, and every field of every tick in it was recomputed with the same bits.
  bool isIdentical = false;
  std::optional<Difference> difference;  ///< The first one.
  /// Inconsistency of the file (RecordingCheck::damage); nothing is compared then.
  std::string damage;
  /// The version of the program that computed the ticks, if it is not this one; its physics may be another.
  std::string otherVersion;
  std::vector<Sentence> notes;  ///< Messages: another build, a changed array file, lost ticks.
};

/// Receives the number of compared ticks and of all ticks.
using VerifyProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

/// Checks the consistency of the file, builds the model from the recording's own scenario, feeds
/// the recorded samples and commands through InsertionEngine::tick and compares every output field
/// bit by bit. Ticks after lost ones cannot be compared. `stop` ends it early, with an error.
Result<Verification> verify(const std::filesystem::path& file, const VerifyProgress& progress = {},
                            const std::stop_token& stop = {});

}  // namespace perilymph::session

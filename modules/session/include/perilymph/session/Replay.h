#pragma once

// A recording run again through the very same tick: the same bits, or where they begin to differ.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// Where a replay left the recording.
struct Difference {
  std::uint64_t tick = 0;
  std::string field;     ///< Field of TickOutput, such as "force_W[2]".
  std::string recorded;  ///< The value, and its bits.
  std::string computed;
};

struct Verification {
  std::uint64_t ticks = 0;          ///< In the file.
  std::uint64_t ticksCompared = 0;  ///< Up to the first difference, or the first that was lost.
  std::uint64_t missingTicks = 0;   ///< Lost while recording, as the recording itself says.
  /// The file holds what was recorded, and every field of every tick in it was computed again to
  /// the same bits.
  bool isIdentical = false;
  std::optional<Difference> difference;  ///< The first one.
  /// What of the file is not as it was recorded (RecordingCheck::damage); then nothing is compared.
  std::string damage;
  std::vector<std::string> notes;  ///< Sentences: another build, a changed array file, lost ticks.
};

/// Told how many ticks of how many were compared; false stops.
using VerifyProgress = std::function<bool(std::uint64_t done, std::uint64_t all)>;

/// Checks that the file holds what was recorded, builds the model from the recording's own
/// scenario, feeds the recorded samples and commands through InsertionEngine::tick and compares
/// every output field bit by bit. After ticks that were lost, nothing can be compared.
Result<Verification> verify(const std::filesystem::path& file, const VerifyProgress& progress = {});

}  // namespace perilymph::session

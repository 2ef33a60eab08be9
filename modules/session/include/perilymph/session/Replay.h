#pragma once

// A recording run again through the very same tick: the same bits, or where they begin to differ.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// Where a replay left the recording.
struct Difference {
  std::uint64_t tick = 0;
  std::string field;     ///< Of TickOutput, such as "force_W[2]".
  std::string recorded;  ///< The value, and its bits.
  std::string computed;
};

struct Verification {
  std::uint64_t ticksCompared = 0;
  bool isIdentical = false;              ///< Every field of every tick that could be compared.
  std::optional<Difference> difference;  ///< The first one.
  std::vector<std::string> notes;  ///< Sentences: another build, a changed array file, lost ticks.
};

/// Builds the model anew from the recording's own scenario, feeds the recorded samples and commands
/// through InsertionEngine::tick and compares every output field bit by bit. After ticks that were
/// lost, nothing can be compared.
Result<Verification> verify(const std::filesystem::path& file);

}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Script of the virtual handle: a sequence of passages.

#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// Activity of the connection.
enum class Wire {
  reporting,  ///< One report per tick.
  silent,     ///< No reports, but the device keeps counting.
  paused,     ///< No reports, and the device does not count.
  answering,  ///< One report for each received report.
  unplugged,
};

/// Whether a hand holds the handle in place.
enum class Grip { held, free };

/// A period with constant conditions, except for the handle's motion.
struct Passage {
  std::string name;       ///< One word.
  double duration = 0.0;  ///< [s]; 0: until the first output report, when the host listens.
  Grip grip = Grip::held;
  bool isButtonPressed = false;
  double push = 0.0;  ///< Force of the hand toward the cochlea [N].
  Wire wire = Wire::reporting;
};

/// Flaws of the handle, each of which the harness must detect.
enum class Flaw { none, flippedForce, doubledForce, lostReport, repeatedReport };

struct HandleScript {
  std::vector<Passage> passages;
  Flaw flaw = Flaw::none;
};

/// Force of the hand into the wall [N].
inline constexpr double pushAtRest = 0.2;

/// Number of reports that are missing while the handle is silent, at a thousand a second.
inline constexpr int silentReports = 50;

/// Phases of the device's period at which a loop starts, evenly spread.
inline constexpr int startPhases = 8;

/// stream, lost, repeated, session, phases, killed, answer, stops, flipped or doubled; a sentence for
/// other names.
Result<HandleScript> scriptNamed(const std::string& name);

}  // namespace perilymph::hidstack

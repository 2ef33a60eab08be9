// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What happens to the virtual handle, one passage after the other.

#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// What the handle's cable carries.
enum class Wire {
  reporting,  ///< A report a tick.
  silent,     ///< Nothing, though the device counts on.
  paused,     ///< Nothing, and the device does not count.
  answering,  ///< A report for each that comes in.
  unplugged,
};

/// Whether a hand holds the handle in place.
enum class Grip { held, free };

/// A stretch of time in which nothing about the handle changes but its motion.
struct Passage {
  std::string name;       ///< One word.
  double duration = 0.0;  ///< [s]; 0: until the first output report, that is: the host listens.
  Grip grip = Grip::held;
  bool isButtonPressed = false;
  double push = 0.0;  ///< Push of the hand toward the cochlea [N].
  Wire wire = Wire::reporting;
};

/// What is wrong with the handle: the harness must notice each of them.
enum class Flaw { none, flippedForce, doubledForce, lostReport, repeatedReport };

struct HandleScript {
  std::vector<Passage> passages;
  Flaw flaw = Flaw::none;
};

/// The push of the hand into the wall [N].
inline constexpr double pushAtRest = 0.2;

/// Reports that never come while the handle is silent, of a thousand a second.
inline constexpr int silentReports = 50;

/// stream, lost, repeated, session, killed, answer, flipped or doubled; a sentence for other names.
Result<HandleScript> scriptNamed(const std::string& name);

}  // namespace perilymph::hidstack

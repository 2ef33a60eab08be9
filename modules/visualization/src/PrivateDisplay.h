#pragma once

// An X server for the time of a picture, on machines without a screen.

#include <sys/types.h>

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::visualization {

/// Runs Xvfb as a child and points DISPLAY at it until destroyed.
class PrivateDisplay {
public:
  /// Starts one; an Error says what is missing.
  static Result<PrivateDisplay> start();

  PrivateDisplay(PrivateDisplay&& other) noexcept;
  PrivateDisplay& operator=(PrivateDisplay&&) = delete;
  ~PrivateDisplay();

private:
  explicit PrivateDisplay(pid_t server) : server_(server) {}
  pid_t server_;
};

/// Whether the display that DISPLAY names answers and offers OpenGL 3.2. Asks libX11 and libGL by
/// themselves: VTK would end the program where it fails.
Result<Done> probeDisplay();

}  // namespace perilymph::visualization

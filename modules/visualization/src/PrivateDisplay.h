#pragma once

// An X server for the time of a picture, on machines without a screen.

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

#include "perilymph/foundation/Result.h"

namespace perilymph::visualization {

/// Runs Xvfb as a child and points DISPLAY at it; once destroyed, DISPLAY is as before.
class PrivateDisplay {
public:
  /// Starts one; an Error says what is missing.
  static Result<PrivateDisplay> start();

  PrivateDisplay(PrivateDisplay&& other) noexcept;
  PrivateDisplay& operator=(PrivateDisplay&&) = delete;
  ~PrivateDisplay();

private:
  PrivateDisplay(pid_t server, std::optional<std::string> before)
      : server_(server), before_(std::move(before))
  {
  }
  pid_t server_;
  std::optional<std::string> before_;  ///< DISPLAY, if it was set.
};

/// Whether the display that DISPLAY names answers and offers OpenGL 3.2. Asks libX11 and libGL by
/// themselves: VTK would end the program where it fails.
Result<Done> probeDisplay();

}  // namespace perilymph::visualization

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A temporary X server for pictures on machines without a screen.

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

#include "perilymph/foundation/Result.h"

namespace perilymph::visualization {

/// Runs Xvfb as a child process and sets DISPLAY; the destructor restores DISPLAY.
class PrivateDisplay {
public:
  /// Starts a server; an Error names what is missing.
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

/// Whether the display named by DISPLAY responds and supports OpenGL 3.2. Queries libX11 and libGL
/// directly, because VTK would terminate the program on failure.
Result<Done> probeDisplay();

}  // namespace perilymph::visualization

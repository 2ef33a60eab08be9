// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A temporary X server for pictures on machines without a screen.

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::visualization {

/// Runs Xvfb as a child process and sets DISPLAY and XAUTHORITY; the destructor restores them. Only
/// who knows its cookie may connect, which is in memory that other users cannot read. It ends with
/// the thread that started it.
class PrivateDisplay {
public:
  /// Starts a server; an Error names what is missing.
  static Result<PrivateDisplay> start();

  PrivateDisplay(PrivateDisplay&& other) noexcept;
  PrivateDisplay& operator=(PrivateDisplay&&) = delete;
  ~PrivateDisplay();

private:
  using Variable = std::pair<const char*, std::optional<std::string>>;  // nullopt: not set
  PrivateDisplay(pid_t server, int cookie, std::vector<Variable> before)
      : server_(server), cookie_(cookie), before_(std::move(before))
  {
  }
  pid_t server_;
  int cookie_;                    // descriptor of the file of its cookie
  std::vector<Variable> before_;  // variables of this process before
};

/// Whether the display named by DISPLAY responds and supports OpenGL 3.2. Queries libX11 and libGL
/// directly, because VTK would terminate the program on failure.
Result<void> probeDisplay();

}  // namespace perilymph::visualization

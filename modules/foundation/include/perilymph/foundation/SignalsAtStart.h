// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which signals the caller of this program had ignored.

namespace perilymph {

/// Whether a signal was ignored when the program started, as SIGHUP is under nohup and SIGINT in
/// background jobs: then it is to remain ignored. Its action in main() does not tell: shared libraries
/// may have set handlers before, as UCX does for SIGHUP, which VTK 9.3 of Debian 13 loads.
///
/// @param signal  SIGHUP, SIGINT or SIGTERM; false for all others. In programs only, not in shared libraries.
bool wasIgnoredAtStart(int signal) noexcept;

}  // namespace perilymph

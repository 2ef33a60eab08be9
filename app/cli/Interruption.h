// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// SIGINT, SIGTERM and SIGHUP end every command soon and leave no incomplete files.

#include <stop_token>

namespace perilymph::cli {

/// From now on such a signal ends the program at once, with a message, status 1 and without
/// unfinished files. Ignored signals remain ignored, as with nohup and background jobs; blocked
/// ones are unblocked, and pending ones take effect now.
void endOnInterruption();

/// From now on the first such signal only requests an end, because the command has to close a recording
/// or remove a force. After three seconds, or at a second signal, the program ends at once.
///
/// @return  The request, for work that takes one. A signal handler may not make it: isInterrupted()
///          does, which the command polls.
std::stop_token watchForInterruption();

/// True after an end was requested; then the token of watchForInterruption() requests it, too.
bool isInterrupted();

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// SIGINT, SIGTERM and SIGHUP end every command soon and leave no incomplete files.

namespace perilymph::cli {

/// From now on such a signal ends the program at once, with a message, status 1 and without
/// unfinished files. Ignored signals remain ignored, as with nohup and background jobs; blocked
/// ones are unblocked, and pending ones take effect now.
void endOnInterruption();

/// From now on the first such signal only requests an end, which the command polls with
/// isInterrupted(), because it has to close a recording or remove a force. After three seconds, or
/// at a second signal, the program ends at once.
void watchForInterruption();

/// True after an end was requested.
bool isInterrupted();

}  // namespace perilymph::cli

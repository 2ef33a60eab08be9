#pragma once

// SIGINT, SIGTERM and SIGHUP: they end every command soon, and nothing half-written is left.

namespace perilymph::cli {

/// From now on such a signal ends the program at once, with a sentence, status 1 and without the
/// files that are not finished. One that is ignored stays so, as nohup and jobs in the background
/// have it; one that is blocked is not any more, and one that came before takes effect now.
void endOnInterruption();

/// From now on the first such signal only asks for an end, which the command sees in
/// isInterrupted(): it has a recording to close or a force to take away. A command that has not
/// ended three seconds later, and a second signal, end the program at once.
void watchForInterruption();

/// True once an end was asked for.
bool isInterrupted();

}  // namespace perilymph::cli

#pragma once

// Ctrl-C and a polite kill: asked for between ticks, so that files are left whole.

namespace perilymph::cli {

/// From now on SIGINT, SIGTERM and SIGHUP ask for an end instead of making one.
void watchForInterruption();

/// An end was asked for.
bool isInterrupted();

}  // namespace perilymph::cli

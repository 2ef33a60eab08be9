// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recovery of recordings after a crash.

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

class MainWindow;

/// Reads a recording until stopped, as session::summarize does.
using Summarize = std::function<session::SessionSummary(const std::filesystem::path&,
                                                        const std::stop_token& stop)>;

/// As session::summarize(), but no insertion if the recording is damaged or its first second of
/// replay differs.
session::SessionSummary summarizeReplayable(const std::filesystem::path& file,
                                            const std::stop_token& stop);

/// Reports, when the window is visible, which recordings were saved by crashed runs, and offers to
/// open them. Recordings are read in the background, so that a damaged one does not block the
/// window.
void offerRecovery(MainWindow& window, const std::vector<std::filesystem::path>& recordings,
                   const Summarize& summarize = summarizeReplayable);

}  // namespace perilymph::gui

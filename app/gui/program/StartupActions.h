// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Automatic actions of --demo, --screenshot and --measure-frames.

#include "gui/program/CommandLine.h"

namespace perilymph::gui {

class KioskWindow;
class MainWindow;

/// Starts the actions of a call, which end the application with its exit status.
void arrangeStartupActions(MainWindow& window, const CommandLine& options);
/// The same for the booth (screenshots only).
void arrangeStartupActions(KioskWindow& window, const CommandLine& options);

}  // namespace perilymph::gui

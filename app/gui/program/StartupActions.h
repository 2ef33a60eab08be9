#pragma once

// What the window does by itself when it was called with --demo, --screenshot or --measure-frames.

#include "gui/program/CommandLine.h"

namespace perilymph::gui {

class KioskWindow;
class MainWindow;

/// Sets the errands of a call in motion. They end the application with its exit status.
void arrangeStartupActions(MainWindow& window, const CommandLine& options);
/// The same at the booth, which can be photographed.
void arrangeStartupActions(KioskWindow& window, const CommandLine& options);

}  // namespace perilymph::gui

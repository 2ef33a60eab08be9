#pragma once

// What the window does by itself when it was called with --demo, --screenshot or --measure-frames.

#include "Options.h"

namespace perilymph::gui {

class KioskWindow;
class MainWindow;

/// Sets the errands of a call in motion. They end the application with its exit status.
void scheduleStartupActions(MainWindow& window, const Options& options);
/// The same at the booth, which can be photographed.
void scheduleStartupActions(KioskWindow& window, const Options& options);

}  // namespace perilymph::gui

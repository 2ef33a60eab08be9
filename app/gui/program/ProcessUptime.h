#pragma once

// How long this process has been alive: what a person waited for, libraries' loading included.

namespace perilymph::gui {

/// Since the process was started [s], to 10 ms. 0 where the system does not tell.
double processUptime_s();

}  // namespace perilymph::gui

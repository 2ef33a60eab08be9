// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Time since the start of this process, including loading of libraries.

namespace perilymph::gui {

/// Time since the start of the process [s], with a resolution of 10 ms; 0 if unknown.
double processUptime_s();

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the engine says of files with results and of patients' files.

#include <vector>

namespace perilymph::gui {

/// Sentences with %1, %2 and so on for what differs (engineError()).
std::vector<const char*> resultErrors();

}  // namespace perilymph::gui

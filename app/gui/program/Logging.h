#pragma once

// The program's log, where people and packagers look for it.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// From now on messages of the program and of Qt go to perilymph.log in a folder, rotated at 1 MiB,
/// three older ones kept. Qt's warnings still reach standard error.
Result<Done> startLog(const std::filesystem::path& folder);

}  // namespace perilymph::gui

#pragma once

// A file that a scenario names: its patient, array, friction or calibration.

#include <filesystem>
#include <string>
#include <string_view>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// findByName() for names that a file gives, which may come from anybody: pipes, terminals and
/// devices, on which reading waits for ever, are refused.
Result<std::filesystem::path> namedFile(std::string_view kind, std::string_view folder,
                                        const std::string& nameOrFile);

}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tables as files with the dictionary of their columns.

#include <filesystem>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Writes a table and, beside it, "<name>-dictionary.csv", which states what its columns are. Any thread.
Result<void> writeTable(const std::filesystem::path& file, const std::string& csv,
                        const std::string& dictionary);

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The table of contacts as files, for whoever programs the sound processor.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/foundation/Result.h"

class QWidget;

namespace perilymph::gui {

/// Writes a table and, beside it, "<name>-dictionary.csv", which states what its columns are.
Result<Done> writeContactTable(const std::filesystem::path& file, const std::string& csv);

/// Lets the user choose a file in the folder of documents. Empty if the user cancels.
///
/// @param array  Part of the proposed name.
std::optional<std::filesystem::path> chooseContactFile(QWidget* parent, const std::string& array);

}  // namespace perilymph::gui

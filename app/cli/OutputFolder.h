// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A folder that a command fills after all its work is done.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "CommandFiles.h"
#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Checks, before the work, that a folder can be created and filled.
Result<void> checkFolder(const std::string& folder);

/// Checks, before the work, that a folder has no files of other origin that would be replaced.
///
/// @param names   Files that the command replaces.
/// @param isOwn   Whether the folder is one that the command made, which it continues or fills again.
Result<void> checkReplaced(const std::filesystem::path& folder,
                           const std::vector<std::string>& names, bool isOwn);

/// The files of the folder.
struct FolderContent {
  std::vector<std::pair<std::string, std::string>> texts;         ///< Name and content.
  std::vector<std::pair<std::string, figures::Drawing>> figures;  ///< Name without extension.
};

/// Creates the folder if missing and writes every file atomically; figures as SVG, and as PNG if
/// this build supports it. Prints the written files.
///
/// @throws std::logic_error for a file that is not a declared output of the call.
Result<void> writeFolder(const CommandFiles& files, const std::string& folder,
                         const FolderContent& content);

/// Shows progress if standard error is a terminal, and looks for a request to end.
void showProgress(const char* what, std::size_t done, std::size_t all);

}  // namespace perilymph::cli

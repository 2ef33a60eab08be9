#pragma once

// A folder that a command fills once all its work is done.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "CallFiles.h"
#include "perilymph/figures/Drawing.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Whether a folder could be made and filled, asked before the work that fills it.
Result<Done> checkFolder(const std::string& folder);

/// What will stand in the folder.
struct FolderContent {
  std::vector<std::pair<std::string, std::string>> texts;         ///< Name and content.
  std::vector<std::pair<std::string, figures::Drawing>> figures;  ///< Name without ending.
};

/// Makes the folder if it is not there and writes every file, each whole or not at all; figures as
/// SVG, and as PNG where this build can. Prints what it wrote.
///
/// @throws std::logic_error for a file that is not among the outputs of the call.
Result<Done> writeFolder(const CallFiles& files, const std::string& folder,
                         const FolderContent& content);

/// Shows how far long work has come, where standard error is a terminal. False once an end was
/// asked for.
bool showProgress(const char* what, std::size_t done, std::size_t all);

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The options of `perilymph-cli archive`.

#include "Commands.h"

namespace CLI {
class App;
}

namespace perilymph::cli {

class FileOptions;

void addArchive(CLI::App& app, FileOptions& files, ArchiveOptions& options);
Result<void> runArchive(const CLI::App& archive, const ArchiveOptions& options);

}  // namespace perilymph::cli

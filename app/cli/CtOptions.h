// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/foundation/Result.h"

namespace CLI {
class App;
}

namespace perilymph::cli {

class FileOptions;
struct CommandOptions;

/// Declares `ct info`, `ct measure`, `ct contacts`, `ct markups` and `ct export`.
void addCt(CLI::App& app, FileOptions& files, CommandOptions& options);
/// Runs the one that was given.
Result<void> runCt(const CLI::App& ct, const CommandOptions& options);

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definition of the commands on the command line.

#include "CommandFiles.h"
#include "Commands.h"
#include "FileOptions.h"

namespace CLI {
class App;
}

namespace perilymph::cli {

/// Declares all commands and options, and marks the options that name files.
void addCommands(CLI::App& app, FileOptions& files, CommandOptions& options);

/// Runs the parsed command.
Result<void> runCommand(const CLI::App& app, const CommandFiles& files,
                        const CommandOptions& options);

}  // namespace perilymph::cli

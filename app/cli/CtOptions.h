// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace perilymph::cli {

class FileOptions;
struct CommandOptions;

/// Declares `ct info` and `ct measure`.
void addCt(CLI::App& app, FileOptions& files, CommandOptions& options);

}  // namespace perilymph::cli

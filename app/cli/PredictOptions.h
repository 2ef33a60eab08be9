// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace CLI {
class App;
}

namespace perilymph::cli {

class FileOptions;
struct PredictOptions;

/// Declares `predict`.
void addPredict(CLI::App& app, FileOptions& files, PredictOptions& options);

}  // namespace perilymph::cli

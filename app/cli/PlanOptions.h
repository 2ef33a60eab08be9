// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace perilymph::cli {

class FileOptions;
struct PlanOptions;

/// Largest number of arrays in one plan.
inline constexpr std::size_t maxPlanArrays = 32;

/// Names of the files of a plan that are written when it is made.
std::vector<std::string> planFiles();

/// Declares `plan`.
void addPlan(CLI::App& app, FileOptions& files, PlanOptions& options);

}  // namespace perilymph::cli

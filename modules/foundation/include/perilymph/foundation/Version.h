// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Version and commit of the build, for results.

#include <string>
#include <vector>

namespace perilymph {

/// Release number, such as "0.1.0".
std::string version();

/// Release number and commit of the build, such as "0.1.0+1a2b3c4d5e6f", followed by
/// " with PERILYMPH_RESOURCES" for each of replacedByEnvironment().
std::string buildId();

/// The environment variables that are set and change results: PERILYMPH_RESOURCES if it names other
/// resources than this build's own, PERILYMPH_SYSTEM_ROOT (recorded devices), fewDraws.
std::vector<std::string> replacedByEnvironment();

/// Set for tests, it lets the programs make plans of fewer and coarser simulations than users are offered.
inline constexpr const char* fewDraws = "PERILYMPH_FEW_DRAWS";

}  // namespace perilymph

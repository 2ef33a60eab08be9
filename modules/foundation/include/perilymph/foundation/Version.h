// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Version and commit of the build, for results.

#include <string>

namespace perilymph {

/// Release number, such as "0.1.0".
std::string version();

/// Release number and commit of the build, such as "0.1.0+1a2b3c4d5e6f".
std::string buildId();

}  // namespace perilymph

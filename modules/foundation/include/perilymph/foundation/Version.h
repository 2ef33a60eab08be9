#pragma once

// Who made this result: the version and the commit of the build.

#include <string>

namespace perilymph {

/// The release, such as "0.1.0".
std::string version();

/// The release and the commit it was built from, such as "0.1.0+1a2b3c4d5e6f".
std::string buildId();

}  // namespace perilymph

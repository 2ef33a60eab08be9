// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The date and time of files.

#include <string>

namespace perilymph {

/// The current time in UTC by ISO 8601, to the second: "2026-05-04T10:15:00Z".
std::string utcNow();

}  // namespace perilymph

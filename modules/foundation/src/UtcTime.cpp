// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/UtcTime.h"

#include <chrono>
#include <ctime>

namespace perilymph {

std::string utcNow()
{
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace perilymph

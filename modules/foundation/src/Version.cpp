// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Version.h"

#include <string_view>

namespace perilymph {

std::string version() { return PERILYMPH_VERSION; }

std::string buildId()
{
  constexpr std::string_view commit = PERILYMPH_COMMIT;
  return commit.empty() ? version() : version() + "+" + std::string(commit);
}

}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Version.h"

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "OwnResources.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph {

std::string version() { return PERILYMPH_VERSION; }

std::string buildId()
{
  constexpr std::string_view commit = PERILYMPH_COMMIT;
  std::string id = commit.empty() ? version() : version() + "+" + std::string(commit);
  for (const std::string& variable : replacedByEnvironment()) id += " with " + variable;
  return id;
}

std::vector<std::string> replacedByEnvironment()
{
  std::vector<std::string> variables;
  std::error_code differ;
  if (!std::filesystem::equivalent(resourceRoot(), ownResourceRoot(), differ))
    variables.emplace_back("PERILYMPH_RESOURCES");
  for (const char* const name : {"PERILYMPH_SYSTEM_ROOT", fewDraws}) {
    const char* const given = std::getenv(name);
    if (given != nullptr && *given != '\0') variables.emplace_back(name);
  }
  return variables;
}

}  // namespace perilymph

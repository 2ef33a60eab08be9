#include "NamedFile.h"

#include "perilymph/foundation/Resources.h"

namespace perilymph::session {

Result<std::filesystem::path> namedFile(std::string_view kind, std::string_view folder,
                                        const std::string& nameOrFile)
{
  const auto found = findByName(kind, folder, nameOrFile);
  if (!found) return found.error();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(*found, ignored))
    return Error{"The " + std::string(kind) + " '" + nameOrFile +
                 "' is a pipe or a device, not a file. Name a shipped one or a TOML file."};
  return *found;
}

}  // namespace perilymph::session

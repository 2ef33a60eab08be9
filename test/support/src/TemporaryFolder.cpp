// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/TemporaryFolder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace perilymph::test {

TemporaryFolder::TemporaryFolder()
{
  std::string name = (std::filesystem::temp_directory_path() / "perilymph-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "No folder could be made as " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
  // A test may have removed permissions; restore them, so that everything can be removed.
  std::error_code ignored;
  namespace fs = std::filesystem;
  fs::permissions(path_, fs::perms::owner_all, fs::perm_options::add, ignored);
  for (fs::recursive_directory_iterator entry(path_, ignored), end; entry != end;
       entry.increment(ignored))
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored))
      fs::permissions(entry->path(), fs::perms::owner_all, fs::perm_options::add, ignored);
  fs::remove_all(path_, ignored);
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/PrivateFiles.h"

#include <sys/stat.h>

#include <filesystem>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::gui {

namespace fs = std::filesystem;

void keepFilesPrivate() { ::umask(S_IRWXG | S_IRWXO); }

void prepareOwnFolders()
{
  std::error_code ignored;  // an error is reported when something is written
  for (const fs::path& folder : {sessionFolder().parent_path(), stateFolder()}) {
    fs::create_directories(folder, ignored);
    fs::permissions(folder, fs::perms::owner_all, ignored);
  }
  for (const fs::path& folder : {sessionFolder(), patientFolder(), stateFolder(), plansFolder(),
                                 fs::temp_directory_path(ignored)})
    removeLeftovers(folder);
  for (const fs::directory_entry& plan : fs::directory_iterator(plansFolder(), ignored))
    if (plan.is_directory(ignored)) removeLeftovers(plan.path());
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/archive/FetchedFolder.h"

#include <system_error>

#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/StateFolder.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t digits = 24;

std::filesystem::path target() { return stateFolder() / "archive" / "series"; }

}  // namespace

FetchedFolder::FetchedFolder()
{
  std::error_code failed;
  if (std::filesystem::is_directory(target().parent_path(), failed))
    removeLeftovers(target().parent_path());
}

Result<std::filesystem::path> FetchedFolder::placeOf(const std::string& seriesUid)
{
  if (!folder_) {
    std::error_code failed;
    std::filesystem::create_directories(target().parent_path(), failed);
    if (failed)
      return Error{"The folder %1 cannot be made: %2.", target().parent_path(), failed.message()};
    auto made = UnfinishedFolder::create(target());
    if (!made) return made.error();
    folder_.emplace(*std::move(made));
  }
  Sha256 hash;
  hash.add(seriesUid);
  return folder_->path() / hash.hex().substr(0, digits);
}

}  // namespace perilymph::gui

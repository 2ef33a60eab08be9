// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where series from an archive are kept.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::gui {

/// A folder that only this user can read. It is removed with what is in it when the program ends;
/// that of a killed program is removed at the next start.
class FetchedFolder {
public:
  FetchedFolder();

  /// The folder of a series, named by a digest of its UID. It exists where the series was retrieved.
  Result<std::filesystem::path> placeOf(const std::string& seriesUid);

private:
  std::optional<UnfinishedFolder> folder_;
};

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of files and folders that are not finished, so that nothing is written over, and what a
// killed program left is found and removed by the next one.

#include <filesystem>
#include <utility>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// A path beside a file or folder for its content until it is whole:
/// ".study.HOST-1234.7.part.sqlite" with the machine, the process and a number. No call of this
/// process gets it again; its user creates it exclusively.
std::filesystem::path unfinishedPath(const std::filesystem::path& target);

/// Gives an unfinished file its final name, unless there is something of that name: what is there is
/// never replaced. @return 0 or an error number, EEXIST for a name that is taken.
int giveNewName(const std::filesystem::path& unfinished,
                const std::filesystem::path& target) noexcept;

/// Removes unfinished files and folders, with the companions of SQLite, that processes of this
/// machine and user left in a folder and that have ended. Links are not followed.
void removeLeftovers(const std::filesystem::path& folder) noexcept;

/// A new folder beside its target, for its owner only (mode 0700); removed with what is in it unless
/// it is finished.
class UnfinishedFolder {
public:
  /// Removes leftovers beside the target first.
  static Result<UnfinishedFolder> create(const std::filesystem::path& target);
  UnfinishedFolder(UnfinishedFolder&& other) noexcept;
  UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;
  ~UnfinishedFolder();

  const std::filesystem::path& path() const noexcept { return path_; }
  /// Gives it the name of its target. Refuses one that exists.
  Result<void> finish();

private:
  UnfinishedFolder(std::filesystem::path path, std::filesystem::path target)
      : path_(std::move(path)), target_(std::move(target))
  {
  }
  std::filesystem::path path_, target_;  // the first is empty once it is finished
};

}  // namespace perilymph

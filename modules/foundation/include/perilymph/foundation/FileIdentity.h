// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether two paths name the same file.

#include <cstdint>
#include <filesystem>

namespace perilymph {

/// The file that a path names, whether or not it exists yet.
struct FileIdentity {
  std::filesystem::path place;  ///< Absolute, every symbolic link followed.
  std::uint64_t device = 0;     ///< Device and inode of an existing file; both 0 if there is none.
  std::uint64_t inode = 0;
};

/// The identity of a file, with all symbolic links resolved, even if the target does not exist yet.
FileIdentity identityOf(const std::filesystem::path& file);

/// True for two spellings of one path, for a link and its target, and for two hard links.
bool isSameFile(const FileIdentity& one, const FileIdentity& other);

/// True for a file that exists somewhere in a folder.
bool isExistingBelow(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace perilymph

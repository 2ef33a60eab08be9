// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A lock between programs, as a file that exists while one of them holds it.

#include <chrono>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// A lock that is held for the lifetime of this object. It ends with the process, however that ends,
/// and its file disappears with it, or with the next one that takes it.
class FileLock {
public:
  /// Takes a lock, after waiting at most two seconds.
  ///
  /// @param file  The lock's own file, never one with content.
  /// @param what  What is locked, for the message: "P-017-left.toml".
  /// @return      Refuses a lock that another program or another part of this one holds.
  static Result<FileLock> take(const std::filesystem::path& file, const std::string& what);
  /// Takes a lock, after waiting for as long as others hold it; returns an error once `stop` is requested.
  static Result<FileLock> takeWhenFree(const std::filesystem::path& file, const std::string& what,
                                       const std::stop_token& stop);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

private:
  /// @param isOver  Whether to wait no longer; called after each attempt.
  static Result<FileLock> take(const std::filesystem::path& file, const std::string& what,
                               std::chrono::milliseconds pause,
                               const std::function<bool()>& isOver);
  FileLock(int descriptor, std::filesystem::path file)
      : descriptor_(descriptor), file_(std::move(file))
  {
  }

  int descriptor_ = -1;
  std::filesystem::path file_;
};

}  // namespace perilymph

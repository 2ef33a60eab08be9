// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of the files being written, for a signal handler.

#include <filesystem>

namespace perilymph {

/// The name of a file being written, registered during the lifetime of this object. Thread-safe; at
/// most sixteen names are registered at a time, further ones are ignored.
class UnfinishedName {
public:
  UnfinishedName() = default;
  ~UnfinishedName();
  UnfinishedName(const UnfinishedName&) = delete;
  UnfinishedName& operator=(const UnfinishedName&) = delete;

  /// Replaces the registered name.
  void keep(const std::filesystem::path& file);

  /// Removes all registered files. Async-signal-safe.
  static void removeAll() noexcept;

private:
  struct Slot;
  Slot* slot_ = nullptr;
};

}  // namespace perilymph

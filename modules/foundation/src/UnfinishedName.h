#pragma once

// Files that are being written, as a signal handler finds them.

#include <filesystem>

namespace perilymph {

/// The name of a file that is being written; kept as long as this object lives. Up to sixteen files
/// may be written at a time, by any threads; of more, the names are not kept.
class UnfinishedName {
public:
  UnfinishedName() = default;
  ~UnfinishedName();
  UnfinishedName(const UnfinishedName&) = delete;
  UnfinishedName& operator=(const UnfinishedName&) = delete;

  /// Keeps this name in place of the one before.
  void keep(const std::filesystem::path& file);

  /// Removes every file whose name is kept. Safe in a signal handler.
  static void removeAll() noexcept;

private:
  struct Slot;
  Slot* slot_ = nullptr;
};

}  // namespace perilymph

#pragma once

// Keys of text files and recordings that had another name in earlier versions.

#include <functional>
#include <string>
#include <string_view>

namespace perilymph {

/// Today's name of a key; the key itself where it was never renamed. Until version 1.0 every reader
/// takes both names.
std::string_view currentKey(std::string_view key) noexcept;

/// A key that a file gives under its old name.
struct RenamedKeyUse {
  std::string place;  ///< File and line, to begin a sentence: "my.toml:7: ".
  std::string path;   ///< The key as it is given, with its tables: "capability.most_force_N".
  std::string now;    ///< Today's name of its last part.

  /// One sentence: where, which key, what to write instead.
  std::string warning() const;
};

/// Receives each warning once per process, from any thread, one call at a time.
using WarningHandler = std::function<void(const std::string& warning)>;

/// Sets where warnings go, those given earlier included. Without a handler they are kept.
void setWarningHandler(WarningHandler handler);

/// Passes a warning on, unless the same one was given before.
void warn(const std::string& warning);

}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of text files and recordings that were renamed since an earlier version.

#include <functional>
#include <string>
#include <string_view>

namespace perilymph {

/// Current name of a key; the key itself if it was never renamed. Until version 1.0 every reader
/// accepts both names.
std::string_view currentKey(std::string_view key) noexcept;

/// A use of a key's old name in a file.
struct RenamedKeyUse {
  std::string place;  ///< File and line, to begin a sentence: "my.toml:7: ".
  std::string path;   ///< The key as written, with its tables: "capability.most_force_N".
  std::string now;    ///< Current name of its last part.

  /// One sentence: the place, the key and its replacement.
  std::string warning() const;
};

/// Receives each warning once per process, from any thread, one call at a time.
using WarningHandler = std::function<void(const std::string& warning)>;

/// Sets the receiver of warnings, including those issued earlier. Without a handler they are kept.
void setWarningHandler(WarningHandler handler);

/// Issues a warning, unless the same one was issued before.
void warn(const std::string& warning);

}  // namespace perilymph

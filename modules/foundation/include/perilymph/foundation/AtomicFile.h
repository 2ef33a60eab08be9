// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Atomic file writing: a file appears complete or not at all.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// What becomes of a symbolic link in the place of a file.
enum class Links {
  followed,  ///< It is kept and its target is written: for a file that a user names.
  refused,   ///< Nothing is written: for the files of a folder that a program fills.
};

/// Who may read a new file.
enum class Audience {
  everyone,  ///< Whom the user's umask allows; a file that is replaced keeps its permissions.
  owner,     ///< Its owner only (mode 0600): what may name or describe a patient.
};

/// What becomes of a file that exists.
enum class Existing { replaced, refused };

/// How a file is written.
struct Writing {
  Links links = Links::followed;
  Audience audience = Audience::everyone;
  Existing existing = Existing::replaced;
};

/// Checks, before any work is done, that a file can be written: its folder exists and is writable,
/// and the file is neither a folder nor read-only nor a link that is refused.
Result<void> checkWritable(const std::filesystem::path& file, Links links = Links::followed);

/// Writes a file atomically: first into a temporary file in the same folder (unfinishedPath()), which
/// is then renamed. On failure nothing is left behind and an existing file is unchanged; a read-only
/// file is never replaced.
Result<void> writeWhole(const std::filesystem::path& file, std::string_view content,
                        const Writing& how = {});

/// The same for content that a library writes (pictures, surfaces): `write` receives the path of
/// the temporary file, which has the same extension, and returns true on success.
Result<void> writeWhole(const std::filesystem::path& file,
                        const std::function<bool(const std::filesystem::path&)>& write,
                        const Writing& how = {});

/// Removes the temporary files of all writes in progress, before a signal ends the process.
/// Async-signal-safe.
void removeUnfinishedFiles() noexcept;

/// Maximum size of a text file that is read [bytes].
inline constexpr std::size_t maxTextBytes = std::size_t{16} << 20;

/// Reads a whole file. Refuses pipes, devices, folders and files larger than `maxBytes`. Never
/// blocks on another program.
Result<std::string> readWhole(const std::filesystem::path& file,
                              std::size_t maxBytes = maxTextBytes);

}  // namespace perilymph

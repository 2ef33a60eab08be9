#pragma once

// Files that appear whole or not at all.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// Whether a file could be written, asked before the work that fills it: its folder exists and may
/// be written to, and the file is no folder and not read-only.
Result<Done> checkWritable(const std::filesystem::path& file);

/// Writes a file so that it appears whole or not at all: into a neighbor first, then renamed over
/// the place. On failure nothing is left behind and an older file stays as it was;
/// a read-only one is never replaced.
Result<Done> writeWhole(const std::filesystem::path& file, std::string_view content);

/// The same for content that a library writes by itself (pictures, surfaces): `write` is given the
/// neighbor's path, with the same extension, and says whether it succeeded.
Result<Done> writeWhole(const std::filesystem::path& file,
                        const std::function<bool(const std::filesystem::path&)>& write);

/// Removes the neighbors of all files that are being written, before the process is ended by a
/// signal. May be called from a signal handler.
void removeUnfinishedFiles() noexcept;

/// Size up to which text files are read.
inline constexpr std::size_t maxTextBytes = std::size_t{16} << 20;

/// Reads a whole file. Pipes, devices and folders are refused, and so is what is larger than
/// `maxBytes`; it never waits for another program.
Result<std::string> readWhole(const std::filesystem::path& file,
                              std::size_t maxBytes = maxTextBytes);

}  // namespace perilymph

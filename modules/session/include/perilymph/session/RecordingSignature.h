// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recognition of a recording without opening it.

#include <array>
#include <filesystem>
#include <string_view>

namespace perilymph::session {

/// Suffixes of the files that SQLite creates beside a recording.
inline constexpr std::array<std::string_view, 3> recordingCompanions = {"-wal", "-journal", "-shm"};

/// True for an existing file that is a recording or belongs to one: its name ends with
/// `.insertion`, or its SQLite header has the application id of recordings, or it is the `-wal`,
/// `-journal` or `-shm` file of such a file.
bool isRecording(const std::filesystem::path& file);

}  // namespace perilymph::session

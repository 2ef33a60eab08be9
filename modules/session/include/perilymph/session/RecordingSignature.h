#pragma once

// How a recording is recognized without opening it.

#include <array>
#include <filesystem>
#include <string_view>

namespace perilymph::session {

/// What SQLite appends to a recording's name for the files beside it.
inline constexpr std::array<std::string_view, 3> recordingCompanions = {"-wal", "-journal", "-shm"};

/// True for an existing file that is a recording or belongs to one: it ends in `.insertion`, or its
/// SQLite header carries the application id of recordings, or it is the `-wal`, `-journal` or
/// `-shm` file of such a file.
bool isRecording(const std::filesystem::path& file);

}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/RecordingSignature.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "perilymph/foundation/FileIdentity.h"
#include "recording/RecordingFormat.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// Reads SQLite's header (its file format, section 1.3): the magic text in bytes 0 to 15, the
/// application id, big-endian, in bytes 68 to 71.
bool hasRecordingHeader(const fs::path& file)
{
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  std::array<unsigned char, 72> bytes{};
  const ssize_t count = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  ::close(descriptor);
  constexpr std::string_view magic("SQLite format 3\0", 16);
  if (count != static_cast<ssize_t>(bytes.size()) ||
      std::string_view(reinterpret_cast<const char*>(bytes.data()), magic.size()) != magic)
    return false;
  std::int64_t id = 0;
  for (std::size_t i = 68; i < bytes.size(); ++i) id = id << 8 | bytes[i];
  return id == recordingKind().applicationId;
}

bool isRecordingItself(const fs::path& place)
{
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) return false;
  return place.extension() == ".insertion" || hasRecordingHeader(place);
}

}  // namespace

bool isRecording(const fs::path& file)
{
  const fs::path place = identityOf(file).place;
  if (isRecordingItself(file) || isRecordingItself(place)) return true;
  std::error_code ignored;
  if (!fs::is_regular_file(place, ignored)) return false;
  const std::string name = place.string();
  return std::any_of(recordingCompanions.begin(), recordingCompanions.end(), [&](auto ending) {
    return name.ends_with(ending) && isRecordingItself(name.substr(0, name.size() - ending.size()));
  });
}

}  // namespace perilymph::session

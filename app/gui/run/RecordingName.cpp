// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/RecordingName.h"

#include <cstdio>
#include <ctime>
#include <system_error>

#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

/// "20260131T154502Z": sorts by time and is a valid file name on all systems.
std::string utcNow()
{
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[24];
  std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &utc);
  return text;
}

std::filesystem::path numbered(const std::filesystem::path& file, int number)
{
  if (number < 2) return file;
  std::filesystem::path other = file;
  other.replace_filename(file.stem().string() + "-" + std::to_string(number) +
                         file.extension().string());
  return other;
}

/// The first of its names, from a number on, that no file has.
std::filesystem::path firstFree(const std::filesystem::path& file, int number)
{
  std::error_code ignored;
  while (std::filesystem::exists(numbered(file, number), ignored)) ++number;
  return numbered(file, number);
}

}  // namespace

std::filesystem::path newRecording(const std::string& scenario)
{
  return firstFree(sessionFolder() / (utcNow() + "-" + scenario + ".insertion"), 1);
}

std::filesystem::path besides(const std::filesystem::path& recording)
{
  return firstFree(recording, 2);
}

}  // namespace perilymph::gui

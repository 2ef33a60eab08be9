// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/CrashMarker.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <tuple>

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr auto prefix = "running-";

fs::path markOf(const fs::path& folder, long process)
{
  return folder / (prefix + std::to_string(process));
}

/// The process id of a marker; 0 if it is invalid.
long processOf(const fs::path& mark)
{
  const std::string name = mark.filename().string();
  if (name.rfind(prefix, 0) != 0) return 0;
  char* end = nullptr;
  const long process = std::strtol(name.c_str() + std::string(prefix).size(), &end, 10);
  return end != nullptr && *end == '\0' && process > 0 ? process : 0;
}

/// Whether a process exists and is this program; its id may have been reused.
bool isThisProgram(long process)
{
  if (::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) return false;
  std::error_code unknown;
  const fs::path theirs = fs::read_symlink("/proc/" + std::to_string(process) + "/exe", unknown);
  if (unknown) return true;  // a process of another user: unknown
  const fs::path ours = fs::read_symlink("/proc/self/exe", unknown);
  return !unknown && theirs.filename() == ours.filename();
}

}  // namespace

CrashMarker::CrashMarker(const fs::path& folder) : file_(markOf(folder, ::getpid()))
{
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  setRecording(std::nullopt);
}

CrashMarker::~CrashMarker()
{
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void CrashMarker::setRecording(const std::optional<fs::path>& recording)
{
  // an unwritten marker only means no recovery after a crash
  std::ignore = writeWhole(file_, (recording ? recording->string() : std::string()) + "\n");
}

std::vector<fs::path> CrashMarker::takeCrashed(const fs::path& folder)
{
  std::vector<fs::path> recordings;
  std::vector<fs::path> stale;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const long process = processOf(entry.path());
    if (process != 0 && !isThisProgram(process)) stale.push_back(entry.path());
  }
  for (const fs::path& mark : stale) {
    const Result<std::string> text = readWhole(mark);
    fs::remove(mark, ignored);
    if (!text) continue;
    const fs::path recording = text->substr(0, text->find('\n'));
    if (!recording.empty() && fs::is_regular_file(recording, ignored))
      recordings.push_back(recording);
  }
  return recordings;
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/FileLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace perilymph {

namespace {

constexpr std::chrono::milliseconds patience{2000}, shortPause{1}, longPause{50};

/// Whether a descriptor is of the file that has this name now: whoever held the lock before may have
/// removed it.
bool isStillNamed(int descriptor, const std::filesystem::path& file)
{
  struct stat held {
  }, named{};
  return ::fstat(descriptor, &held) == 0 && ::lstat(file.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace

Result<FileLock> FileLock::take(const std::filesystem::path& file, const std::string& what)
{
  const auto end = std::chrono::steady_clock::now() + patience;
  return take(file, what, shortPause, [&] { return std::chrono::steady_clock::now() > end; });
}

Result<FileLock> FileLock::takeWhenFree(const std::filesystem::path& file, const std::string& what,
                                        const std::stop_token& stop)
{
  return take(file, what, longPause, [&] { return stop.stop_requested(); });
}

Result<FileLock> FileLock::take(const std::filesystem::path& file, const std::string& what,
                                std::chrono::milliseconds pause,
                                const std::function<bool()>& isOver)
{
  while (true) {
    const int descriptor =
        ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0600);
    if (descriptor < 0)
      return Error{
          "%1 cannot be locked: %2. Check the folder's permissions and the space on the disk.",
          what, std::strerror(errno)};
    const bool isHeld = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const int failure = errno;
    if (isHeld && isStillNamed(descriptor, file)) return FileLock(descriptor, file);
    ::close(descriptor);
    if (!isHeld && failure != EWOULDBLOCK && failure != EINTR)
      return Error{"%1 cannot be locked: %2. Copy its folder to another disk.", what,
                   std::strerror(failure)};
    if (isOver())
      return Error{"%1 is in use: another program works on it. Wait until it has ended.", what};
    std::this_thread::sleep_for(pause);
  }
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), file_(std::move(other.file_))
{
}

FileLock::~FileLock()
{
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());  // before the lock ends: afterwards it may be another's
  ::close(descriptor_);
}

}  // namespace perilymph

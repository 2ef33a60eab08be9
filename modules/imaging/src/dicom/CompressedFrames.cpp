// SPDX-License-Identifier: BSD-3-Clause
#include "CompressedFrames.h"

#include <fcntl.h>
#include <gdcmImage.h>
#include <gdcmImageReader.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <optional>

namespace perilymph::imaging {
namespace {

constexpr std::chrono::seconds timeLimit{60};
constexpr int pollInterval_ms = 100;

std::optional<StoredType> typeOf(const gdcm::PixelFormat& format)
{
  const bool isSigned = format.GetPixelRepresentation() == 1;
  switch (format.GetBitsAllocated()) {
    case 8:
      return isSigned ? StoredType::int8 : StoredType::uint8;
    case 16:
      return isSigned ? StoredType::int16 : StoredType::uint16;
    case 32:
      return isSigned ? StoredType::int32 : StoredType::uint32;
    default:
      return std::nullopt;
  }
}

/// Memory that a process and its child see alike.
class SharedMemory {
public:
  explicit SharedMemory(std::size_t bytes)
      : size_(bytes),
        start_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
  }
  ~SharedMemory()
  {
    if (isThere()) ::munmap(start_, size_);
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  bool isThere() const { return start_ != MAP_FAILED; }
  std::byte* start() const { return static_cast<std::byte*>(start_); }

private:
  std::size_t size_;
  void* start_;
};

/// Type of the values in `bytes` after decoding; none where the file is not what its header says.
std::optional<StoredType> decodeInto(const DicomHeader& header, std::span<std::byte> bytes)
{
  gdcm::ImageReader reader;
  reader.SetFileName(header.file.c_str());
  if (!reader.Read()) return std::nullopt;
  const gdcm::Image& image = reader.GetImage();
  if (image.GetPixelFormat().GetSamplesPerPixel() != 1 || image.GetBufferLength() != bytes.size() ||
      image.GetPixelFormat().GetBitsAllocated() != header.bitsAllocated ||
      image.GetNumberOfDimensions() < 2 ||
      image.GetDimension(0) != static_cast<unsigned>(header.columns) ||
      image.GetDimension(1) != static_cast<unsigned>(header.rows) ||
      !image.GetBuffer(reinterpret_cast<char*>(bytes.data())))
    return std::nullopt;
  return typeOf(image.GetPixelFormat());
}

constexpr int failed = 100;  // status of a child that could not decode; below it, the type

/// The child: decodes without a word and without a core file, and ends.
[[noreturn]] void runChild(const DicomHeader& header, std::span<std::byte> bytes)
{
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  int status = failed;
  try {
    if (const auto type = decodeInto(header, bytes)) status = static_cast<int>(*type);
  } catch (...) {
    status = failed;
  }
  ::_exit(status);
}

/// Exit status of a child, whose end closes the pipe; `failed` where it had to be killed, was ended
/// by a signal, or cannot be asked.
int statusOf(::pid_t child, int pipe, const std::function<bool()>& isCanceled)
{
  const auto start = std::chrono::steady_clock::now();
  pollfd watched = {pipe, POLLIN, 0};
  int status = 0;
  ::pid_t ended = 0;
  while (ended == 0 && std::chrono::steady_clock::now() - start < timeLimit) {
    if (isCanceled && isCanceled()) break;
    // Another process may hold the pipe open, so that its silence says nothing.
    const bool isClosed = ::poll(&watched, 1, pollInterval_ms) > 0;
    ended = ::waitpid(child, &status, isClosed ? 0 : WNOHANG);
    if (ended < 0 && errno == EINTR) ended = 0;
  }
  if (ended == child) return WIFEXITED(status) ? WEXITSTATUS(status) : failed;
  if (ended == 0) {
    ::kill(child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  }
  return failed;
}

}  // namespace

bool decodeCompressed(const DicomHeader& header, const std::function<bool()>& isCanceled,
                      const std::function<void(StoredType, std::span<const std::byte>)>& use)
{
  const std::size_t size = static_cast<std::size_t>(header.rows) *
                           static_cast<std::size_t>(header.columns) * header.frames.size() *
                           (static_cast<std::size_t>(header.bitsAllocated) / 8);
  std::array<int, 2> ends{};
  if (size == 0 || size > 4 * maxDecodedVoxels) return false;
  const SharedMemory memory(size);
  if (!memory.isThere() || ::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
  const std::span<std::byte> bytes(memory.start(), size);
  const ::pid_t child = ::fork();
  if (child == 0) runChild(header, bytes);
  ::close(ends[1]);
  const int status = child > 0 ? statusOf(child, ends[0], isCanceled) : failed;
  ::close(ends[0]);
  if (status >= failed) return false;
  use(static_cast<StoredType>(status), bytes);
  return true;
}

}  // namespace perilymph::imaging

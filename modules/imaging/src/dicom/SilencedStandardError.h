#pragma once

// Libraries that print to standard error whatever they are told.

#include <fcntl.h>
#include <unistd.h>

namespace perilymph::imaging {

/// While it lives, nothing of this process reaches standard error: decoders of JPEG and JPEG 2000
/// print there what they think of a file. Kept as short as a file's decoding.
class SilencedStandardError {
public:
  SilencedStandardError() : kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3))
  {
    const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nothing >= 0) ::dup2(nothing, STDERR_FILENO);
    if (nothing >= 0) ::close(nothing);
  }
  ~SilencedStandardError()
  {
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  SilencedStandardError(const SilencedStandardError&) = delete;
  SilencedStandardError& operator=(const SilencedStandardError&) = delete;

private:
  int kept_;
};

}  // namespace perilymph::imaging

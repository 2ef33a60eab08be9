#include "ReportBell.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace perilymph::hidstack {

Result<Done> ReportBell::open(const std::string& node)
{
  close();
  file_ = ::open(node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return Error{node + " could not be opened: " + std::strerror(errno) + "."};
  return Done{};
}

void ReportBell::close() noexcept
{
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

ReportBell::Ring ReportBell::wait(int milliseconds) noexcept
{
  pollfd wait{file_, POLLIN, 0};
  if (::poll(&wait, 1, milliseconds) <= 0) return Ring::none;
  if ((wait.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0) return Ring::gone;
  std::array<unsigned char, 64> report;
  while (::read(file_, report.data(), report.size()) > 0) {
  }
  return errno == EAGAIN ? Ring::report : Ring::gone;
}

}  // namespace perilymph::hidstack

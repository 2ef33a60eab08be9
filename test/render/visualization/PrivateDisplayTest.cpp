// SPDX-License-Identifier: BSD-3-Clause
#include "PrivateDisplay.h"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

namespace perilymph::visualization {
namespace {

/// Whether a client can connect to the display that DISPLAY names.
bool connects()
{
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

/// Whether a child process, as another user, can read a file.
bool canOthersRead(const std::string& file)
{
  constexpr uid_t nobody = 65534;
  const pid_t child = fork();
  if (child == 0) {
    if (setuid(nobody) != 0) _exit(2);
    _exit(open(file.c_str(), O_RDONLY) >= 0 ? 1 : errno == EACCES ? 0 : 2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) < 2);
  return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

TEST(PrivateDisplay, IsOpenToWhoHasItsCookie)
{
  const char* const before = std::getenv("DISPLAY");
  const std::string name = before != nullptr ? before : "";
  {
    const auto display = PrivateDisplay::start();
    ASSERT_TRUE(display) << display.error().message;
    EXPECT_STRNE(std::getenv("DISPLAY"), name.c_str());
    EXPECT_TRUE(connects());
    const std::string cookie = std::getenv("XAUTHORITY");
    for (const char* none : {"/dev/null", "/no/such/file"}) {
      setenv("XAUTHORITY", none, 1);
      EXPECT_FALSE(connects()) << none;
    }
    setenv("XAUTHORITY", cookie.c_str(), 1);
    EXPECT_TRUE(connects());
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), before);
}

TEST(PrivateDisplay, ShowsItsCookieToNoOtherUser)
{
  if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  const auto display = PrivateDisplay::start();
  ASSERT_TRUE(display) << display.error().message;
  std::string cookie = std::getenv("XAUTHORITY");
  const std::string self = "/proc/self";
  ASSERT_EQ(cookie.substr(0, self.size()), self);
  cookie.replace(0, self.size(), "/proc/" + std::to_string(getpid()));
  EXPECT_EQ(access(cookie.c_str(), R_OK), 0);
  EXPECT_FALSE(canOthersRead(cookie));
}

}  // namespace
}  // namespace perilymph::visualization

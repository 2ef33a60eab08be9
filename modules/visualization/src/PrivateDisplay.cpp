// SPDX-License-Identifier: BSD-3-Clause
#include "PrivateDisplay.h"

#include <GL/glx.h>
#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

extern char** environ;

namespace perilymph::visualization {
namespace {

constexpr int startTimeout_ms = 10000;

/// Reads the display number that Xvfb writes when it is ready; empty if it does not.
std::string readDisplayNumber(int pipe)
{
  std::string number;
  for (;;) {
    pollfd waiting{pipe, POLLIN, 0};
    char letter = 0;
    if (poll(&waiting, 1, startTimeout_ms) <= 0 || read(pipe, &letter, 1) != 1) return {};
    if (letter == '\n') return number;
    number += letter;
  }
}

void stop(pid_t server)
{
  kill(server, SIGTERM);
  waitpid(server, nullptr, 0);
}

bool sawError = false;
int noteError(Display*, XErrorEvent*)
{
  sawError = true;
  return 0;
}

/// Tries to create an OpenGL 3.2 context, which VTK needs.
bool offersOpenGl(Display* display)
{
  const auto createContext = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
      glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  if (createContext == nullptr || !glXQueryExtension(display, nullptr, nullptr)) return false;
  const int wanted[] = {GLX_X_RENDERABLE, True, GLX_RENDER_TYPE, GLX_RGBA_BIT, 0};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (configs == nullptr) return false;

  bool works = false;
  if (count > 0) {
    const int version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, 0};
    sawError = false;
    const auto before = XSetErrorHandler(noteError);
    const GLXContext context = createContext(display, configs[0], nullptr, True, version);
    XSync(display, False);
    XSetErrorHandler(before);
    works = context != nullptr && !sawError;
    if (context != nullptr) glXDestroyContext(display, context);
  }
  XFree(configs);
  return works;
}

}  // namespace

Result<PrivateDisplay> PrivateDisplay::start()
{
  int ends[2];
  if (pipe(ends) != 0)
    return Error{"No display, and no pipe for a private one. Close other programs."};
  const std::string writeEnd = std::to_string(ends[1]);
  const char* text[] = {"Xvfb",      "-displayfd", writeEnd.c_str(), "-screen", "0", "1280x1024x24",
                        "-nolisten", "tcp",        nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t server = 0;
  const int failed =
      posix_spawnp(&server, "Xvfb", &actions, nullptr, const_cast<char**>(text), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) {
    close(ends[0]);
    return Error{
        "There is no display to draw with, and Xvfb, which could stand in for one, is not "
        "installed. Install the package xvfb or set DISPLAY."};
  }
  const std::string number = readDisplayNumber(ends[0]);
  close(ends[0]);
  if (number.empty()) {
    stop(server);
    return Error{
        "There is no display to draw with, and Xvfb did not start within 10 s. Try "
        "`Xvfb -displayfd 1` by hand or set DISPLAY."};
  }
  const char* name = std::getenv("DISPLAY");
  std::optional<std::string> before;
  if (name != nullptr) before = name;
  setenv("DISPLAY", (":" + number).c_str(), 1);
  return PrivateDisplay(server, std::move(before));
}

PrivateDisplay::PrivateDisplay(PrivateDisplay&& other) noexcept
    : server_(std::exchange(other.server_, 0)), before_(std::move(other.before_))
{
}

PrivateDisplay::~PrivateDisplay()
{
  if (server_ == 0) return;
  stop(server_);
  if (before_)
    setenv("DISPLAY", before_->c_str(), 1);
  else
    unsetenv("DISPLAY");
}

Result<Done> probeDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0')
    return Error{"There is no display to draw with: DISPLAY is not set."};
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
    return Error{"The display " + std::string(name) +
                 " does not answer. Check DISPLAY and that its server is running."};
  const bool works = offersOpenGl(display);
  XCloseDisplay(display);
  if (!works)
    return Error{"The display " + std::string(name) +
                 " offers no OpenGL 3.2. Install Mesa's drivers (libgl1-mesa-dri) or use another."};
  return Done{};
}

}  // namespace perilymph::visualization

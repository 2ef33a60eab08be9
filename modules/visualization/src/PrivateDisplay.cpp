// SPDX-License-Identifier: BSD-3-Clause
#include "PrivateDisplay.h"

#include <GL/glx.h>
#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "perilymph/foundation/Program.h"

namespace perilymph::visualization {
namespace {

constexpr int startTimeout_ms = 10000;
constexpr int numberThere = 3, cookieThere = 4;  // descriptors of the server
constexpr int statusNotFound = 127;              // of setpriv, if there is no such program

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

/// Ends the server. @return its exit status; -1 if a signal ended it.
int stop(pid_t server)
{
  kill(server, SIGTERM);
  int status = 0;
  while (waitpid(server, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// A file in memory with a new random cookie, as Xau(3) writes it: any address, any display. -1 if
/// there can be none.
int newCookie()
{
  unsigned char random[16];
  if (getrandom(random, sizeof random, 0) != sizeof random) return -1;
  std::string entry("\xff\xff", 2);
  const auto add = [&entry](const std::string& field) {
    entry += {static_cast<char>(field.size() >> 8), static_cast<char>(field.size())};
    entry += field;
  };
  for (const std::string& field : {std::string(), std::string(), std::string("MIT-MAGIC-COOKIE-1"),
                                   std::string(std::begin(random), std::end(random))})
    add(field);
  const int file = memfd_create("perilymph cookie", MFD_CLOEXEC);
  if (file < 0 || write(file, entry.data(), entry.size()) == static_cast<ssize_t>(entry.size()))
    return file;
  close(file);
  return -1;
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
  const int cookie = newCookie();
  int ends[2];
  if (cookie < 0 || pipe2(ends, O_CLOEXEC) != 0) {
    close(cookie);
    return Error{
        "There is no display to draw with, and no file could be opened for a private one. Close "
        "other programs."};
  }
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  // setpriv (util-linux) asks the kernel to end the server with the thread that starts it.
  const auto server =
      startProgram({"setpriv",
                    {"--pdeathsig", "TERM", "Xvfb", "-displayfd", std::to_string(numberThere),
                     "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-auth",
                     "/proc/self/fd/" + std::to_string(cookieThere)},
                    {{nowhere, STDERR_FILENO}, {ends[1], numberThere}, {cookie, cookieThere}},
                    false});
  close(nowhere);
  close(ends[1]);
  const std::string number = server ? readDisplayNumber(ends[0]) : "";
  close(ends[0]);
  if (number.empty()) {
    close(cookie);
    if (!server || stop(*server) == statusNotFound)
      return Error{
          "There is no display to draw with, and Xvfb, which could stand in for one, is not "
          "installed. Install the package xvfb or set DISPLAY."};
    return Error{
        "There is no display to draw with, and Xvfb did not start within 10 s. Try "
        "`Xvfb -displayfd 1` by hand or set DISPLAY."};
  }
  std::vector<Variable> before;
  const std::string cookieFile = "/proc/self/fd/" + std::to_string(cookie);
  for (const auto& [name, value] :
       {std::pair{"DISPLAY", ":" + number}, std::pair{"XAUTHORITY", cookieFile}}) {
    const char* const old = std::getenv(name);
    before.emplace_back(name, old != nullptr ? std::optional<std::string>(old) : std::nullopt);
    setenv(name, value.c_str(), 1);
  }
  return PrivateDisplay(*server, cookie, std::move(before));
}

PrivateDisplay::PrivateDisplay(PrivateDisplay&& other) noexcept
    : server_(std::exchange(other.server_, 0)),
      cookie_(other.cookie_),
      before_(std::move(other.before_))
{
}

PrivateDisplay::~PrivateDisplay()
{
  if (server_ == 0) return;
  stop(server_);
  close(cookie_);
  for (const auto& [name, value] : before_) {
    if (value)
      setenv(name, value->c_str(), 1);
    else
      unsetenv(name);
  }
}

Result<void> probeDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0')
    return Error{"There is no display to draw with: DISPLAY is not set."};
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
    return Error{"The display %1 does not answer. Check DISPLAY and that its server is running.",
                 std::string(name)};
  const bool works = offersOpenGl(display);
  XCloseDisplay(display);
  if (!works)
    return Error{
        "The display %1 offers no OpenGL 3.2. Install Mesa's drivers (libgl1-mesa-dri) or use "
        "another.",
        std::string(name)};
  return {};
}

}  // namespace perilymph::visualization

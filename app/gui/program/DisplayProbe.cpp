// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/DisplayProbe.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <cstdlib>
#include <string>

// After Qt's headers: X11 defines None, Bool and others as macros.
#include <X11/Xlib.h>

namespace perilymph::gui {

namespace {

std::string environment(const char* name)
{
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

Result<void> probeDisplay()
{
  const std::string platform = environment("QT_QPA_PLATFORM");
  if (!platform.empty() && platform != "xcb" && platform != "offscreen")
    return Error{
        "QT_QPA_PLATFORM is %1; the window can be drawn with xcb or offscreen. Unset it, or use "
        "one of these.",
        platform};

  const std::string display = environment("DISPLAY");
  if (display.empty())
    return Error{
        "There is no display: DISPLAY is not set. Start perilymph in a graphical session, or under "
        "xvfb-run; perilymph-cli simulates without a window."};

  Display* connection = XOpenDisplay(display.c_str());
  if (connection == nullptr)
    return Error{
        "The display %1 cannot be reached. Check DISPLAY and the permission to draw there, or "
        "start perilymph under xvfb-run.",
        display};
  // VTK draws only through GLX; without it Qt would use EGL, and all pictures would stay empty.
  int opcode = 0, event = 0, error = 0;
  const bool hasGlx = XQueryExtension(connection, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay(connection);
  if (!hasGlx)
    return Error{
        "The display %1 offers no OpenGL (its GLX extension is missing). Start perilymph on "
        "another display, or under xvfb-run; perilymph-cli simulates without a window.",
        display};
  return {};
}

Result<void> probeOpenGl()
{
  const QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
  const std::string advice =
      " The window needs OpenGL 3.2: install a graphics driver (Debian: libgl1-mesa-dri), or set "
      "LIBGL_ALWAYS_SOFTWARE=1 to draw without a graphics card.";

  QOpenGLContext context;
  context.setFormat(wanted);
  if (!context.create()) return Error{"OpenGL cannot be started on this display.%1", advice};

  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface))
    return Error{"OpenGL cannot draw on this display.%1", advice};
  const QSurfaceFormat got = context.format();
  context.doneCurrent();

  if (got.version() < qMakePair(3, 2))
    return Error{"This display offers OpenGL %1.%2.%3", got.majorVersion(), got.minorVersion(),
                 advice};
  return {};
}

bool hasStereoBuffers()
{
  // Qt requests a GLX configuration with GLX_STEREO and reports the result.
  QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
  wanted.setStereo(true);
  QOpenGLContext context;
  context.setFormat(wanted);
  return context.create() && context.format().stereo();
}

QString quadBufferedError(bool hasBuffers)
{
  if (hasBuffers) return {};
  return QCoreApplication::translate("Display", "not supported by this display");
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/RendererName.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <algorithm>
#include <array>
#include <cctype>

namespace perilymph::gui {

bool isSoftwareRenderer(const std::string& renderer)
{
  std::string name = renderer;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  // Mesa's three, and those of Windows and macOS; an unknown renderer is not regarded as a graphics
  // card
  constexpr std::array<const char*, 5> known{"llvmpipe", "softpipe", "swrast", "gdi generic",
                                             "software"};
  return name.empty() || std::any_of(known.begin(), known.end(), [&](const char* one) {
           return name.find(one) != std::string::npos;
         });
}

namespace {

std::string askForRenderer()
{
  QOpenGLContext context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  QOffscreenSurface surface;
  if (!context.create()) return {};
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return {};
  const auto* name = context.functions()->glGetString(GL_RENDERER);
  const std::string renderer = name != nullptr ? reinterpret_cast<const char*>(name) : "";
  context.doneCurrent();
  return renderer;
}

}  // namespace

const std::string& openGlRenderer()
{
  static const std::string renderer = askForRenderer();
  return renderer;
}

}  // namespace perilymph::gui

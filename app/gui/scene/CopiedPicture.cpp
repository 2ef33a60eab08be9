// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/CopiedPicture.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <algorithm>
#include <string>
#include <utility>

namespace perilymph::gui {

CopiedPicture::CopiedPicture(vtkGenericOpenGLRenderWindow& window, std::function<void()> onDrawn)
    : window_(window), onDrawn_(std::move(onDrawn))
{
  context_.setFormat(QSurfaceFormat::defaultFormat());
  if (!context_.create()) return;
  surface_.setFormat(context_.format());
  surface_.create();
  isValid_ = makeCurrent();
  if (!isValid_) return;
  for (const auto event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                           vtkCommand::WindowFrameEvent})
    observers_.push_back(window.AddObserver(event, this, &CopiedPicture::handle));
  window.SetFrameBlitModeToNoBlit();
  window.SetForceMaximumHardwareLineWidth(1);
  window.SetOwnContext(0);
  window.SetReadyForRendering(true);
  window.OpenGLInitContext();
}

CopiedPicture::~CopiedPicture()
{
  if (!isValid_) return;
  makeCurrent();
  window_.Finalize();
  window_.SetReadyForRendering(false);
  for (const unsigned long observer : observers_) window_.RemoveObserver(observer);
  context_.doneCurrent();
}

void CopiedPicture::handle(vtkObject*, unsigned long event, void* data)
{
  if (event == vtkCommand::WindowMakeCurrentEvent) {
    makeCurrent();
  } else if (event == vtkCommand::WindowIsCurrentEvent) {
    *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &context_;
  } else if (window_.GetSwapBuffers() != 0) {
    isDrawn_ = true;
    isCopied_ = false;
    if (!isRequested_) onDrawn_();
  }
}

void CopiedPicture::resize(const QSize& size_px)
{
  window_.SetSize(size_px.width(), size_px.height());
  isDrawn_ = false;
}

const QImage& CopiedPicture::image()
{
  if (!isValid_) return image_;
  if (!isDrawn_) {
    isRequested_ = true;
    window_.Render();
    isRequested_ = false;
  }
  if (isDrawn_ && !isCopied_) copy();
  return image_;
}

void CopiedPicture::copy()
{
  isCopied_ = true;
  const QSize size(window_.GetSize()[0], window_.GetSize()[1]);
  // without alpha: the picture is opaque whatever a renderer leaves there
  if (image_.size() != size) image_ = QImage(size, QImage::Format_RGB32);
  makeCurrent();
  // through VTK, which remembers OpenGL's state; pixels of four bytes suit each alignment of rows
  vtkOpenGLState& state = *window_.GetState();
  state.ResetFramebufferBindings();
  state.PushReadFramebufferBinding();
  window_.GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window_.GetDisplayFramebuffer()->ActivateReadBuffer(0);
  context_.functions()->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_BYTE,
                                     image_.bits());
  state.PopReadFramebufferBinding();
  // its lowest row is the first
  for (int above = 0, below = size.height() - 1; above < below; ++above, --below) {
    auto* const row = reinterpret_cast<QRgb*>(image_.scanLine(above));
    std::swap_ranges(row, row + size.width(), reinterpret_cast<QRgb*>(image_.scanLine(below)));
  }
}

std::string CopiedPicture::renderer()
{
  if (!isValid_ || !makeCurrent()) return {};
  const auto* const name = context_.functions()->glGetString(GL_RENDERER);
  return name == nullptr ? std::string() : reinterpret_cast<const char*>(name);
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/CopiedPicture.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <cstring>
#include <utility>

namespace perilymph::gui {

namespace {

constexpr int tile_px = 32;

}  // namespace

CopiedPicture::CopiedPicture(vtkGenericOpenGLRenderWindow& window,
                             std::function<void(const QRegion&)> onDrawn)
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
    const QRegion changed = copy();
    if (!isRequested_) onDrawn_(changed);
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
  return image_;
}

QRegion CopiedPicture::copy()
{
  const QSize size(window_.GetSize()[0], window_.GetSize()[1]);
  const bool isNew = image_.size() != size;
  if (isNew) {
    // without alpha: the picture is opaque whatever a renderer leaves there
    image_ = QImage(size, QImage::Format_RGB32);
    read_ = QImage(size, QImage::Format_RGB32);
  }
  // through VTK, which remembers OpenGL's state; pixels of four bytes suit each alignment of rows
  vtkOpenGLState& state = *window_.GetState();
  state.ResetFramebufferBindings();
  state.PushReadFramebufferBinding();
  window_.GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window_.GetDisplayFramebuffer()->ActivateReadBuffer(0);
  context_.functions()->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_BYTE,
                                     read_.bits());
  state.PopReadFramebufferBinding();

  std::vector<QRect> changed;
  for (int top = 0; top < size.height(); top += tile_px)
    for (int left = 0; left < size.width(); left += tile_px) {
      const QRect tile = QRect(left, top, tile_px, tile_px).intersected(QRect(QPoint(0, 0), size));
      if (!copyTile(tile) && !isNew) continue;
      if (!changed.empty() && changed.back().top() == top && changed.back().right() == left - 1)
        changed.back().setRight(tile.right());
      else
        changed.push_back(tile);
    }
  QRegion region;
  region.setRects(changed.data(), static_cast<int>(changed.size()));
  return region;
}

/// True if the tile changed.
bool CopiedPicture::copyTile(const QRect& tile)
{
  const auto bytes = static_cast<std::size_t>(tile.width()) * sizeof(QRgb);
  bool isChanged = false;
  for (int y = tile.top(); y <= tile.bottom(); ++y) {
    const auto* const from =
        reinterpret_cast<const QRgb*>(read_.constScanLine(image_.height() - 1 - y)) + tile.left();
    auto* const to = reinterpret_cast<QRgb*>(image_.scanLine(y)) + tile.left();
    if (!isChanged && std::memcmp(from, to, bytes) == 0) continue;
    isChanged = true;
    std::memcpy(to, from, bytes);
  }
  return isChanged;
}

}  // namespace perilymph::gui

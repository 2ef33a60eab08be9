// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/ComposedPicture.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderWindowInteractor.h>

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <utility>

namespace perilymph::gui {

ComposedPicture::ComposedPicture(vtkGenericOpenGLRenderWindow& window, QWidget* parent)
    : QVTKOpenGLNativeWidget(&window, parent)
{
  setFocusPolicy(Qt::NoFocus);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_AcceptTouchEvents, false);  // VTK 9.1 would handle each touch twice
  setEnableHiDPI(false);  // scenes scale their texts themselves; VTK would do it again
  // without alpha in its buffer, the widget covers what is behind it, and VTK need not fill alpha in
  setTextureFormat(GL_RGB8);
  setUpdateBehavior(
      QOpenGLWidget::PartialUpdate);  // each paint covers the widget: nothing to clear
  connect(this, &QOpenGLWidget::resized, this, [this] { hasNewSize_ = true; });
  // interactor styles have their own keys and drags
  if (window.GetInteractor() != nullptr) window.GetInteractor()->SetInteractorStyle(nullptr);
}

void ComposedPicture::paintGL()
{
  const QSize size_px = size() * devicePixelRatioF();
  vtkOpenGLFramebufferObject* const picture = RenderWindow->GetDisplayFramebuffer();
  const int* const drawn_px = picture == nullptr ? nullptr : picture->GetLastSize();
  if (std::exchange(hasNewSize_, false) || drawn_px == nullptr ||
      QSize(drawn_px[0], drawn_px[1]) != size_px)
    return QVTKOpenGLNativeWidget::paintGL();

  // VTK would filter the picture, although no pixel lies between others
  QOpenGLExtraFunctions& gl = *context()->extraFunctions();
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, picture->GetFBOIndex());
  gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl.glBlitFramebuffer(0, 0, size_px.width(), size_px.height(), 0, 0, size_px.width(),
                       size_px.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

}  // namespace perilymph::gui

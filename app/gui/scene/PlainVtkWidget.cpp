// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PlainVtkWidget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>

namespace perilymph::gui {

PlainVtkWidget::PlainVtkWidget(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  setFocusPolicy(Qt::NoFocus);
  setAttribute(Qt::WA_AcceptTouchEvents, false);  // VTK 9.1 would handle each touch twice
  setEnableHiDPI(false);  // scenes scale their texts themselves; VTK would do it again
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  setRenderWindow(window);
  // interactor styles have their own keys and drags
  if (window->GetInteractor() != nullptr) window->GetInteractor()->SetInteractorStyle(nullptr);
}

bool PlainVtkWidget::event(QEvent* event)
{
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      // Bypasses VTK, which would handle them. NOLINTNEXTLINE(bugprone-parent-virtual-call)
      return QOpenGLWidget::event(event);
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

}  // namespace perilymph::gui

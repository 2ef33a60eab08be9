// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PlainWindow.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

namespace perilymph::gui {

void setPlainWindow(QVTKOpenGLNativeWidget& widget)
{
  widget.setFocusPolicy(Qt::NoFocus);
  widget.setAttribute(Qt::WA_AcceptTouchEvents, false);  // VTK 9.1 would handle each touch twice
  widget.setEnableHiDPI(false);  // scenes scale their texts themselves; VTK would do it again
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  widget.setRenderWindow(window);
  // interactor styles have their own keys and drags
  if (window->GetInteractor() != nullptr) window->GetInteractor()->SetInteractorStyle(nullptr);
}

}  // namespace perilymph::gui

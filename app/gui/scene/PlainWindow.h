// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A VTK widget without VTK's own handling of mouse, touch and pixel ratio.

class QVTKOpenGLNativeWidget;

namespace perilymph::gui {

/// Gives a widget a render window without multisampling; the widget handles mouse input itself and
/// scales its own texts.
void setPlainWindow(QVTKOpenGLNativeWidget& widget);

}  // namespace perilymph::gui

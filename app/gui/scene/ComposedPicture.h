// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture that OpenGL composes with the rest of its window.

#include <QVTKOpenGLNativeWidget.h>

namespace perilymph::gui {

/// Shows what VTK draws, pixel for pixel. It is opaque whatever a renderer leaves as alpha, and passes
/// the mouse on to its parent.
class ComposedPicture : public QVTKOpenGLNativeWidget {
  Q_OBJECT
public:
  ComposedPicture(vtkGenericOpenGLRenderWindow& window, QWidget* parent);

protected:
  void paintGL() override;

private:
  bool hasNewSize_ = true;  ///< VTK draws, if nothing was drawn in this size.
};

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A VTK widget without VTK's own handling of mouse, touch and pixel ratio.

#include <QVTKOpenGLNativeWidget.h>

namespace perilymph::gui {

/// A drag over the full height of a view rotates its model by half a turn.
inline constexpr double turnPerHeight_deg = 180.0;

/// A view whose mouse events are those of Qt. It has a render window without multisampling; what it
/// shows scales its texts itself.
class PlainVtkWidget : public QVTKOpenGLNativeWidget {
  Q_OBJECT
public:
  explicit PlainVtkWidget(QWidget* parent);

protected:
  bool event(QEvent* event) override;
};

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Quad-buffered stereo view, for displays that support it.

#include <QObject>
#include <memory>

#include "perilymph/visualization/InsertionScene.h"

class QVTKOpenGLWindow;

namespace perilymph::gui {

/// A separate window, because only a top-level surface has a buffer for each eye: embedded views
/// are composed from one buffer. It shows the 3D view without read-outs.
class StereoWindow : public QObject {
  Q_OBJECT
public:
  explicit StereoWindow(QObject* parent);
  ~StereoWindow() override;

  /// Sets the scene; the first one opens the window.
  void setScene(std::unique_ptr<visualization::InsertionScene> scene);
  visualization::InsertionScene& scene() { return *scene_; }
  /// Renders the scene with the camera of another one.
  void renderAs(const visualization::InsertionScene& other);
  bool isOpen() const;
  /// Closes the window, as its user would.
  void close() const;

Q_SIGNALS:
  /// The user closed it, or pressed Esc in it.
  void closed();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // the window owns the scene's renderer and is destroyed first
  std::unique_ptr<visualization::InsertionScene> scene_;
  std::unique_ptr<QVTKOpenGLWindow> window_;
};

}  // namespace perilymph::gui

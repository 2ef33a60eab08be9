// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stereo view in a window of its own: quad-buffered, or side by side for a 3D screen.

#include <QObject>
#include <memory>

#include "perilymph/visualization/InsertionScene.h"

class QVTKOpenGLWindow;

namespace perilymph::gui {

/// Whether a stereo mode is shown in a window of its own.
inline bool hasOwnWindow(visualization::Stereo stereo)
{
  return stereo == visualization::Stereo::quadBuffered ||
         stereo == visualization::Stereo::sideBySide;
}

/// A separate window, because only a top-level surface has a buffer for each eye, and because two
/// halves side by side have to fill a 3D screen (F11). It shows the 3D view without read-outs, which
/// would be seen by one eye.
class StereoWindow : public QObject {
  Q_OBJECT
public:
  /// @param stereo  Quad-buffered or side by side.
  StereoWindow(visualization::Stereo stereo, QObject* parent);
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
  visualization::Stereo stereo_;
  std::unique_ptr<visualization::InsertionScene> scene_;
  std::unique_ptr<QVTKOpenGLWindow> window_;
};

}  // namespace perilymph::gui

#pragma once

// The picture for two eyes through the two buffers of a display that has them.

#include <QObject>
#include <memory>

#include "perilymph/visualization/InsertionScene.h"

class QVTKOpenGLWindow;

namespace perilymph::gui {

/// A window of its own, because only a window's own surface has a buffer for each eye: a view
/// inside of another window is composed from one. It shows the picture without words on it.
class StereoWindow : public QObject {
  Q_OBJECT
public:
  explicit StereoWindow(QObject* parent);
  ~StereoWindow() override;

  /// What is shown from now on; the first one opens the window.
  void setScene(std::unique_ptr<visualization::InsertionScene> scene);
  visualization::InsertionScene& scene() { return *scene_; }
  /// Draws the scene from where another one is looked at.
  void renderAs(const visualization::InsertionScene& other);
  bool isOpen() const;
  /// As its user closes it.
  void close() const;

Q_SIGNALS:
  /// Its user closed it, or pressed Esc in it.
  void closed();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // the scene's renderer is in the window's hands: the window goes first
  std::unique_ptr<visualization::InsertionScene> scene_;
  std::unique_ptr<QVTKOpenGLWindow> window_;
};

}  // namespace perilymph::gui

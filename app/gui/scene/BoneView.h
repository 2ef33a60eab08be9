// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A 3D view with bone that is cut open, turned by mouse and keys.

#include <Eigen/Core>
#include <QTimer>
#include <optional>

#include "gui/scene/PlainVtkWidget.h"

namespace perilymph::visualization {
class BoneLayer;
}

namespace perilymph::gui {

class SceneLabels;

/// The base of views of a scene with bone and landmarks:
/// - left button: rotates; at the handle or with Ctrl: moves the cut; right button, wheel: zoom;
/// - arrow keys rotate, + and - zoom, Page Up and Page Down move the cut, V turns it to the viewer;
/// - where the line of approach can be turned, the handle on it does so.
/// While something moves, the bone is coarse, except on a graphics card.
class BoneView : public PlainVtkWidget {
  Q_OBJECT
public:
  /// @param zoomPerNotch  Magnification by a notch of the wheel, or a key.
  BoneView(double zoomPerNotch, QWidget* parent);

  QSize minimumSizeHint() const override { return {160, 140}; }
  const SceneLabels& labels() const { return *labels_; }

Q_SIGNALS:
  /// A double click.
  void maximizeRequested();

protected:
  /// Bone and landmarks of the scene; null without a scene.
  virtual visualization::BoneLayer* layer() = 0;
  virtual void rotateScene(double azimuth_deg, double elevation_deg) = 0;
  virtual void zoomScene(double factor) = 0;
  /// The user moved the camera or the cut, and the picture shows it.
  virtual void onMoved() {}
  /// Whether the line of approach has a handle.
  virtual bool isApproachTurnable() const { return false; }
  /// The user begins to turn the line of approach; turns it outward along a direction of the scene's
  /// model; ends it, or takes it back.
  virtual void beginApproach() {}
  virtual void turnApproach(const Eigen::Vector3d& outward) { static_cast<void>(outward); }
  virtual void endApproach(bool isTakenBack) { static_cast<void>(isTakenBack); }

  /// Renders the picture with its labels.
  void render();
  /// Renders while something moves; at rest the fine surface follows.
  void renderMoving();
  void setNote(const QString& note);

  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  /// Turns the line of approach to the mouse.
  void followApproach();

  double zoomPerNotch_;
  SceneLabels* labels_;
  QString note_;
  QPointF mouse_;
  bool isCutHeld_ = false;
  /// The line of approach is turned: where its handle was beside the mouse, and before its inner end.
  struct HeldApproach {
    QPointF aside;
    double toViewer_mm;
  };
  std::optional<HeldApproach> heldApproach_;
  QTimer rest_;
};

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The measured cochlea in 3D.

#include <memory>

#include "gui/pages/ct/CtStudy.h"
#include "gui/scene/PlainVtkWidget.h"
#include "perilymph/visualization/SurfaceScene.h"

namespace perilymph::gui {

/// Shows the fitted wall with the landmarks; the mouse rotates and zooms it.
class SurfaceView : public PlainVtkWidget {
  Q_OBJECT
public:
  SurfaceView(CtStudy& study, QWidget* parent);
  ~SurfaceView() override;

  QSize minimumSizeHint() const override { return {160, 140}; }

Q_SIGNALS:
  /// A double click.
  void maximizeRequested();

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  void refresh();
  void render();

  CtStudy& study_;
  std::unique_ptr<visualization::SurfaceScene> scene_;
  std::optional<Eigen::Vector3d> shownWindow_P_;  ///< Round window of the measures in the scene.
  QPointF mouse_;
};

}  // namespace perilymph::gui

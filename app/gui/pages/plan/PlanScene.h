// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An array in the patient's cochlea, in 3D.

#include <memory>

#include "gui/pages/plan/PlanShapeWork.h"
#include "gui/scene/PlainVtkWidget.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::gui {

/// The mouse rotates and zooms the picture; other pictures can follow its camera.
class PlanScene : public PlainVtkWidget {
  Q_OBJECT
public:
  explicit PlanScene(QWidget* parent);
  ~PlanScene() override;

  void show(const PlanShapeWork::Shape& shape);
  void clear();
  /// Arrows and colors of the forces with their scales.
  void showForces(bool areShown);
  bool isShown() const { return scene_ != nullptr; }
  /// Takes over the camera of another picture.
  void lookAs(const PlanScene& other);
  visualization::InsertionScene* scene() { return scene_.get(); }

  QSize minimumSizeHint() const override { return {160, 140}; }

Q_SIGNALS:
  void cameraMoved();

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  void render();

  PlanShapeWork::Shape shape_;  ///< The scene refers to it.
  std::unique_ptr<visualization::InsertionScene> scene_;
  QPointF mouse_;
};

}  // namespace perilymph::gui

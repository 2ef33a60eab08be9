// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An array in the patient's cochlea, in 3D.

#include <memory>

#include "gui/pages/plan/PlanShapeWork.h"
#include "gui/scene/BoneNote.h"
#include "gui/scene/BoneView.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::gui {

/// The mouse rotates and zooms the picture; other pictures can follow its camera.
class PlanScene : public BoneView {
  Q_OBJECT
public:
  explicit PlanScene(QWidget* parent);
  ~PlanScene() override;

  /// @param approach  Of the plan; the simulation that is shown deviates from it.
  void show(const PlanShapeWork::Shape& shape, const anatomy::Approach& approach);
  void clear();
  /// Arrows and colors of the forces with their scales.
  void showForces(bool areShown);
  bool isShown() const { return scene_ != nullptr; }
  /// Takes over the camera of another picture.
  void lookAs(const PlanScene& other);
  visualization::InsertionScene* scene() { return scene_.get(); }

  /// Shows bone and landmarks of a patient, or hides them.
  /// @param bone  Null without one.
  void showBone(bool isShown, std::shared_ptr<const visualization::BoneModel> bone,
                CochleaOrigin origin);

Q_SIGNALS:
  void cameraMoved();

protected:
  visualization::BoneLayer* layer() override { return scene_ ? &scene_->bone() : nullptr; }
  void rotateScene(double azimuth_deg, double elevation_deg) override
  {
    scene_->rotateModel(azimuth_deg, elevation_deg, 0.0);
  }
  void zoomScene(double factor) override { scene_->zoom(factor); }
  void onMoved() override { Q_EMIT cameraMoved(); }

private:
  PlanShapeWork::Shape shape_;  ///< The scene refers to it.
  std::unique_ptr<visualization::InsertionScene> scene_;
};

}  // namespace perilymph::gui

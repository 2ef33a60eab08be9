// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bone of the CT and the measured cochlea in it, in 3D.

#include <memory>

#include "gui/pages/ct/CtStudy.h"
#include "gui/scene/BoneView.h"
#include "perilymph/visualization/SurfaceScene.h"

namespace perilymph::gui {

class CtBone;

/// Shows the bone, cut open, with the fitted wall, the landmarks and an inserted array in it. The line of
/// approach is turned about the opening: by its handle, or by Shift and the arrow keys, a degree each, with
/// Ctrl a tenth; Home puts it along the axis of the opening. Esc takes back what is being dragged.
class SurfaceView : public BoneView {
  Q_OBJECT
public:
  SurfaceView(CtStudy& study, const CtBone& bone, QWidget* parent);
  ~SurfaceView() override;

  /// The picture; null before the first CT.
  visualization::SurfaceScene* scene() { return scene_.get(); }

protected:
  visualization::BoneLayer* layer() override { return scene_ ? &scene_->bone() : nullptr; }
  void rotateScene(double azimuth_deg, double elevation_deg) override
  {
    scene_->rotate(azimuth_deg, elevation_deg);
  }
  void zoomScene(double factor) override { scene_->zoom(factor); }
  bool isApproachTurnable() const override;
  void beginApproach() override;
  void turnApproach(const Eigen::Vector3d& outward) override;
  void endApproach(bool isTakenBack) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void refresh();
  void showLandmarks();
  void makeScene();
  void lookFirst();
  void showNote();

  CtStudy& study_;
  const CtBone& bone_;
  std::unique_ptr<visualization::SurfaceScene> scene_;
  // what the scene shows
  std::shared_ptr<const ct::CtVolume> volume_;
  std::shared_ptr<const ct::CochleaMeasures> measures_;
};

}  // namespace perilymph::gui

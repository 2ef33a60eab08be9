// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/SurfaceView.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/pages/ct/CtBone.h"
#include "gui/scene/BoneNote.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/LandmarkText.h"
#include "gui/widgets/Theme.h"
#include "perilymph/imaging/MeasuredSurface.h"

namespace perilymph::gui {

namespace {

constexpr double minPathRadius_mm = 0.05;

}  // namespace

SurfaceView::SurfaceView(CtStudy& study, const CtBone& bone, QWidget* parent)
    : BoneView(zoomPerNotch, parent), study_(study), bone_(bone)
{
  setObjectName(QStringLiteral("surfaceView"));
  setAccessibleName(tr("Bone and measured cochlea, 3D"));
  setToolTip(boneTip());
  connect(&study_, &CtStudy::modelChanged, this, &SurfaceView::refresh);
  connect(&bone_, &CtBone::changed, this, &SurfaceView::refresh);
}

SurfaceView::~SurfaceView() = default;

void SurfaceView::makeScene()
{
  if (scene_) renderWindow()->RemoveRenderer(&scene_->renderer());
  volume_ = study_.volume();
  measures_ = study_.measures();
  scene_ = std::make_unique<visualization::SurfaceScene>(
      measures_ ? imaging::measuredSurface(*measures_) : anatomy::Surface(),
      sceneStyle(shownColorScheme()));
  scene_->setScale(devicePixelRatioF());
  scene_->attachTo(*renderWindow());
}

void SurfaceView::lookFirst()
{
  if (measures_) {
    const ct::ViewPlane view = ct::cochlearPlanes(*measures_, measures_->center_P)[0];
    scene_->lookAlong(view.away_P(), view.down_P);
    scene_->rotate(0.0, 35.0);  // obliquely, so that the turns lie one above the other
  } else if (study_.hasCt()) {
    const ct::ViewPlane view = ct::patientPlanes(study_.volume()->center_P())[0];
    scene_->lookAlong(view.away_P(), view.down_P);
    scene_->rotate(25.0, 35.0);
  }
}

void SurfaceView::refresh()
{
  if (!study_.hasCt()) {
    volume_.reset();
    measures_.reset();
    if (!scene_) return;
    // a window without a renderer keeps its last picture
    scene_->renderer().RemoveAllViewProps();
    scene_->bone().setVisible(false);
    return render();
  }
  const bool isAnother = volume_ != study_.volume() || measures_ != study_.measures() || !scene_;
  if (isAnother) makeScene();
  const bool isFirstBone = bone_.model() && !scene_->bone().bone();
  scene_->bone().setBone(bone_.model());
  if (isAnother || (isFirstBone && !measures_)) lookFirst();
  visualization::SceneLandmarks landmarks = bone_.landmarks();
  std::vector<Eigen::Vector3d> points;
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const auto mark = static_cast<ct::Mark>(k);
    const auto& point = study_.marks()[mark];
    if (!point) continue;
    if (mark == ct::Mark::roundWindow) {
      landmarks.roundWindow = 1e-3 * *point;
      continue;
    }
    points.push_back(*point);
    landmarks.others.emplace_back(markLabel(mark).toStdString(), 1e-3 * *point);
  }
  scene_->bone().setLandmarks(landmarks);
  scene_->setPoints(points);
  std::vector<Eigen::Vector3d> line;
  double radius_mm = minPathRadius_mm;
  for (const auto& node : study_.array().nodes) {
    line.push_back(node.center_P);
    radius_mm = std::max(radius_mm, 0.7 * node.radius_mm);  // drawn with one radius, tapered or not
  }
  scene_->setPath(line, radius_mm);
  showNote();
  render();
}

void SurfaceView::showNote()
{
  setNote(bone_.isBusy()  ? tr("Computing the bone…")
          : measures_     ? tr("Bone, cut across the axis of the basal turn")
          : bone_.model() ? tr("Bone of the CT, cut open from below")
                          : QString());
}

}  // namespace perilymph::gui

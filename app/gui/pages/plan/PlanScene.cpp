// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanScene.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include "gui/text/ChartLabels.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double zoomOfNotch = 1.1;

}  // namespace

PlanScene::PlanScene(QWidget* parent) : BoneView(zoomOfNotch, parent)
{
  setObjectName(QStringLiteral("planScene"));
  setToolTip(boneTip());
}

PlanScene::~PlanScene() = default;

void PlanScene::clear()
{
  if (scene_) renderWindow()->RemoveRenderer(&scene_->renderer());
  scene_.reset();
  shape_.reset();
  update();
}

void PlanScene::show(const PlanShapeWork::Shape& shape, const anatomy::Approach& approach)
{
  clear();
  shape_ = shape;
  scene_ = std::make_unique<visualization::InsertionScene>(
      *shape->anatomy, shape->parameters.array, shape->parameters.cochlea.patient.side,
      visualization::Quality::software, sceneStyle(shownColorScheme()));
  scene_->setVisible(visualization::Part::styletAndTweezers, false);
  scene_->setScale(devicePixelRatioF() * textScale());
  scene_->attachTo(*renderWindow());
  scene_->lookFrom(visualization::CameraPreset::surgeon);
  scene_->setApproach(approach);
  scene_->show(shape->end);
  render();
}

void PlanScene::showForces(bool areShown)
{
  if (!scene_) return;
  scene_->setVisible(visualization::Part::contactArrows, areShown);
  scene_->setVisible(visualization::Part::wallForce, areShown);
  render();
}

void PlanScene::showBone(bool isShown, std::shared_ptr<const visualization::BoneModel> bone,
                         CochleaOrigin origin)
{
  if (!scene_) return;
  const bool hasBone = bone != nullptr;
  scene_->bone().setBone(std::move(bone));
  scene_->setVisible(visualization::Part::landmarks, isShown);
  setNote(boneNote(hasBone, origin));
  render();
}

void PlanScene::lookAs(const PlanScene& other)
{
  if (!scene_ || !other.scene_) return;
  scene_->lookAs(*other.scene_);
  render();
}

}  // namespace perilymph::gui

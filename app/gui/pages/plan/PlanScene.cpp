// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanScene.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "gui/text/ChartLabels.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double turnPerHeight_deg = 180.0;  // by a drag over the full height
constexpr double zoomOfNotch = 1.1;

}  // namespace

PlanScene::PlanScene(QWidget* parent) : PlainVtkWidget(parent)
{
  setObjectName(QStringLiteral("planScene"));
  setToolTip(tr("Drag to rotate, wheel to zoom."));
}

PlanScene::~PlanScene() = default;

void PlanScene::clear()
{
  if (scene_) renderWindow()->RemoveRenderer(&scene_->renderer());
  scene_.reset();
  shape_.reset();
  update();
}

void PlanScene::show(const PlanShapeWork::Shape& shape)
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

void PlanScene::lookAs(const PlanScene& other)
{
  if (!scene_ || !other.scene_) return;
  scene_->lookAs(*other.scene_);
  render();
}

void PlanScene::render()
{
  // before the widget is shown it has no OpenGL context; VTK renders when it gets one
  if (isValid()) renderWindow()->Render();
  update();
}

void PlanScene::mousePressEvent(QMouseEvent* event) { mouse_ = event->localPos(); }

void PlanScene::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF moved = (event->localPos() - mouse_) / height();
  mouse_ = event->localPos();
  if (!scene_ || (event->buttons() & Qt::LeftButton) == 0) return;
  scene_->rotateModel(turnPerHeight_deg * moved.x(), turnPerHeight_deg * moved.y(), 0.0);
  render();
  Q_EMIT cameraMoved();
}

void PlanScene::wheelEvent(QWheelEvent* event)
{
  event->accept();
  if (!scene_) return;
  scene_->zoom(std::pow(zoomOfNotch, event->angleDelta().y() / 120.0));
  render();
  Q_EMIT cameraMoved();
}

}  // namespace perilymph::gui

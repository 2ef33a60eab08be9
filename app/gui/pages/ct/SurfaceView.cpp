// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/SurfaceView.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/text/ChartLabels.h"
#include "gui/widgets/Theme.h"
#include "perilymph/imaging/MeasuredSurface.h"

namespace perilymph::gui {

namespace {

constexpr double turnPerHeight_deg = 180.0;  // by a drag over the full height
constexpr double minPathRadius_mm = 0.05;

}  // namespace

SurfaceView::SurfaceView(CtStudy& study, QWidget* parent) : PlainVtkWidget(parent), study_(study)
{
  setObjectName(QStringLiteral("surfaceView"));
  setAccessibleName(tr("Measured cochlea, 3D"));
  connect(&study_, &CtStudy::modelChanged, this, &SurfaceView::refresh);
}

SurfaceView::~SurfaceView() = default;

void SurfaceView::refresh()
{
  const auto& measures = study_.measures();
  if (!measures) {
    shownWindow_P_.reset();
    if (!scene_) return;
    // a window without a renderer keeps its last picture
    scene_->renderer().RemoveAllViewProps();
    return render();
  }
  if (shownWindow_P_ != measures->roundWindow_P) {
    if (scene_) renderWindow()->RemoveRenderer(&scene_->renderer());
    scene_ = std::make_unique<visualization::SurfaceScene>(imaging::measuredSurface(*measures),
                                                           sceneStyle(shownColorScheme()));
    scene_->attachTo(*renderWindow());
    const ct::ViewPlane view = ct::cochlearPlanes(*measures, measures->center_P)[0];
    scene_->lookAlong(view.away_P(), view.down_P);
    scene_->rotate(0.0, 35.0);  // obliquely, so that the turns lie one above the other
    shownWindow_P_ = measures->roundWindow_P;
  }
  std::vector<Eigen::Vector3d> points;
  for (const auto& point : study_.marks().points_P)
    if (point) points.push_back(*point);
  scene_->setPoints(points);
  std::vector<Eigen::Vector3d> line;
  double radius_mm = minPathRadius_mm;
  for (const auto& node : study_.array().nodes) {
    line.push_back(node.center_P);
    radius_mm = std::max(radius_mm, 0.7 * node.radius_mm);  // drawn with one radius, tapered or not
  }
  scene_->setPath(line, radius_mm);
  render();
}

void SurfaceView::render()
{
  // before the widget is shown it has no OpenGL context; VTK renders when it gets one
  if (isValid()) renderWindow()->Render();
  update();
}

void SurfaceView::mousePressEvent(QMouseEvent* event) { mouse_ = event->localPos(); }

void SurfaceView::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF moved = (event->localPos() - mouse_) / height();
  mouse_ = event->localPos();
  if (!scene_) return;
  if ((event->buttons() & Qt::LeftButton) != 0)
    scene_->rotate(turnPerHeight_deg * moved.x(), turnPerHeight_deg * moved.y());
  else if ((event->buttons() & Qt::RightButton) != 0)
    scene_->zoom(std::exp(-2.0 * moved.y()));
  else
    return;
  render();
}

void SurfaceView::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

void SurfaceView::wheelEvent(QWheelEvent* event)
{
  event->accept();
  if (!scene_) return;
  scene_->zoom(std::pow(zoomPerNotch, event->angleDelta().y() / 120.0));
  render();
}

}  // namespace perilymph::gui

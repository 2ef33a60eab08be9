// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/SurfaceView.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/pages/ct/CtBone.h"
#include "gui/pages/ct/CtText.h"
#include "gui/scene/BoneNote.h"
#include "gui/text/ApproachText.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/LandmarkText.h"
#include "gui/widgets/Theme.h"
#include "perilymph/imaging/MeasuredSurface.h"

namespace perilymph::gui {

namespace {

constexpr double minPathRadius_mm = 0.05;
constexpr double shownLine_mm = 8.0;  // of the line of approach, as in the other views of an ear

}  // namespace

SurfaceView::SurfaceView(CtStudy& study, const CtBone& bone, QWidget* parent)
    : BoneView(zoomPerNotch, parent), study_(study), bone_(bone)
{
  setObjectName(QStringLiteral("surfaceView"));
  setAccessibleName(tr("Bone and measured cochlea, 3D"));
  setToolTip(boneTip() + QLatin1Char(' ') +
             tr("Drag the handle on the line of approach, or Shift+arrow keys: turn it about the "
                "opening. Home: along the axis of the opening."));
  connect(&study_, &CtStudy::modelChanged, this, &SurfaceView::refresh);
  connect(&bone_, &CtBone::changed, this, &SurfaceView::refresh);
  for (const auto signal : {&CtStudy::approachMoved, &CtStudy::markupsChanged})
    connect(&study_, signal, this, [this] {
      if (!scene_) return;
      showLandmarks();
      showNote();
      render();
    });
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
  showLandmarks();
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

void SurfaceView::showLandmarks()
{
  visualization::SceneLandmarks landmarks = bone_.landmarks();
  if (const auto line = study_.approachLine())
    landmarks.approach = {1e-3 * line->at(shownLine_mm), 1e-3 * line->opening_P};
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
  for (const ct::MarkupKind kind : ct::approachStructures) {
    visualization::MarkedCourse course;
    QString name = markupName(kind);
    if (const auto distance = study_.distanceFromApproach(kind)) {
      name += QStringLiteral("  ") + distanceText(*distance);
      course.distance = {1e-3 * distance->mark_P,
                         1e-3 * study_.approachLine()->at(distance->outside_mm)};
    }
    course.name = name.toStdString();
    for (const Eigen::Vector3d& point : study_.pointsOf(kind))
      course.points.push_back(1e-3 * point);
    if (!course.points.empty()) landmarks.courses.push_back(std::move(course));
  }
  scene_->bone().setLandmarks(landmarks);
  scene_->setPoints(points);
}

bool SurfaceView::isApproachTurnable() const { return study_.approachLine().has_value(); }

void SurfaceView::beginApproach() { study_.beginChange(); }

void SurfaceView::turnApproach(const Eigen::Vector3d& outward) { study_.turnApproach(outward); }

void SurfaceView::endApproach(bool isTakenBack)
{
  study_.endChange();
  if (isTakenBack) study_.undo();
}

void SurfaceView::keyPressEvent(QKeyEvent* event)
{
  const auto angles = study_.approachAngles();
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (!angles || layer() == nullptr || (!isShift && event->key() != Qt::Key_Home))
    return BoneView::keyPressEvent(event);
  const Angle step = (event->modifiers() & Qt::ControlModifier) != 0 ? degrees(0.1) : degrees(1.0);
  anatomy::BasalTurnAngles turned = *angles;
  switch (event->key()) {
    case Qt::Key_Left:
      turned.inPlane = turned.inPlane - step;
      break;
    case Qt::Key_Right:
      turned.inPlane = turned.inPlane + step;
      break;
    case Qt::Key_Up:
      turned.outOfPlane = turned.outOfPlane + step;
      break;
    case Qt::Key_Down:
      turned.outOfPlane = turned.outOfPlane - step;
      break;
    case Qt::Key_Home:
      study_.resetApproach();
      return event->accept();
    default:
      return BoneView::keyPressEvent(event);
  }
  event->accept();
  study_.beginChange();
  study_.turnApproach(turned);
  study_.endChange();
}

void SurfaceView::showNote()
{
  QString note = bone_.isBusy()  ? tr("Computing the bone…")
                 : measures_     ? tr("Bone, cut across the axis of the basal turn")
                 : bone_.model() ? tr("Bone of the CT, cut open from below")
                                 : QString();
  if (const auto angles = study_.approachAngles())
    note += QLatin1Char('\n') +
            tr("Approach: %1, %2").arg(inPlaneText(*angles), outOfPlaneText(*angles));
  if (study_.isApproachAtLimit()) note += QLatin1Char('\n') + approachLimitText();
  setNote(note);
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/PlaneView.h"

#include <Eigen/Geometry>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/pages/ct/CtText.h"
#include "gui/pages/ct/PlaneOverlay.h"
#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"
#include "perilymph/figures/FixedInks.h"

namespace perilymph::gui {

namespace {

constexpr double reach_px = 12.0;  // of the mouse to a landmark
constexpr int loupe_px = 132;
constexpr double loupeTimes = 3.0;
constexpr double nudge_mm = 0.1;  // of a key: half the smallest voxel of usual scanners

/// Samples the picture of a plane at the screen's pixels.
QImage pictureOf(CtStudy& study, const ct::ViewPlane& plane, const QSize& size, double ratio,
                 double pixel_mm)
{
  imaging::PlanePicture picture;
  picture.plane = plane;
  picture.width = int(std::lround(size.width() * ratio));
  picture.height = int(std::lround(size.height() * ratio));
  picture.pixel_mm = pixel_mm / ratio;
  picture.window = study.window();
  picture.thickness_mm = study.thickness_mm();
  picture.projection = study.projection();
  const auto gray = study.sampler().sample(picture);
  QImage image(picture.width, picture.height, QImage::Format_Grayscale8);
  const auto width = static_cast<std::size_t>(picture.width);
  for (int row = 0; row < picture.height; ++row)
    std::copy_n(gray.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * width),
                width, image.scanLine(row));
  image.setDevicePixelRatio(ratio);
  return image;
}

}  // namespace

PlaneView::PlaneView(CtStudy& study, std::size_t plane, QWidget* parent)
    : QWidget(parent), study_(study), index_(plane)
{
  setObjectName(QStringLiteral("planeView%1").arg(plane));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::CrossCursor);
  connect(&study, &CtStudy::changed, this, [this] {
    setAccessibleName(planeName(study_.frame(), index_));
    update();
  });
}

void PlaneView::resizeEvent(QResizeEvent* event)
{
  QWidget::resizeEvent(event);
  study_.setPicture_px(std::min(width(), height()));
}

void PlaneView::setPlaced(std::optional<ct::Mark> mark) { placed_ = mark; }

QPointF PlaneView::placeOf(const Eigen::Vector3d& point_P) const
{
  const Eigen::Vector2d place = plane().inPicture(point_P) / study_.pixel_mm();
  return {0.5 * width() + place.x(), 0.5 * height() + place.y()};
}

Eigen::Vector3d PlaneView::pointAt(const QPointF& place) const
{
  return plane().atPicture(study_.pixel_mm() *
                           Eigen::Vector2d(place.x() - 0.5 * width(), place.y() - 0.5 * height()));
}

std::optional<ct::Mark> PlaneView::markAt(const QPointF& place) const
{
  std::optional<ct::Mark> nearest;
  double reach = reach_px;
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const auto mark = static_cast<ct::Mark>(k);
    const auto& point = study_.marks()[mark];
    if (!point || std::fabs(plane().behind(*point)) > markReach_mm) continue;
    const QPointF away = placeOf(*point) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance > reach) continue;
    reach = distance;
    nearest = mark;
  }
  return nearest;
}

void PlaneView::setMarked(std::optional<ct::MarkupKind> structure) { marked_ = structure; }

std::optional<CtStudy::MarkupPoint> PlaneView::markupAt(const QPointF& place) const
{
  std::optional<CtStudy::MarkupPoint> nearest;
  double reach = reach_px;
  const auto& markups = study_.markups();
  for (std::size_t k = 0; k < markups.size(); ++k) {
    if (markups[k].kind == ct::MarkupKind::approach) continue;  // it has a handle of its own
    for (std::size_t point = 0; point < markups[k].points_P.size(); ++point) {
      if (std::fabs(plane().behind(markups[k].points_P[point])) > markReach_mm) continue;
      const QPointF away = placeOf(markups[k].points_P[point]) - place;
      const double distance = std::hypot(away.x(), away.y());
      if (distance > reach) continue;
      reach = distance;
      nearest = CtStudy::MarkupPoint{k, point};
    }
  }
  return nearest;
}

int PlaneView::contactAt(const QPointF& place) const
{
  int nearest = 0;
  double reach = reach_px;
  for (const CtStudy::Contact& each : study_.contacts()) {
    if (contactOpacity(study_, index_, each.at_P) == 0.0) continue;
    const QPointF away = placeOf(each.at_P) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance > reach) continue;
    reach = distance;
    nearest = each.number;
  }
  return nearest;
}

std::optional<Eigen::Vector3d> PlaneView::held_P() const
{
  if (dragged_) return study_.marks()[*dragged_];
  if (heldMarkup_ && heldMarkup_->markup < study_.markups().size())
    return study_.markups()[heldMarkup_->markup].points_P[heldMarkup_->point];
  for (const CtStudy::Contact& each : study_.contacts())
    if (heldContact_ != 0 && each.number == heldContact_) return each.at_P;
  return std::nullopt;
}

bool PlaneView::event(QEvent* event)
{
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  if (const auto mark = markAt(help.pos()))
    QToolTip::showText(help.globalPos(), markName(*mark), this);
  else if (const auto markup = markupAt(help.pos()))
    QToolTip::showText(help.globalPos(), structureName(study_.markups()[markup->markup].kind),
                       this);
  else
    QToolTip::hideText();
  return true;
}

void PlaneView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), colorOf(figures::onCt::ground));
  if (study_.hasCt()) paintPlane(painter);
  if (hasFocus()) paintFocusRing(painter, rect());
}

void PlaneView::paintPlane(QPainter& painter)
{
  painter.drawImage(0, 0,
                    pictureOf(study_, plane(), size(), devicePixelRatioF(), study_.pixel_mm()));
  paintOverlay(painter, size(), study_, index_, dragged_);
  if (const auto held = held_P()) paintLoupe(painter, *held);
}

void PlaneView::paintLoupe(QPainter& painter, const Eigen::Vector3d& about_P)
{
  ct::ViewPlane about = plane();
  about.center_P = about_P;
  // away from the mouse, so that neither covers the other
  const bool isLeft = placeOf(about_P).x() > 0.5 * width();
  const QRect area(isLeft ? spacing : width() - loupe_px - spacing,
                   height() - loupe_px - 4 * spacing, loupe_px, loupe_px);
  painter.drawImage(area.topLeft(), pictureOf(study_, about, area.size(), devicePixelRatioF(),
                                              study_.pixel_mm() / loupeTimes));
  painter.setPen(QPen(colorOf(figures::onCt::mark), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);
  const QPointF center = QRectF(area).center();
  for (const QPointF& along : {QPointF(1, 0), QPointF(0, 1)}) {
    painter.drawLine(center + 4 * along, center + 14 * along);
    painter.drawLine(center - 4 * along, center - 14 * along);
  }
}

void PlaneView::mousePressEvent(QMouseEvent* event)
{
  mouse_ = event->localPos();
  if (!study_.hasCt() || event->button() != Qt::LeftButton ||
      (event->modifiers() & Qt::ShiftModifier) != 0)
    return;
  if (placed_) {
    const ct::Mark mark = *placed_;
    placed_.reset();
    study_.beginChange();
    dragged_ = mark;
    study_.placeMark(mark, pointAt(mouse_));
    Q_EMIT markPlaced(mark);
  } else if ((heldMarkup_ = markupAt(mouse_))) {
    study_.beginChange();
    update();
  } else if (marked_) {
    study_.addPoint(*marked_, pointAt(mouse_));
    heldMarkup_ = markupAt(mouse_);
  } else if ((heldContact_ = contactAt(mouse_)) != 0) {
    isContactMoved_ = false;
    study_.chooseContact(heldContact_);
  } else if ((dragged_ = markAt(mouse_))) {
    study_.beginChange();
    update();
  } else {
    study_.moveCrosshair(pointAt(mouse_));
  }
}

void PlaneView::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF moved = event->localPos() - mouse_;
  mouse_ = event->localPos();
  if (!study_.hasCt()) return;
  const Qt::MouseButtons held = event->buttons();
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (held == Qt::NoButton) {
    setCursor(markAt(mouse_) || markupAt(mouse_) || contactAt(mouse_) != 0 ? Qt::PointingHandCursor
                                                                           : Qt::CrossCursor);
  } else if ((held & Qt::MiddleButton) != 0 || ((held & Qt::LeftButton) != 0 && isShift)) {
    const ct::ViewPlane own = plane();
    study_.pan(-study_.pixel_mm() * (moved.x() * own.right_P + moved.y() * own.down_P));
  } else if ((held & Qt::RightButton) != 0) {
    const imaging::GrayWindow now = study_.window();
    study_.setWindow({now.center + moved.y() * now.width / height(),
                      now.width * std::exp(2.0 * moved.x() / width())});
  } else if (heldContact_ != 0) {
    const auto point_P = held_P();
    if (!point_P) return;
    isContactMoved_ = true;
    // its distance from the plane is kept
    study_.moveContact(heldContact_, pointAt(mouse_) + plane().behind(*point_P) * plane().away_P());
  } else if (heldMarkup_) {
    const auto point_P = held_P();
    if (!point_P) return;
    // its distance from the plane is kept
    study_.moveMarkupPoint(*heldMarkup_,
                           pointAt(mouse_) + plane().behind(*point_P) * plane().away_P());
  } else if (dragged_) {
    const auto& point = study_.marks()[*dragged_];
    const double behind = point ? plane().behind(*point) : 0.0;
    // its distance from the plane is kept
    study_.placeMark(*dragged_, pointAt(mouse_) + behind * plane().away_P());
  } else if ((held & Qt::LeftButton) != 0) {
    study_.moveCrosshair(pointAt(mouse_));
  }
}

void PlaneView::mouseReleaseEvent(QMouseEvent*)
{
  const auto moved_P = held_P();
  const int contact = std::exchange(heldContact_, 0);
  dragged_.reset();
  update();
  if (heldMarkup_.has_value()) study_.beginChange();
  heldMarkup_.reset();
  if (contact != 0 && moved_P && std::exchange(isContactMoved_, false))
    Q_EMIT contactMoved(contact, *moved_P);
}

void PlaneView::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton) Q_EMIT maximizeRequested();
}

void PlaneView::stepLayers(double layers)
{
  if (!study_.hasCt()) return;
  const double step_mm = study_.volume()->spacing_mm().minCoeff();
  study_.moveCrosshair(study_.crosshair_P() + layers * step_mm * plane().away_P());
}

void PlaneView::wheelEvent(QWheelEvent* event)
{
  event->accept();
  wheelRest_ += event->angleDelta().y() / 120.0;
  const double notches = std::trunc(wheelRest_);  // touch pads send fractions
  wheelRest_ -= notches;
  if (!study_.hasCt() || notches == 0.0) return;
  if ((event->modifiers() & Qt::ControlModifier) != 0)
    study_.zoom(std::pow(zoomPerNotch, notches));
  else
    stepLayers(notches);
}

void PlaneView::nudgeContact(const Eigen::Vector2d& by_mm)
{
  const int number = study_.chosenContact();
  for (const CtStudy::Contact& each : study_.contacts()) {
    if (each.number != number) continue;
    const ct::ViewPlane own = plane();
    const Eigen::Vector3d point_P = each.at_P + by_mm.x() * own.right_P + by_mm.y() * own.down_P;
    study_.moveContact(number, point_P);
    Q_EMIT contactMoved(number, point_P);
    return;
  }
}

void PlaneView::keyPressEvent(QKeyEvent* event)
{
  if ((event->modifiers() & Qt::ShiftModifier) != 0 && study_.chosenContact() != 0) {
    switch (event->key()) {
      case Qt::Key_Left:
        return nudgeContact({-nudge_mm, 0.0});
      case Qt::Key_Right:
        return nudgeContact({nudge_mm, 0.0});
      case Qt::Key_Up:
        return nudgeContact({0.0, -nudge_mm});
      case Qt::Key_Down:
        return nudgeContact({0.0, nudge_mm});
      default:
        break;
    }
  }
  switch (event->key()) {
    case Qt::Key_Up:
      return stepLayers(1.0);
    case Qt::Key_Down:
      return stepLayers(-1.0);
    case Qt::Key_Plus:
      return study_.zoom(zoomPerNotch);
    case Qt::Key_Minus:
      return study_.zoom(1.0 / zoomPerNotch);
    default:
      return QWidget::keyPressEvent(event);
  }
}

}  // namespace perilymph::gui

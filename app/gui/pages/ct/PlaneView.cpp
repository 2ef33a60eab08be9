// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/PlaneView.h"

#include <Eigen/Geometry>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/pages/ct/CtText.h"
#include "gui/pages/ct/PlaneOverlay.h"
#include "gui/text/DataText.h"
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
QImage sampledPicture(CtStudy& study, const ct::ViewPlane& plane, const QSize& size, double ratio,
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
  connect(&study, &CtStudy::markupsRenumbered, this, [this] { heldMarkup_.reset(); });
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
    // the line of approach has a handle of its own
    if (markups[k].kind == ct::MarkupKind::approach ||
        markupOpacity(study_, index_, markups[k]) == 0.0)
      continue;
    for (std::size_t point = 0; point < markups[k].points_P.size(); ++point) {
      const QPointF away = placeOf(markups[k].points_P[point]) - place;
      const double distance = std::hypot(away.x(), away.y());
      if (distance > reach) continue;
      reach = distance;
      nearest = CtStudy::MarkupPoint{k, point};
    }
  }
  return nearest;
}

void PlaneView::placeToolPoint(const Eigen::Vector3d& point_P)
{
  if (!study_.volume()->contains(point_P))
    return Q_EMIT refused(tr("This place is outside the CT. Click into the picture."));
  if (study_.tool() != ct::MarkupKind::note) return study_.placeToolPoint(point_P);
  askText(tr("Text of the note"), {}, placeOf(point_P), [this, point_P](const QString& text) {
    if (text.isEmpty()) return;
    const auto added = study_.addMarkups({{ct::MarkupKind::note, {point_P}, text.toStdString()}});
    if (!added) Q_EMIT refused(dataText(added.error().message));
  });
}

void PlaneView::askText(const QString& name, const QString& text, const QPointF& place,
                        std::function<void(const QString&)> then)
{
  constexpr int width_px = 320;
  delete typed_;
  typed_ = new QLineEdit(text, this);
  typed_->setObjectName(QStringLiteral("markupText"));
  typed_->setAccessibleName(name);
  typed_->setPlaceholderText(name);
  typed_->setMaxLength(int(ct::maxMarkupText));
  const int wide = std::min(sized(width_px), width() - 2 * spacing);
  typed_->resize(wide, typed_->sizeHint().height());
  const QPoint corner = place.toPoint() + QPoint(spacing, spacing);
  typed_->move(
      std::clamp(corner.x(), spacing, std::max(spacing, width() - wide - spacing)),
      std::clamp(corner.y(), spacing, std::max(spacing, height() - typed_->height() - spacing)));
  thenTyped_ = std::move(then);
  typed_->installEventFilter(this);
  typed_->show();
  typed_->setFocus();
}

bool PlaneView::cancelText()
{
  if (!typed_) return false;
  typed_->hide();
  typed_->deleteLater();  // it may be the one that calls
  typed_ = nullptr;
  setFocus();
  return true;
}

void PlaneView::editText(std::size_t markup)
{
  const ct::Markup& known = study_.markups()[markup];
  askText(tr("Text of the markup"), QString::fromStdString(known.text), placeOf(known.points_P[0]),
          [this, known](const QString& text) {
            // another one may stand at its place by now
            const auto found = std::ranges::find(study_.markups(), known);
            if (found == study_.markups().end()) return;
            const auto named = study_.setMarkupText(std::size_t(found - study_.markups().begin()),
                                                    text.toStdString());
            if (!named) Q_EMIT refused(dataText(named.error().message));
          });
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
  if (study_.tool()) return true;  // it would cover what is measured
  const auto& help = static_cast<const QHelpEvent&>(*event);
  if (const auto mark = markAt(help.pos()))
    QToolTip::showText(help.globalPos(), markName(*mark), this);
  else if (const auto markup = markupAt(help.pos()))
    QToolTip::showText(
        help.globalPos(),
        tr("%1. Drag its points; Del removes it; a double click writes its text. ± is "
           "the 95 % interval of placing points to voxels.")
            .arg(markupName(study_.markups()[markup->markup].kind)),
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
  painter.drawImage(
      0, 0, sampledPicture(study_, plane(), size(), devicePixelRatioF(), study_.pixel_mm()));
  OverlayState state{dragged_};
  if (cursor_ && !typed_) state.cursor = pointAt(*cursor_);
  paintOverlay(painter, size(), study_, index_, study_.pixel_mm(), state);
  if (const auto held = held_P()) paintLoupe(painter, *held);
}

QImage PlaneView::pictureOf(const QSize& size_px, double ratio) const
{
  const QSize logical(int(size_px.width() / ratio), int(size_px.height() / ratio));
  const double pixel_mm = study_.pixel_mm() * std::max(double(width()) / logical.width(),
                                                       double(height()) / logical.height());
  QImage picture = sampledPicture(study_, plane(), logical, ratio, pixel_mm)
                       .convertToFormat(QImage::Format_RGB32);
  QPainter painter(&picture);
  paintOverlay(painter, logical, study_, index_, pixel_mm, {{}, {}, false});
  painter.end();
  picture.setDevicePixelRatio(1.0);
  return picture;
}

void PlaneView::paintLoupe(QPainter& painter, const Eigen::Vector3d& about_P)
{
  ct::ViewPlane about = plane();
  about.center_P = about_P;
  // away from the mouse, so that neither covers the other
  const bool isLeft = placeOf(about_P).x() > 0.5 * width();
  const QRect area(isLeft ? spacing : width() - loupe_px - spacing,
                   height() - loupe_px - 4 * spacing, loupe_px, loupe_px);
  painter.drawImage(area.topLeft(), sampledPicture(study_, about, area.size(), devicePixelRatioF(),
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
  cancelText();
  if (study_.tool() && !placed_) {
    placeToolPoint(pointAt(mouse_));
  } else if (placed_) {
    const ct::Mark mark = *placed_;
    placed_.reset();
    study_.beginChange();
    dragged_ = mark;
    study_.placeMark(mark, pointAt(mouse_));
    Q_EMIT markPlaced(mark);
  } else if (marked_) {
    if (!markupAt(mouse_)) study_.addPoint(*marked_, pointAt(mouse_));
    heldMarkup_ = markupAt(mouse_);
    study_.beginChange();
  } else if ((heldContact_ = contactAt(mouse_)) != 0) {
    isContactMoved_ = false;
    study_.chooseContact(heldContact_);
  } else if ((dragged_ = markAt(mouse_))) {
    study_.beginChange();
    update();
  } else if ((heldMarkup_ = markupAt(mouse_))) {
    study_.beginChange();
    study_.chooseMarkup(heldMarkup_->markup);
  } else {
    study_.moveCrosshair(pointAt(mouse_));
  }
}

void PlaneView::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF moved = event->localPos() - mouse_;
  mouse_ = event->localPos();
  cursor_ = mouse_;
  if (!study_.hasCt()) return;
  const Qt::MouseButtons held = event->buttons();
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (held == Qt::NoButton) {
    const bool isPoint = markAt(mouse_) || markupAt(mouse_) || contactAt(mouse_) != 0;
    setCursor(isPoint && !study_.tool() ? Qt::PointingHandCursor : Qt::CrossCursor);
    update();  // the value under the mouse
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
  } else if (heldMarkup_) {
    const auto point_P = held_P();
    if (!point_P) return;
    // its distance from the plane is kept
    study_.moveMarkupPoint(*heldMarkup_,
                           pointAt(mouse_) + plane().behind(*point_P) * plane().away_P());
  } else if ((held & Qt::LeftButton) != 0 && !study_.tool()) {
    study_.moveCrosshair(pointAt(mouse_));
  }
}

void PlaneView::mouseReleaseEvent(QMouseEvent*)
{
  const auto moved_P = held_P();
  const int contact = std::exchange(heldContact_, 0);
  dragged_.reset();
  if (heldMarkup_.has_value()) study_.beginChange();
  heldMarkup_.reset();
  update();
  if (contact != 0 && moved_P && std::exchange(isContactMoved_, false))
    Q_EMIT contactMoved(contact, *moved_P);
}

void PlaneView::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() != Qt::LeftButton) return;
  if (study_.tool())
    return placeToolPoint(pointAt(event->localPos()));  // the second of two quick clicks
  if (const auto markup = markupAt(event->localPos())) return editText(markup->markup);
  Q_EMIT maximizeRequested();
}

void PlaneView::leaveEvent(QEvent* event)
{
  cursor_.reset();
  update();
  QWidget::leaveEvent(event);
}

void PlaneView::focusInEvent(QFocusEvent* event)
{
  QWidget::focusInEvent(event);
  Q_EMIT chosen();
}

bool PlaneView::eventFilter(QObject* watched, QEvent* event)
{
  if (watched != typed_ || event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  // handled here: from the field it would go on to the window, whose tool places a point by it
  const QString line = typed_->text().simplified();
  const auto then = std::exchange(thenTyped_, {});
  cancelText();
  then(line);
  return true;
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

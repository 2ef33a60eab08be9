// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/SceneLabels.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/scene/PictureLabel.h"
#include "gui/widgets/FocusRing.h"
#include "gui/widgets/LabelPlaces.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

using Kind = visualization::SceneAnchor::Kind;

constexpr int label_px = 12, padding_px = 4, noteWidth_px = 300;
constexpr double handleRadius_px = 11.0;
constexpr int everyFew = 5;

QString textOf(const visualization::SceneAnchor& anchor)
{
  switch (anchor.kind) {
    case Kind::roundWindow:
      return SceneLabels::tr("Round window");
    case Kind::basalTurnAxis:
      return SceneLabels::tr("Axis of the basal turn");
    case Kind::approach:
      return SceneLabels::tr("Line of approach");
    case Kind::other:
      return QString::fromStdString(anchor.name);
    case Kind::contact:
      break;
  }
  return QString::number(anchor.number);
}

/// A smaller rank is placed earlier.
int rankOf(const visualization::SceneAnchor& anchor, int contacts)
{
  if (anchor.kind != Kind::contact) return 0;
  if (anchor.number == 1 || anchor.number == contacts) return 1;
  return anchor.number % everyFew == 0 ? 2 : 3;
}

}  // namespace

std::vector<PlacedLabel> placedLabels(const std::vector<visualization::SceneAnchor>& anchors,
                                      double ratio, const QRectF& pane, const QFont& font,
                                      const std::vector<QRectF>& taken)
{
  const auto contacts = static_cast<int>(std::ranges::count_if(
      anchors, [](const auto& anchor) { return anchor.kind == Kind::contact; }));
  std::vector<visualization::SceneAnchor> ordered;
  for (const auto& anchor : anchors) {
    const QPointF at(anchor.at_px.x() / ratio, anchor.at_px.y() / ratio);
    const bool isCovered =
        std::ranges::any_of(taken, [&at](const QRectF& area) { return area.contains(at); });
    if (pane.contains(at) && !isCovered) ordered.push_back(anchor);
  }
  std::ranges::stable_sort(ordered, {},
                           [contacts](const auto& anchor) { return rankOf(anchor, contacts); });
  const QFontMetricsF metrics(font);
  std::vector<PlacedLabel> labels;
  std::vector<LabelledPoint> points;
  for (const auto& anchor : ordered) {
    const QPointF at(anchor.at_px.x() / ratio, anchor.at_px.y() / ratio);
    labels.push_back({textOf(anchor), at, {}});
    points.push_back(
        {at,
         {metrics.horizontalAdvance(labels.back().text) + 2 * padding_px, metrics.height() + 2}});
  }
  const std::vector<QRectF> places = placeLabels(points, pane, taken);
  for (std::size_t k = 0; k < labels.size(); ++k) labels[k].place = places[k];
  return labels;
}

SceneLabels::SceneLabels(QWidget& view)
    : QWidget(&view), view_(view), note_(pictureLabel(this, "sceneNote"))
{
  setObjectName(QStringLiteral("sceneLabels"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFont(typeface(label_px));
  note_->setWordWrap(true);
  note_->hide();
  setGeometry(view.rect());
  view.installEventFilter(this);
  lower();  // below read-outs and controls of the view
}

bool SceneLabels::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize) {
    setGeometry(view_.rect());
    placeNote();
  }
  return QWidget::eventFilter(watched, event);
}

void SceneLabels::setNote(const QString& note, const QPoint& place, int widest)
{
  if (note == note_->text() && place == notePlace_ && widest == widestNote_px_) return;
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  notePlace_ = place;
  widestNote_px_ = widest;
  placeNote();
}

void SceneLabels::placeNote()
{
  if (note_->text().isEmpty()) return;
  const QFontMetrics metrics(note_->font());
  const int wanted = std::min({sized(noteWidth_px), widestNote_px_,
                               metrics.horizontalAdvance(note_->text()) + 3 * spacing});
  note_->setGeometry({notePlace_, QSize(wanted, note_->heightForWidth(wanted))});
}

std::optional<QPointF> SceneLabels::handle() const
{
  if (!handle_) return std::nullopt;
  const double ratio = devicePixelRatioF();
  // within the view, wherever the picture is moved to
  const double aside = handleRadius_px + 2.0;
  return QPointF(std::clamp(handle_->at_px.x() / ratio, aside, std::max(aside, width() - aside)),
                 std::clamp(handle_->at_px.y() / ratio, aside, std::max(aside, height() - aside)));
}

bool SceneLabels::isHandleAt(const QPointF& place) const
{
  const auto at = handle();
  return at && QLineF(*at, place).length() <= 1.3 * handleRadius_px;
}

bool SceneLabels::isApproachHandleAt(const QPointF& place) const
{
  return approachHandle_ && QLineF(approachHandle_->at, place).length() <= 1.3 * handleRadius_px;
}

double SceneLabels::cutMotion_mm(const QPointF& moved) const
{
  if (!handle_) return 0.0;
  const Eigen::Vector2d per_mm = handle_->per_mm / devicePixelRatioF();
  return per_mm.dot(Eigen::Vector2d(moved.x(), moved.y())) / per_mm.squaredNorm();
}

void SceneLabels::follow(const visualization::BoneLayer* layer, std::vector<QRectF> taken,
                         bool isApproachTurnable)
{
  const bool isShown = layer != nullptr && layer->isVisible();
  setVisible(isShown);
  handle_ = isShown ? layer->handle() : std::nullopt;
  for (const QObject* child : view_.children())
    if (const auto* widget = qobject_cast<const QWidget*>(child);
        widget != nullptr && widget != this && widget->isVisible())
      taken.emplace_back(widget->geometry());
  if (note_->isVisible()) taken.emplace_back(note_->geometry());
  approachHandle_.reset();
  if (isShown && isApproachTurnable) {
    const double ratio = devicePixelRatioF();
    if (const auto held = layer->approachHandle(ratio * (handleRadius_px + 2.0)))
      approachHandle_ =
          TurnHandle{QPointF(held->at_px.x(), held->at_px.y()) / ratio, held->toViewer_mm};
  }
  const QPointF half(handleRadius_px, handleRadius_px);
  if (const auto at = handle()) taken.emplace_back(*at - half, *at + half);
  if (approachHandle_) taken.emplace_back(approachHandle_->at - half, approachHandle_->at + half);
  labels_ = isShown ? placedLabels(layer->anchors(), devicePixelRatioF(), rect(), font(), taken)
                    : std::vector<PlacedLabel>();
  update();
}

void SceneLabels::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  if (view_.hasFocus()) paintFocusRing(painter, rect());
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = shownTheme();
  QColor plate = theme.ground;
  plate.setAlphaF(0.78f);
  for (const PlacedLabel& label : labels_) {
    const QLineF leader = leaderLine(label.at, label.place);
    if (leader.isNull()) continue;
    painter.setPen(QPen(plate, 3.0));
    painter.drawLine(leader);
    painter.setPen(QPen(theme.text, 1.0));
    painter.drawLine(leader);
  }
  for (const PlacedLabel& label : labels_) {
    if (label.place.isNull()) continue;
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(label.place, 3.0, 3.0);
    painter.setPen(theme.text);
    painter.drawText(label.place, Qt::AlignCenter, label.text);
  }
  if (approachHandle_) {
    painter.setPen(QPen(theme.onAccent, 1.5));
    painter.setBrush(theme.accent);
    painter.drawEllipse(approachHandle_->at, handleRadius_px, handleRadius_px);
    // four arrows: it is dragged to any side
    for (const QPointF& one : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      const QPointF aside(-one.y(), one.x()), tip = approachHandle_->at + 8.0 * one;
      painter.drawLine(approachHandle_->at, tip);
      painter.drawLine(tip, tip - 3.0 * one + 2.5 * aside);
      painter.drawLine(tip, tip - 3.0 * one - 2.5 * aside);
    }
  }
  if (const auto at = handle()) {
    painter.setPen(QPen(theme.onAccent, 1.5));
    painter.setBrush(theme.accent);
    painter.drawEllipse(*at, handleRadius_px, handleRadius_px);
    // two arrows, along which it is dragged
    const Eigen::Vector2d along = handle_->per_mm.normalized();
    const QPointF one(along.x(), along.y()), aside(-along.y(), along.x());
    for (const double side : {-1.0, 1.0}) {
      const QPointF tip = *at + 7.5 * side * one;
      painter.drawLine(*at + 2.0 * side * one, tip);
      painter.drawLine(tip, tip - 3.5 * side * one + 3.0 * aside);
      painter.drawLine(tip, tip - 3.5 * side * one - 3.0 * aside);
    }
  }
}

}  // namespace perilymph::gui

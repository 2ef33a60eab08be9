// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/PlaneOverlay.h"

#include <Eigen/Geometry>
#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QStringList>
#include <QVector>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gui/pages/ct/CtText.h"
#include "gui/text/LandmarkText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/LabelPlaces.h"
#include "gui/widgets/Theme.h"
#include "perilymph/figures/FixedInks.h"

namespace perilymph::gui {

namespace onCt = figures::onCt;

namespace {

constexpr double crosshairGap_px = 9.0, markRadius_px = 5.0, minBar_px = 40.0;
constexpr double dimmestMark = 0.35;
constexpr double drawnApproach_mm = 20.0;  // of the line of approach: beyond the facial recess

/// Converts points of P to the picture.
struct Projector {
  ct::ViewPlane plane;
  double pixel_mm;
  QPointF center;

  QPointF operator()(const Eigen::Vector2d& place_mm) const
  {
    return center + QPointF(place_mm.x(), place_mm.y()) / pixel_mm;
  }
  QPointF operator()(const Eigen::Vector3d& point_P) const
  {
    return (*this)(plane.inPicture(point_P));
  }
};

void drawText(QPainter& painter, const QRectF& area, int alignment, const QString& text,
              const QColor& color)
{
  painter.setPen(colorOf(onCt::shadow));
  painter.drawText(area.translated(1, 1), alignment, text);
  painter.setPen(color);
  painter.drawText(area, alignment, text);
}

void paintCrosshair(QPainter& painter, const QSize& size, const CtStudy& study, std::size_t index,
                    const Projector& project)
{
  const auto planes = study.planes();
  const QPointF at = project(study.crosshair_P());
  const double reach = size.width() + size.height();
  for (std::size_t other = 0; other < planes.size(); ++other) {
    if (other == index) continue;
    // the other plane's line runs at right angles to its normal
    const Eigen::Vector3d along_P = planes[index].away_P().cross(planes[other].away_P());
    const QPointF along(planes[index].right_P.dot(along_P), planes[index].down_P.dot(along_P));
    painter.setPen(QPen(colorOf(onCt::planes[other]), 1.0));
    painter.drawLine(at - reach * along, at - crosshairGap_px * along);
    painter.drawLine(at + crosshairGap_px * along, at + reach * along);
  }
}

void paintOutline(QPainter& painter, const CtStudy& study, const Projector& project)
{
  if (!study.measures()) return;
  QVector<QLineF> lines;
  for (const ct::PictureLine& line : ct::wallOutline(*study.measures(), project.plane))
    lines.append(QLineF(project(line[0]), project(line[1])));
  painter.setPen(QPen(colorOf(onCt::shadow), 3.0));
  painter.drawLines(lines);
  painter.setPen(QPen(colorOf(onCt::outline), 1.5));
  painter.drawLines(lines);
}

/// The array where the plane cuts it: its section where it crosses, its edges where it runs along.
void paintArray(QPainter& painter, const CtStudy& study, const Projector& project)
{
  const auto& nodes = study.array().nodes;
  painter.setPen(QPen(colorOf(onCt::array), 1.5));
  painter.setBrush(Qt::NoBrush);
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const Eigen::Vector3d &from = nodes[k].center_P, &to = nodes[k + 1].center_P;
    const Eigen::Vector3d middle = 0.5 * (from + to);
    const double radius = 0.5 * (nodes[k].radius_mm + nodes[k + 1].radius_mm);
    const double behind = project.plane.behind(middle);
    if (std::fabs(behind) > radius) continue;
    const double cut_px = std::sqrt(radius * radius - behind * behind) / project.pixel_mm;
    const Eigen::Vector3d along = (to - from).normalized();
    const Eigen::Vector2d flat(project.plane.right_P.dot(along), project.plane.down_P.dot(along));
    const QPointF at = project(middle);
    if (flat.norm() < 0.7) {  // across the plane: its section
      painter.drawEllipse(at, cut_px, cut_px);
      continue;
    }
    // along the plane: both edges
    const QPointF aside = cut_px * QPointF(-flat.y(), flat.x()) / flat.norm();
    const QPointF half = 0.5 * (project(to) - project(from));
    painter.drawLine(at - half + aside, at + half + aside);
    painter.drawLine(at - half - aside, at + half - aside);
  }
}

/// Opacity of a landmark by its distance from the plane; 0 if it is not drawn.
double opacityOf(double behind_mm)
{
  const double distance = std::fabs(behind_mm);
  if (distance > markReach_mm) return 0.0;
  return 1.0 - (1.0 - dimmestMark) * distance / markReach_mm;
}

enum class Plate { none, dark };

/// Labels beside their points with lines to them, each on a free place.
class Labels {
public:
  Labels(QPainter& painter, const QRectF& pane) : painter_(painter), pane_(pane) {}

  /// Adds the label of a point; one outside the pane has none. A number or a note stands on a plate, because bone is as
  /// bright as type.
  void add(const QString& text, const QPointF& at, double opacity,
           const figures::Ink& ink = onCt::mark, Plate plate = Plate::none)
  {
    if (!pane_.contains(at)) return;
    const QFontMetricsF metrics(painter_.font());
    texts_.push_back({text, opacity, colorOf(ink), plate});
    points_.push_back({at, {metrics.horizontalAdvance(text) + 4.0, metrics.height()}});
  }

  void paint(const std::vector<QRectF>& taken)
  {
    const std::vector<QRectF> places = placeLabels(points_, pane_, taken);
    for (std::size_t k = 0; k < texts_.size(); ++k) {
      if (places[k].isNull()) continue;
      painter_.setOpacity(texts_[k].opacity);
      const QLineF leader = leaderLine(points_[k].at, places[k]);
      if (!leader.isNull()) {
        painter_.setPen(QPen(colorOf(onCt::shadow), 3.0));
        painter_.drawLine(leader);
        painter_.setPen(QPen(texts_[k].color, 1.0));
        painter_.drawLine(leader);
      }
      if (texts_[k].plate == Plate::dark) painter_.fillRect(places[k], colorOf(onCt::shadow));
      drawText(painter_, places[k], Qt::AlignCenter, texts_[k].text, texts_[k].color);
      painter_.setOpacity(1.0);
    }
  }

private:
  struct Text {
    QString text;
    double opacity;
    QColor color;
    Plate plate;
  };

  QPainter& painter_;
  QRectF pane_;
  std::vector<Text> texts_;
  std::vector<LabelledPoint> points_;
};

/// Contacts by number: a ring where a contact was seen, a dashed one where the spacings placed it, filled
/// where a person did.
void paintContacts(QPainter& painter, const CtStudy& study, std::size_t index,
                   const Projector& project, const QRectF& pane, Labels& labels)
{
  for (const CtStudy::Contact& each : study.contacts()) {
    const double opacity = contactOpacity(study, index, each.at_P);
    const QPointF at = project(each.at_P);
    if (opacity == 0.0 || !pane.contains(at)) continue;
    painter.setOpacity(opacity);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colorOf(onCt::shadow), 4.0));
    painter.drawEllipse(at, markRadius_px, markRadius_px);
    const QColor color =
        each.number == study.chosenContact() ? colorOf(onCt::outline) : colorOf(onCt::array);
    if (each.isByHand) painter.setBrush(color);
    painter.setPen(
        QPen(color, 1.8, each.isSeenSingly || each.isByHand ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(at, markRadius_px, markRadius_px);
    painter.setOpacity(1.0);
    labels.add(QString::number(each.number), at, opacity);
  }
  painter.setBrush(Qt::NoBrush);
}

/// A line where it is near the plane, as clearly as that.
void paintNear(QPainter& painter, const Projector& project, const Eigen::Vector3d& from_P,
               const Eigen::Vector3d& to_P, const QColor& color)
{
  constexpr double part_mm = 0.5;
  const int parts = std::max(1, int(std::ceil((to_P - from_P).norm() / part_mm)));
  for (int k = 0; k < parts; ++k) {
    const Eigen::Vector3d one = from_P + (to_P - from_P) * double(k) / parts;
    const Eigen::Vector3d other = from_P + (to_P - from_P) * double(k + 1) / parts;
    const double opacity = opacityOf(project.plane.behind(0.5 * (one + other)));
    if (opacity == 0.0) continue;
    painter.setOpacity(opacity);
    painter.setPen(QPen(colorOf(onCt::shadow), 4.0));
    painter.drawLine(project(one), project(other));
    painter.setPen(QPen(color, 1.8));
    painter.drawLine(project(one), project(other));
  }
  painter.setOpacity(1.0);
}

/// The line of approach where it is near the plane, and a cross where it passes through.
void paintApproach(QPainter& painter, const CtStudy& study, const Projector& project)
{
  const auto line = study.approachLine();
  if (!line) return;
  const QColor color = colorOf(onCt::approach);
  paintNear(painter, project, line->opening_P, line->at(drawnApproach_mm), color);
  const double slope = project.plane.away_P().dot(line->outward_P);
  const double outside = slope == 0.0 ? -1.0 : -project.plane.behind(line->opening_P) / slope;
  if (outside < 0.0 || outside > drawnApproach_mm) return;
  const QPointF at = project(line->at(outside));
  for (const double width : {4.0, 1.8}) {
    painter.setPen(QPen(width > 2.0 ? colorOf(onCt::shadow) : color, width));
    painter.drawLine(at - QPointF(5, 5), at + QPointF(5, 5));
    painter.drawLine(at - QPointF(5, -5), at + QPointF(5, -5));
  }
}

void paintMarks(QPainter& painter, const CtStudy& study, const Projector& project,
                const std::optional<ct::Mark>& dragged, Labels& labels)
{
  const ct::Marks& marks = study.marks();
  const auto isDrawn = [&](ct::Mark mark) {
    return marks[mark] && opacityOf(project.plane.behind(*marks[mark])) > 0.0;
  };
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const auto mark = static_cast<ct::Mark>(k);
    if (!isDrawn(mark)) continue;
    const double opacity = opacityOf(project.plane.behind(*marks[mark]));
    const QPointF at = project(*marks[mark]);
    painter.setOpacity(opacity);
    painter.setPen(QPen(colorOf(onCt::shadow), 4.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, markRadius_px, markRadius_px);
    painter.setPen(QPen(dragged == mark ? colorOf(onCt::outline) : colorOf(onCt::mark), 1.8));
    painter.drawEllipse(at, markRadius_px, markRadius_px);
    painter.setOpacity(1.0);
    labels.add(markLabel(mark), at, opacity);
  }
  for (const ct::MeasureLine& line : ct::measureLines) {
    const auto &one = marks[line.from], &other = marks[line.to];
    if (!one || !other || !(isDrawn(line.from) || isDrawn(line.to))) continue;
    if (!project.plane.runsAlong(*one, *other)) continue;
    const QPointF from = project(*one), to = project(*other);
    painter.setPen(QPen(colorOf(onCt::mark), 1.0, Qt::DashLine));
    painter.drawLine(from, to);
    // not in the middle, where A and B cross
    labels.add(QLatin1String(line.name), from + 0.3 * (to - from), 1.0);
  }
}

/// Where a markup's label points to: its rightmost point, so that a label to the right of it is on none of its lines.
QPointF labelled(const ct::Markup& markup, const Projector& project)
{
  QPointF rightmost = project(markup.points_P.front());
  for (const Eigen::Vector3d& point : markup.points_P)
    if (const QPointF at = project(point); at.x() > rightmost.x()) rightmost = at;
  return rightmost;
}

/// Lines between points in their order, and a ring at each: filled within the reach of the plane.
void paintPoints(QPainter& painter, const Projector& project,
                 const std::vector<Eigen::Vector3d>& points_P, const QColor& color)
{
  constexpr double radius_px = 3.5;
  QVector<QLineF> lines;
  for (std::size_t k = 0; k + 1 < points_P.size(); ++k)
    lines.append(QLineF(project(points_P[k]), project(points_P[k + 1])));
  for (const bool isShadow : {true, false}) {
    painter.setPen(isShadow ? QPen(colorOf(onCt::shadow), 4.0) : QPen(color, 1.5));
    painter.drawLines(lines);
    for (const Eigen::Vector3d& point : points_P) {
      const bool isNear = std::fabs(project.plane.behind(point)) <= markReach_mm;
      painter.setBrush(isNear && !isShadow ? QBrush(color) : QBrush(Qt::NoBrush));
      painter.drawEllipse(project(point), radius_px, radius_px);
    }
  }
  painter.setBrush(Qt::NoBrush);
}

void paintMarkups(QPainter& painter, const CtStudy& study, std::size_t plane,
                  const Projector& project, Labels& labels)
{
  const ct::CtMarkups whole = study.ctMarkups();
  for (std::size_t k = 0; k < whole.markups.size(); ++k) {
    const ct::Markup& each = whole.markups[k];
    if (each.kind == ct::MarkupKind::approach) continue;  // paintApproach() shows where it is
    const double opacity = markupOpacity(study, plane, each);
    if (opacity == 0.0) continue;
    const figures::Ink& ink = study.chosenMarkup() == k ? onCt::outline : onCt::markup;
    painter.setOpacity(opacity);
    paintPoints(painter, project, each.points_P, colorOf(ink));
    painter.setOpacity(1.0);
    // a long text would find no free place; the list of markups has all of it
    constexpr int longestText = 40;
    QString text = markupText(each, whole.voxelEdges_P);
    if (text.size() > longestText) text = text.left(longestText - 1) + QStringLiteral("…");
    labels.add(text, labelled(each, project), opacity, ink, Plate::dark);
  }
}

/// The markup that is placed now, up to the mouse.
void paintTool(QPainter& painter, const CtStudy& study, const Projector& project,
               const std::optional<Eigen::Vector3d>& cursor, Labels& labels)
{
  if (!study.tool() || study.toolPoints_P().empty()) return;
  ct::Markup begun{*study.tool(), study.toolPoints_P()};
  if (cursor) begun.points_P.push_back(*cursor);
  paintPoints(painter, project, begun.points_P, colorOf(onCt::outline));
  if (ct::checkMarkup(begun))
    labels.add(markupText(begun, study.ctMarkups().voxelEdges_P), labelled(begun, project), 1.0,
               onCt::outline, Plate::dark);
}

/// The letters of a picture's four directions and where they stand.
struct Letters {
  QString text;
  Qt::Alignment at;
  QRectF area;
};

std::array<Letters, 4> lettersOf(const QFontMetricsF& metrics, const QSize& size,
                                 const ct::ViewPlane& plane)
{
  const auto standing = [&](const Eigen::Vector3d& direction_P, Qt::Alignment at) {
    const QString text = QString::fromStdString(ct::directionLetters(direction_P));
    const QSizeF whole(metrics.horizontalAdvance(text) + 2 * spacing,
                       metrics.height() + 2 * spacing);
    const double right = size.width() - whole.width(), low = size.height() - whole.height();
    const double x = at.testFlag(Qt::AlignLeft)    ? 0.0
                     : at.testFlag(Qt::AlignRight) ? right
                                                   : 0.5 * right;
    const double y = at.testFlag(Qt::AlignTop)      ? 0.0
                     : at.testFlag(Qt::AlignBottom) ? low
                                                    : 0.5 * low;
    return Letters{text, at, {{x, y}, whole}};
  };
  return {standing(plane.right_P, Qt::AlignRight | Qt::AlignVCenter),
          standing(-plane.right_P, Qt::AlignLeft | Qt::AlignVCenter),
          standing(plane.down_P, Qt::AlignHCenter | Qt::AlignBottom),
          standing(-plane.down_P, Qt::AlignHCenter | Qt::AlignTop)};
}

double widestOf(const QFontMetricsF& metrics, const QStringList& lines)
{
  double widest = 0.0;
  for (const QString& line : lines) widest = std::max(widest, metrics.horizontalAdvance(line));
  return widest;
}

void paintScaleBar(QPainter& painter, const QSize& size, double pixel_mm)
{
  double length_mm = 0.1;
  for (const double factor : {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0}) {
    if (length_mm / pixel_mm >= minBar_px) break;
    length_mm *= factor;
  }
  const double length = length_mm / pixel_mm;
  const double right = size.width() - 1.5 * spacing, low = size.height() - 1.5 * spacing;
  painter.setPen(QPen(colorOf(onCt::shadow), 4.0));
  painter.drawLine(QPointF(right - length, low), QPointF(right, low));
  painter.setPen(QPen(colorOf(onCt::mark), 2.0));
  painter.drawLine(QPointF(right - length, low), QPointF(right, low));
  drawText(painter, QRectF(right - length - 60, low - 22, length + 60, 18),
           Qt::AlignRight | Qt::AlignBottom,
           QStringLiteral("%1 mm").arg(numberText(length_mm, length_mm < 1.0 ? 1 : 0)),
           colorOf(onCt::mark));
}

}  // namespace

QColor colorOfPlane(std::size_t plane) { return colorOf(onCt::planes[plane]); }

double contactOpacity(const CtStudy& study, std::size_t plane, const Eigen::Vector3d& contact_P)
{
  constexpr double arrayReach_mm = 6.0;  // the height of a cochlea: the array is seen as a whole
  const double behind_mm = study.planes()[plane].behind(contact_P);
  if (study.frame() != PlaneFrame::cochlea || plane != 0) return opacityOf(behind_mm);
  return std::fabs(behind_mm) > arrayReach_mm ? 0.0 : std::max(0.7, opacityOf(behind_mm));
}

double markupOpacity(const CtStudy& study, std::size_t plane, const ct::Markup& markup)
{
  const ct::ViewPlane own = study.planes()[plane];
  double nearest_mm = 2.0 * markReach_mm;
  bool isBehind = false, isBefore = false;
  for (const Eigen::Vector3d& point : markup.points_P) {
    const double behind_mm = own.behind(point);
    isBehind = isBehind || behind_mm >= 0.0;
    isBefore = isBefore || behind_mm <= 0.0;
    nearest_mm = std::min(nearest_mm, std::fabs(behind_mm));
  }
  // a line from one side to the other runs through the plane
  return opacityOf(isBehind && isBefore ? 0.0 : nearest_mm);
}

void paintOverlay(QPainter& painter, const QSize& size, const CtStudy& study, std::size_t plane,
                  double pixel_mm, const OverlayState& state)
{
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(typeface(13, QFont::DemiBold));
  const Projector project{study.planes()[plane], pixel_mm,
                          QPointF(0.5 * size.width(), 0.5 * size.height())};
  paintOutline(painter, study, project);
  paintArray(painter, study, project);
  paintApproach(painter, study, project);
  if (state.hasCrosshair) paintCrosshair(painter, size, study, plane, project);
  const QString name = planeName(study.frame(), plane);
  const QFontMetricsF metrics(painter.font());
  const QRectF pane(QPointF(0, 0), size);
  // name, letters of the four directions, scale bar
  std::vector<QRectF> taken{
      QRectF(0, 0, metrics.horizontalAdvance(name) + 2 * spacing, metrics.height() + 2 * spacing),
      QRectF(QPointF(size.width() - 110.0, size.height() - 36.0), pane.bottomRight())};
  const auto letters = lettersOf(metrics, size, project.plane);
  for (const Letters& each : letters) taken.push_back(each.area);
  QStringList cursor;
  if (state.cursor) cursor = cursorText(study, *state.cursor);
  const double cursorHeight = metrics.height() * double(cursor.size());
  const QRectF cursorArea(spacing, size.height() - spacing - cursorHeight,
                          widestOf(metrics, cursor), cursorHeight);
  if (!cursor.isEmpty()) taken.push_back(cursorArea);
  Labels labels(painter, pane);
  paintMarks(painter, study, project, state.dragged, labels);
  paintContacts(painter, study, plane, project, pane, labels);
  paintMarkups(painter, study, plane, project, labels);
  paintTool(painter, study, project, state.cursor, labels);
  labels.paint(taken);
  if (!cursor.isEmpty()) painter.fillRect(cursorArea.adjusted(-4, -2, 4, 2), colorOf(onCt::shadow));
  drawText(painter, cursorArea, Qt::AlignLeft, cursor.join(QLatin1Char('\n')), colorOf(onCt::mark));
  for (const Letters& each : letters) {
    const QRectF area = each.area.adjusted(spacing, spacing, -spacing, -spacing);
    if (cursor.isEmpty() || !area.intersects(cursorArea))  // in a narrow pane
      drawText(painter, area, each.at, each.text, colorOf(onCt::mark));
  }
  paintScaleBar(painter, size, pixel_mm);
  drawText(painter, QRectF(spacing, spacing, size.width(), 20), Qt::AlignLeft | Qt::AlignTop, name,
           colorOf(onCt::planes[plane]));
}

}  // namespace perilymph::gui

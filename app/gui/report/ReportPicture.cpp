// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportPicture.h"

#include <algorithm>
#include <cmath>

#include "gui/report/CochlearView.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

const QColor textInk = themeOf(ColorScheme::light).text;

/// The numbers of the contacts beside the array, on its side away from the modiolar axis; one that would
/// touch the last is left out.
void paintNumbers(ReportSheet& sheet, const CochlearView& view, const ReportContent& content)
{
  QPainter& painter = sheet.painter();
  painter.setFont(reportFont(sheet.font(ReportFace::label).pixelSize(), QFont::DemiBold));
  painter.setPen(textInk);
  const haptics::Snapshot& now = content.deepest;
  const electrode::ArrayDesign& array = content.scenario.array();
  const auto node = [&](std::size_t i) {
    return view.plane().at(double(now.node_W[i][0]), double(now.node_W[i][1]));
  };
  const QFontMetricsF metrics(painter.font(), painter.device());
  QRectF last;
  for (const analysis::ContactPosition& contact : content.contacts) {
    if (!contact.isInserted) continue;
    const Length fromTip = meters(now.output.depth) - contact.depth;
    const double place = (now.nodes - 1) * (1.0 - fromTip / array.length);
    const auto i = std::size_t(std::clamp(std::lround(place), 1L, long(now.nodes) - 2));
    const QPointF at = node(i), along = node(i + 1) - node(i - 1);
    QPointF aside(-along.y(), along.x());
    aside /= std::max(1e-9, std::hypot(aside.x(), aside.y()));
    if (QPointF::dotProduct(aside, at) < 0.0) aside = -aside;
    const double off_mm = 0.5 * inMillimeters(array.sectionAt(fromTip).within) + 0.6;
    const QString number = QString::number(contact.number);
    QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(number), metrics.ascent()));
    box.moveCenter(view(at + off_mm * aside));
    if (box.intersects(last)) continue;
    drawCentered(painter, box.center(), number);
    last = box;
  }
}

}  // namespace

void paintReportPicture(ReportSheet& sheet, const QRectF& place_mm, const ReportContent& content)
{
  QPainter& painter = sheet.painter();
  const QRectF place = sheet.dots(place_mm);
  const anatomy::Side side = content.scenario.patient().side;
  const CochlearView view(place, *content.anatomy, side);
  painter.save();
  painter.setClipRect(place);
  painter.setRenderHint(QPainter::Antialiasing);
  view.paintScala(painter, {*content.anatomy, content.scenario.array(), side, &content.deepest});
  paintNumbers(sheet, view, content);
  view.paintFrame(sheet);
  painter.restore();
}

}  // namespace perilymph::gui

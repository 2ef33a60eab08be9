// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/CtPicture.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/setup/KeyImage.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr int width_px = 680;  // in 1/96 inch: the text of an A4 page

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QImage ctPictureOf(const anatomy::Patient& patient)
{
  return patient.basalTurn ? QImage(QString::fromStdString(keyImageFile(patient).string()))
                           : QImage();
}

QImage cochlearViewOf(const anatomy::Patient& patient)
{
  const QImage whole = ctPictureOf(patient);
  return whole.copy(0, 0, whole.height(), whole.height());
}

void paintCtPicture(ReportSheet& sheet, const QRectF& place_mm, const QImage& view,
                    const anatomy::Patient& patient)
{
  // the shell of 16 mm around the cochlea says nothing of A and B
  constexpr double pixelsPerMillimeter = 32.0;  // imaging::writeMeasuredPicture()
  const double a_mm = inMillimeters(patient.basalTurn->a);
  const double shown_mm = std::min(1.35 * a_mm + 1.0, view.width() / pixelsPerMillimeter);
  const int edge = int(shown_mm * pixelsPerMillimeter), from = (view.width() - edge) / 2;
  QPainter& painter = sheet.painter();
  painter.drawImage(sheet.dots(place_mm), view, QRectF(from, from, edge, edge));
  // A runs down to the round window, B across; the names stand beside their ends
  const double scale = place_mm.width() / shown_mm;
  const auto write = [&](const QString& name, double x_mm, double y_mm) {
    painter.setFont(sheet.font(ReportFace::bold));
    painter.setPen(Qt::white);
    painter.drawText(sheet.dots({place_mm.center().x() + scale * x_mm,
                                 place_mm.center().y() + scale * y_mm, 5.0, 5.0}),
                     int(Qt::AlignLeft | Qt::AlignTop), name);
  };
  write(QStringLiteral("A"), 0.2, 0.36 * a_mm);
  write(QStringLiteral("B"), 0.36 * inMillimeters(patient.basalTurn->b), 0.1);
}

QString ctPictureText(const anatomy::Patient& patient)
{
  if (ctPictureOf(patient).isNull()) return {};
  return QStringLiteral("<h2>%1</h2><p><img src=\"ct\" width=\"%2\"></p><p>%3</p>")
      .arg(tr("The cochlea in the CT"))
      .arg(width_px)
      .arg(tr("Cochlear view and the mid-modiolar planes along A and along B: the fitted wall, the "
              "lines of A, B and H, and a bar of 5 mm."));
}

}  // namespace perilymph::gui

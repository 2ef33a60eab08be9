// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/CtPicture.h"

#include <QCoreApplication>

#include "gui/setup/KeyImage.h"

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

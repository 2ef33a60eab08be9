// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochlea in its CT, on the record and in the appendix of a report.

#include <QImage>
#include <QString>

#include "gui/report/ReportSheet.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// The picture kept with these measures; a null image if they were typed or come from elsewhere.
QImage ctPictureOf(const anatomy::Patient& patient);

/// The cochlear view alone; a null image where there is none.
QImage cochlearViewOf(const anatomy::Patient& patient);

/// Paints the cochlear view in a square [mm], with the names of the lines of A and B.
void paintCtPicture(ReportSheet& sheet, const QRectF& place_mm, const QImage& view,
                    const anatomy::Patient& patient);

/// A heading, the picture by the name `ct`, and what it shows; empty if there is none.
QString ctPictureText(const anatomy::Patient& patient);

}  // namespace perilymph::gui

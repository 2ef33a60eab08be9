// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochlea in its CT, in the appendix of a report.

#include <QImage>
#include <QString>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// The picture kept with these measures; a null image if they were typed or come from elsewhere.
QImage ctPictureOf(const anatomy::Patient& patient);

/// A heading, the picture by the name `ct`, and what it shows; empty if there is none.
QString ctPictureText(const anatomy::Patient& patient);

}  // namespace perilymph::gui

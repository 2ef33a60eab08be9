// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The angles of an approach to the basal turn of an ear, as text for pages and reports.

#include <QString>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/Approach.h"

namespace perilymph::gui {

/// "5.0° toward the lateral wall in the plane of the basal turn, 3.0° toward the basilar membrane out of
/// it"; "along the axis of the opening" there, or where the cochlea cannot be built.
QString approachText(const anatomy::Cochlea& cochlea, const anatomy::Approach& approach);

}  // namespace perilymph::gui

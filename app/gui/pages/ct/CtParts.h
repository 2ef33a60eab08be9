// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the page CT sends to an archive.

#include <vector>

#include "gui/archive/SendDialog.h"
#include "gui/pages/ct/CtStudy.h"

namespace perilymph::gui {

/// Measures as a structured report, the lumen as a segmentation and the picture as a secondary
/// capture, of a study that is measured.
std::vector<SentPart> ctParts(const CtStudy& study);

}  // namespace perilymph::gui

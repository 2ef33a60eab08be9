// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of the landmarks of a cochlea in the user's language.

#include <QString>

#include "perilymph/ct/Marks.h"

namespace perilymph::gui {

/// "RW", "LW", "base": the clinical short name, in pictures and reports. Files have ct::nameOf().
QString markLabel(ct::Mark mark);

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The picture of a patient's cochlea in the CT that it was measured in, kept for reports.

#include <filesystem>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// Where the picture of these measures is kept: in `key-images` beside the patients. Other measures of the
/// same ear have another file; typed measures have none.
std::filesystem::path keyImageFile(const anatomy::Patient& patient);

}  // namespace perilymph::gui

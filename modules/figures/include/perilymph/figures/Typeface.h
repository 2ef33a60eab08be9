// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The font of charts and 3D views.

#include <string>

namespace perilymph::figures {

/// Path of the Inter font file: the shipped one, else the system's, else DejaVu Sans; empty if
/// there is none.
const std::string& typefaceFile();

}  // namespace perilymph::figures

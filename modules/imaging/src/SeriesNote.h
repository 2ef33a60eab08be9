// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How the points of a markups file name the CT series that they are of.

#include <string>

namespace perilymph::imaging {

/// Followed by 64 hexadecimal digits in a point's description.
inline const std::string seriesNote = "of the CT series with SHA-256 ";

}  // namespace perilymph::imaging

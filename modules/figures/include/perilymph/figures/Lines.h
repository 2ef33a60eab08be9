// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How wide a text is, and its lines within a width, without a typeface at hand.

#include <string>
#include <vector>

namespace perilymph::figures {

/// Width of a text of this size, estimated from the number of its letters; in the unit of the size.
double widthOf(const std::string& text, double size);

/// The text in lines of at most this width, broken between words; a longer word is a line.
std::vector<std::string> linesOf(const std::string& text, double size, double width);

}  // namespace perilymph::figures

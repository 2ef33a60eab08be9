// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An electrode array as text, for arrays that a program changes.

#include <string>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::electrode {

/// Text of an array for loadArray() and parseArray(), which give the same array, bit for bit. A table
/// whose source the array does not state is "not stated", of low confidence.
std::string arrayText(const ArrayDesign& array);

/// Reads an array from the text of its file; `name` stands for the file in messages.
Result<ArrayDesign> parseArray(const std::string& text, const std::string& name);

}  // namespace perilymph::electrode

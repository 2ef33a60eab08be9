// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// "Did you mean": the known word nearest to a misspelled one.

#include <string>
#include <string_view>
#include <vector>

namespace perilymph {

/// The candidate that differs from `word` by few letters or only by its unit (`speed` for
/// `speed_mm_s`); empty if there is none.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace perilymph

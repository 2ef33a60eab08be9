#pragma once

// "Did you mean": the known word nearest to one that was mistyped.

#include <string>
#include <string_view>
#include <vector>

namespace perilymph {

/// The candidate that differs from `word` by few letters, or by its unit alone (`speed` for
/// `speed_mm_s`); empty if none is near.
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names in a plan.json that its writer and its reader share.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "perilymph/foundation/Choice.h"

namespace perilymph::planning {

/// Where the errors of the measures come from.
enum class ErrorSource { measured, assumed };
inline constexpr std::array errorSources{
    Choice<ErrorSource>{ErrorSource::measured, "as measured"},
    Choice<ErrorSource>{ErrorSource::assumed, "assumed: 0.1 mm, about a voxel"}};

/// How sure a source is.
inline constexpr std::array confidences{Choice<int>{0, "high"}, Choice<int>{1, "medium"},
                                        Choice<int>{2, "low"}};

/// The largest seed: the largest whole number that every reader of TOML and JSON keeps.
inline constexpr std::int64_t maxSeed = (std::int64_t{1} << 53) - 1;

/// The name of an array or a friction that is named or given as a file, without folder and ending.
inline std::string bareName(const std::string& nameOrFile)
{
  const std::filesystem::path file(nameOrFile);
  return (file.extension() == ".toml" ? file.stem() : file.filename()).string();
}

}  // namespace perilymph::planning

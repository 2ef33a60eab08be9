// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace perilymph::cli {

/// JSON text as written by this program. Bytes that are not UTF-8, possible in names of files and
/// devices, are replaced by U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json)
{
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace perilymph::cli

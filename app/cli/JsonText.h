#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace perilymph::cli {

/// JSON as this program writes it. U+FFFD stands in place of bytes that are not UTF-8, which names
/// of files and devices may hold.
inline std::string jsonText(const nlohmann::ordered_json& json)
{
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace perilymph::cli

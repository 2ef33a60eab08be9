// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace perilymph::planning {

/// What clinics report of an array, with sources, and how the program's clinical table judges it.
nlohmann::ordered_json clinicalJson(const std::string& array);

}  // namespace perilymph::planning

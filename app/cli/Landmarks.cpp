// SPDX-License-Identifier: BSD-3-Clause
#include "Landmarks.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::cli {

namespace {

using Json = nlohmann::json;

std::optional<Eigen::Vector3d> pointOf(const Json& control, bool isRas)
{
  const auto place = control.find("position");
  if (place == control.end() || !place->is_array() || place->size() != 3) return std::nullopt;
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(*place)[i].is_number()) return std::nullopt;
    point[static_cast<Eigen::Index>(i)] = (*place)[i].get<double>();
  }
  if (!point.allFinite()) return std::nullopt;
  if (isRas) point.head<2>() = -point.head<2>();
  return point;
}

std::string textOf(const Json& object, const char* key)
{
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Adds the points of one list; false where it is not one that can be read.
bool addPoints(const Json& markup, Landmarks& landmarks)
{
  if (!markup.is_object()) return false;
  const std::string system = textOf(markup, "coordinateSystem");
  const auto points = markup.find("controlPoints");
  const bool isRas = system == "RAS" || system == "0";
  if (!isRas && system != "LPS" && system != "1") return false;
  if (points == markup.end() || !points->is_array()) return false;
  for (const Json& control : *points) {
    if (!control.is_object()) return false;
    const std::string label = textOf(control, "label");
    const std::string status = textOf(control, "positionStatus");
    std::optional<Eigen::Vector3d>* const kept = label == "RW"  ? &landmarks.roundWindow_P
                                                 : label == "C" ? &landmarks.center_P
                                                 : label == "A" ? &landmarks.apex_P
                                                                : nullptr;
    if (!kept || (!status.empty() && status != "defined")) continue;
    *kept = pointOf(control, isRas);
    if (!*kept) return false;
  }
  return true;
}

}  // namespace

Eigen::Vector3d Landmarks::inside_P() const
{
  // The modiolus, a third of the way up, lies amid the turns.
  if (center_P && apex_P) return 0.7 * *center_P + 0.3 * *apex_P;
  if (center_P) return *center_P;
  if (roundWindow_P && apex_P) return 0.5 * (*roundWindow_P + *apex_P);
  return apex_P ? *apex_P : *roundWindow_P;
}

Result<Landmarks> readLandmarks(const std::filesystem::path& file)
{
  const auto content = readWhole(file);
  if (!content) return content.error();
  const Error other{file.string() +
                    " is no Slicer markups file with points named RW, C or A in LPS or RAS. Save "
                    "the points in Slicer as Markups JSON (.mrk.json)."};
  const Json json = Json::parse(*content, nullptr, false);
  if (!json.is_object()) return other;
  const auto markups = json.find("markups");
  if (markups == json.end() || !markups->is_array()) return other;
  Landmarks landmarks;
  for (const Json& markup : *markups)
    if (!addPoints(markup, landmarks)) return other;
  if (!landmarks.roundWindow_P && !landmarks.center_P && !landmarks.apex_P) return other;
  return landmarks;
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/Landmarks.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {

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
bool addPoints(const Json& markup, ct::Marks& marks)
{
  if (!markup.is_object()) return false;
  const std::string system = textOf(markup, "coordinateSystem");
  const auto points = markup.find("controlPoints");
  const bool isRas = system == "RAS" || system == "0";
  if (!isRas && system != "LPS" && system != "1") return false;
  if (points == markup.end() || !points->is_array()) return false;
  for (const Json& control : *points) {
    if (!control.is_object()) return false;
    const std::optional<ct::Mark> mark = ct::markNamed(textOf(control, "label"));
    const std::string status = textOf(control, "positionStatus");
    if (!mark || (!status.empty() && status != "defined")) continue;
    marks[*mark] = pointOf(control, isRas);
    if (!marks[*mark]) return false;
  }
  return true;
}

}  // namespace

Result<ct::Marks> readLandmarks(const std::filesystem::path& file)
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
  ct::Marks marks;
  for (const Json& markup : *markups)
    if (!addPoints(markup, marks)) return other;
  if (!marks[ct::Mark::roundWindow] && !marks[ct::Mark::modiolus] && !marks[ct::Mark::apex])
    return other;
  return marks;
}

}  // namespace perilymph::imaging

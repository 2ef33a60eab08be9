// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The JSON of markups files of 3D Slicer (.mrk.json): lists of control points in LPS or RAS.

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Points with their labels, in P [mm].
using LabeledPoints = std::vector<std::pair<std::string, Eigen::Vector3d>>;

/// A list of points in LPS. The description of each point names the series, if one is given.
///
/// @param type  "Fiducial", "Line", "Angle" or "Curve".
nlohmann::json markupJson(const char* type, const std::string& name, const std::string& seriesKey,
                          const LabeledPoints& points);

/// The text of a file with these lists.
std::string markupsText(const nlohmann::json& markups);

/// A text of an object; empty where it has none of this key.
std::string textOf(const nlohmann::json& object, const char* key);

/// How a list gives its coordinates.
struct MarkupCoordinates {
  bool isRas = false;
  double mm = 1.0;  ///< Length of one unit.
};

/// Coordinate system and unit of a list, by the schema LPS and millimeters where it states none; empty where it names
/// others than are known.
std::optional<MarkupCoordinates> coordinatesOf(const nlohmann::json& markup);

/// The position of a control point in P [mm]; empty where it has none that is finite.
std::optional<Eigen::Vector3d> controlPointOf(const nlohmann::json& control,
                                              const MarkupCoordinates& coordinates);

/// Whether a control point was placed by a person: a preview and an undefined one were not.
bool isDefined(const nlohmann::json& control);

/// Reads the lists of a file. Refuses a text that is none, keys that an object has twice, of which other parsers
/// take one or the other, units that are not known, and points that this program placed in another series.
///
/// @param none  The message for a file without lists of points.
Result<std::vector<nlohmann::json>> readMarkupLists(const std::filesystem::path& file,
                                                    const std::string& seriesKey,
                                                    const Error& none);

}  // namespace perilymph::imaging

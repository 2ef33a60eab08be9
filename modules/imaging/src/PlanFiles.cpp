// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/PlanFiles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "MarkupsJson.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {

namespace {

using Json = nlohmann::json;
using Points = LabeledPoints;

Points numbered(const char* prefix, const std::vector<Eigen::Vector3d>& points)
{
  Points labeled;
  for (const Eigen::Vector3d& point : points)
    labeled.emplace_back(prefix + std::to_string(labeled.size() + 1), point);
  return labeled;
}

Points ends(const std::array<Eigen::Vector3d, 2>& line)
{
  return {{"from", line[0]}, {"to", line[1]}};
}

std::string base64(const std::string& bytes)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

/// Appends a number in little-endian order, as glTF wants.
template <class Number>
void append(std::string& bytes, Number number)
{
  static_assert(std::endian::native == std::endian::little);
  std::array<char, sizeof number> raw{};
  std::memcpy(raw.data(), &number, sizeof number);
  bytes.append(raw.data(), raw.size());
}

}  // namespace

std::string planText(const PlanMarkups& plan)
{
  Json markups = Json::array();
  Points landmarks;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (const auto& point = plan.marks.points_P[k])
      landmarks.emplace_back(ct::nameOf(static_cast<ct::Mark>(k)), *point);
  if (!landmarks.empty())
    markups.push_back(markupJson("Fiducial", "landmarks", plan.seriesKey, landmarks));
  if (plan.axis) markups.push_back(markupJson("Line", "axis", plan.seriesKey, ends(*plan.axis)));
  if (plan.insertionLine)
    markups.push_back(markupJson("Line", "insertion", plan.seriesKey, ends(*plan.insertionLine)));
  if (!plan.array.empty())
    markups.push_back(markupJson("Curve", "array", plan.seriesKey, numbered("", plan.array)));
  if (!plan.contacts.empty())
    markups.push_back(
        markupJson("Fiducial", "contacts", plan.seriesKey, numbered("E", plan.contacts)));
  return markupsText(markups);
}

Result<void> writeGltf(const anatomy::Surface& surface, const std::string& title,
                       const std::filesystem::path& file)
{
  constexpr double mm = 1e3;
  std::string bytes;
  std::array<float, 3> low{}, high{};
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  for (const auto& point : surface.points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<float>(mm * point[axis]);
      low[axis] = std::min(low[axis], value);
      high[axis] = std::max(high[axis], value);
      append(bytes, value);
    }
  const std::size_t positions = bytes.size();
  for (const auto& corners : surface.triangles)
    for (const int corner : corners) append(bytes, static_cast<std::uint32_t>(corner));
  constexpr int floats = 5126, unsignedInts = 5125, vertices = 34962, indices = 34963;
  const Json gltf{
      {"asset", {{"version", "2.0"}, {"generator", "Perilymph"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}, {"name", title}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
      {"buffers",
       {{{"byteLength", bytes.size()},
         {"uri", "data:application/octet-stream;base64," + base64(bytes)}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", positions}, {"target", vertices}},
        {{"buffer", 0},
         {"byteOffset", positions},
         {"byteLength", bytes.size() - positions},
         {"target", indices}}}},
      {"accessors",
       {{{"bufferView", 0},
         {"componentType", floats},
         {"count", surface.points.size()},
         {"type", "VEC3"},
         {"min", low},
         {"max", high}},
        {{"bufferView", 1},
         {"componentType", unsignedInts},
         {"count", 3 * surface.triangles.size()},
         {"type", "SCALAR"}}}}};
  return writeWhole(file, gltf.dump());
}

}  // namespace perilymph::imaging

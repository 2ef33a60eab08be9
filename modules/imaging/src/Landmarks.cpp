// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/Landmarks.h"

#include <optional>

#include "MarkupsJson.h"

namespace perilymph::imaging {

namespace {

using Json = nlohmann::json;

constexpr double samePlace_mm = 0.01;  // as programs round

/// Adds the points of one list; false where it is not one that can be read. A name at two places is kept in `twice`.
bool addPoints(const Json& markup, ct::Marks& marks, std::optional<ct::Mark>& twice)
{
  if (!markup.is_object()) return false;
  const auto points = markup.find("controlPoints");
  const auto coordinates = coordinatesOf(markup);
  if (!coordinates || points == markup.end() || !points->is_array()) return false;
  for (const Json& control : *points) {
    if (!control.is_object()) return false;
    const std::optional<ct::Mark> mark = ct::markNamed(textOf(control, "label"));
    if (!mark || !isDefined(control)) continue;
    const auto point = controlPointOf(control, *coordinates);
    if (!point) return false;
    if (marks[*mark] && (*point - *marks[*mark]).norm() > samePlace_mm) twice = *mark;
    marks[*mark] = point;
  }
  return true;
}

}  // namespace

Result<ct::Marks> readLandmarks(const std::filesystem::path& file, const std::string& seriesKey)
{
  const Error other{file.string() +
                    " is no Slicer markups file with points named RW, C or A in LPS or RAS. Save "
                    "the points in Slicer as Markups JSON (.mrk.json)."};
  const auto markups = readMarkupLists(file, seriesKey, other);
  if (!markups) return markups.error();
  ct::Marks marks;
  std::optional<ct::Mark> twice;
  for (const Json& markup : *markups)
    if (!addPoints(markup, marks, twice)) return other;
  if (twice)
    return Error{"%1 places the landmark %2 at two points. Keep one of them.", file,
                 nameOf(*twice)};
  if (!marks[ct::Mark::roundWindow] && !marks[ct::Mark::modiolus] && !marks[ct::Mark::apex])
    return other;
  return marks;
}

}  // namespace perilymph::imaging

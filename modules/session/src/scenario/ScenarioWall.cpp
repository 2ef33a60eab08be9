// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioWall.h"

namespace perilymph::session {

namespace {

constexpr const char* stiffnessKey = "wall_stiffness_N_m";
constexpr const char* wallKeys[] = {stiffnessKey, "wall_lining_mm", "rim_stiffness_N_m",
                                    "wall_section_delay_ms", "wall_edge_mm"};

}  // namespace

void dropWallOfOtherCochlea(TomlReader& reader,
                            const std::function<const std::string*(const char*)>& overrideOf)
{
  const auto isOther = [&](const char* key, const char* usual) {
    const std::string* name = overrideOf(key);
    return name != nullptr && *name != reader.text(key, usual);
  };
  if (!isOther("patient", "") && !isOther("anatomy", "") &&
      !isOther("model", nameOf(mechanics::ModelKind::rod)))
    return;
  for (const char* key : wallKeys)
    if (overrideOf(key) == nullptr) reader.remove(key);
}

void readWall(ScenarioKeys& keys, TomlReader& reader, const std::string& patient,
              const InsertionParameters& parameters, mechanics::WallLaw& wall)
{
  const bool isPublished =
      parameters.model == mechanics::ModelKind::points ||
      (parameters.cochlea.source == anatomy::AnatomySource::published && patient.empty());
  const mechanics::WallLaw published;
  const mechanics::WallLaw usual =
      isPublished || reader.has(stiffnessKey) ? published : mechanics::boneWall();
  // 441 and 200 N/m are the published simulator's, under each of its sample points (Todd and
  // Naghdy, section II.D).
  wall.perSamplePoint =
      newtonsPerMeter(keys.number(stiffnessKey, {10.0, 50'000.0}, usual.perSamplePoint.si()));
  wall.lining =
      millimeters(keys.number("wall_lining_mm", {0.001, 0.2}, inMillimeters(usual.lining)));
  wall.tangentialPerSamplePoint = newtonsPerMeter(keys.number(
      "wall_tangential_stiffness_N_m", {10.0, 10'000.0}, usual.tangentialPerSamplePoint.si()));
  wall.sectionDelay = milliseconds(
      keys.number("wall_section_delay_ms", {0.0, 100.0}, inMilliseconds(usual.sectionDelay)));
  wall.edge = millimeters(keys.number("wall_edge_mm", {0.0, 5.0}, inMillimeters(usual.edge)));
  // Recordings of before have no key: their rim is as stiff as their wall.
  wall.rim = newtonsPerMeter(keys.number("rim_stiffness_N_m", {10.0, 50'000.0},
                                         usual.rim.value_or(wall.perSamplePoint).si()));
}

}  // namespace perilymph::session

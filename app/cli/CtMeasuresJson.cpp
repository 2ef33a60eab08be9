// SPDX-License-Identifier: BSD-3-Clause
#include "CtMeasuresJson.h"

#include "JsonText.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

using Json = nlohmann::ordered_json;

Json described(const ct::Measure& measure)
{
  return {{"value", measure.value},       {"sd", measure.sd()},
          {"ci95", measure.interval95()}, {"sd_statistical", measure.statistical},
          {"sd_model", measure.model},    {"sd_definition", measure.definition}};
}

Json described(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

std::string measuresJson(const ct::CochleaMeasures& measures,
                         const std::vector<std::string>& warnings, double seconds)
{
  Json json;
  json["A_mm"] = described(measures.a);
  json["B_mm"] = described(measures.b);
  json["H_mm"] = described(measures.h);
  json["cdl_oc_mm"] = described(measures.cdlOc);
  json["axis_lps"] = described(measures.axis_P);
  json["center_lps_mm"] = described(measures.center_P);
  json["round_window_lps_mm"] = described(measures.roundWindow_P);
  json["side"] = measures.side == anatomy::Side::left ? "left" : "right";
  json["flags"] = Json::array();
  for (const ct::Flag flag : measures.flags) json["flags"].push_back(ct::nameOf(flag));
  json["seconds"] = seconds;
  json["axis_sd_deg"] = measures.axisError_deg;
  json["handedness_margin"] = measures.handednessMargin;
  json["misfit"] = measures.misfit;
  json["bone_level"] = measures.boneLevel;
  json["lumen_level"] = measures.lumenLevel;
  json["blur_in_plane_mm"] = measures.blurInPlane_mm;
  json["blur_axial_mm"] = measures.blurAxial_mm;
  json["warnings"] = warnings;
  json["provenance"] = {{"version", buildId()},
                        {"series_key", measures.provenance.seriesKey},
                        {"scanner", measures.provenance.scanner},
                        {"source", measures.provenance.source},
                        {"notes", measures.provenance.notes}};
  return jsonText(json);
}

}  // namespace perilymph::cli

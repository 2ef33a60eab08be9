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

Json described(const ct::CochleaMeasures& measures, const std::vector<Sentence>& warnings,
               double seconds)
{
  Json json;
  json["A_mm"] = described(measures.a);
  json["B_mm"] = described(measures.b);
  json["H_mm"] = described(measures.h);
  if (measures.cdlOc) {
    json["cdl_oc_mm"] = described(*measures.cdlOc);
  } else {
    json["cdl_oc_mm"] = nullptr;
    json["cdl_oc_reason"] = ct::sentenceOf(measures.noFullSpiral().value());
    json["turns_seen"] = measures.turnsSeen;
  }
  json["axis_lps"] = described(measures.axis_P);
  json["center_lps_mm"] = described(measures.center_P);
  json["round_window_lps_mm"] = described(measures.roundWindow_P);
  json["side"] = anatomy::nameOf(measures.side);
  json["flags"] = Json::array();
  for (const ct::Flag flag : measures.flags) json["flags"].push_back(ct::nameOf(flag));
  if (measures.otherCochlea_P) json["second_cochlea_lps_mm"] = described(*measures.otherCochlea_P);
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
  return json;
}

}  // namespace

std::string measuresJson(const ct::CochleaMeasures& measures, const std::vector<Sentence>& warnings,
                         double seconds)
{
  return jsonText(described(measures, warnings, seconds));
}

std::string measuresJson(const std::array<ct::CochleaMeasures, 2>& ears,
                         const std::vector<Sentence>& warnings, double seconds)
{
  Json json;
  json["ears"] = Json::array();
  for (const ct::CochleaMeasures& ear : ears)
    json["ears"].push_back(described(ear, warnings, seconds));
  return jsonText(json);
}

}  // namespace perilymph::cli

// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioOpening.h"

#include <algorithm>
#include <cstdio>

namespace perilymph::session {

/// Millimeters for a sentence: 27, 18.5.
std::string shortLength_mm(Length length)
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", inMillimeters(length));
  return digits;
}

void dropPassageOfOtherOpening(TomlReader& reader,
                               const std::function<const std::string*(const char*)>& overrideOf)
{
  const std::string* opening = overrideOf("opening");
  if (opening == nullptr || *opening == reader.text("opening", "")) return;
  for (const char* key : {"passage_mm", "passage_modulus_MPa", "passage_friction", "rib_exit_loss"})
    if (overrideOf(key) == nullptr) reader.remove(key);
}

void readOpening(ScenarioKeys& keys, TomlReader& reader, InsertionParameters& parameters)
{
  parameters.openingKind = keys.choice("opening", openings, parameters.openingKind);
  // Drilled openings are 0.8 to 1.5 mm wide; the published rig's passed a carrier of 0.8 mm.
  const double diameter = keys.number("cochleostomy_diameter_mm", {0.5, 3.0}, 1.0);
  // Beside the axis of the scala: an opening is 1 to 2 mm wide.
  const double outward = keys.number("opening_outward_mm", {-2.0, 2.0}, 0.0);
  const double vertical = keys.number("opening_vertical_mm", {-2.0, 2.0}, 0.0);
  // A drilled hole is as long as what it is drilled through; a round window is a thin membrane.
  const double passage = keys.number("passage_mm", {0.0, 2.0}, 0.0);
  const mechanics::Opening usual;
  // Silicone has 0.6 to 4 MPa (Wang et al. 2014, J Appl Polym Sci 131:41050); wires stiffen it.
  const double modulus =
      keys.number("passage_modulus_MPa", {0.1, 100.0}, inMegapascals(usual.passageModulus));
  std::optional<double> friction;
  // Up to twice the highest coefficient measured for an array, 0.59 (Dohr et al. 2021).
  if (reader.has("passage_friction")) friction = keys.number("passage_friction", {0.0, 1.2}, 0.0);
  const double loss = keys.number("rib_exit_loss", {0.0, 1.0}, usual.ribExitLoss);
  if (parameters.openingKind == OpeningKind::roundWindow)
    parameters.opening = mechanics::roundWindow();
  if (parameters.openingKind == OpeningKind::cochleostomy)
    parameters.opening = mechanics::cochleostomy(millimeters(diameter));
  if (!parameters.opening) return;
  parameters.opening->outward = millimeters(outward);
  parameters.opening->vertical = millimeters(vertical);
  parameters.opening->passage = millimeters(passage);
  parameters.opening->passageModulus = megapascals(modulus);
  parameters.opening->passageFriction = friction;
  parameters.opening->ribExitLoss = loss;
}

Result<void> checkPassage(const std::string& file, const InsertionParameters& parameters)
{
  if (!parameters.opening || !(parameters.opening->passage.si() > 0.0)) return {};
  const std::string length = shortLength_mm(parameters.opening->passage);
  if (parameters.openingKind != OpeningKind::cochleostomy)
    return Error{
        "%1: passage_mm is %2, but only a drilled opening has a passage. Set passage_mm to 0 or "
        "opening to 'cochleostomy'.",
        file, length};
  // 1.0 mm of text may be a rounding above 1.0 mm
  if (parameters.opening->passage > parameters.cochlea.leadIn + Length::fromSi(1e-9))
    return Error{
        "%1: passage_mm is %2; the passage lies in the straight stretch before the spiral, whose "
        "lead_in_mm is %3. Lower passage_mm or raise lead_in_mm.",
        file, length, shortLength_mm(parameters.cochlea.leadIn)};
  return {};
}

std::optional<std::string> seatNote(const InsertionParameters& parameters, Length deepest)
{
  const std::optional<mechanics::Opening>& opening = parameters.opening;
  const electrode::ArrayDesign& array = parameters.array;
  if (!opening) return std::nullopt;
  const Length narrow = std::min(opening->width, opening->height);
  const Length wide = std::max(opening->width, opening->height);
  const Length step = millimeters(0.05);
  for (Length place = millimeters(0); place < deepest; place = place + step) {
    const electrode::Section section = array.sectionAt(place);
    const Length across = std::max(section.across, section.within);
    if (across <= wide && std::min(section.across, section.within) <= narrow) continue;
    return "The array " + array.name + " is " + shortLength_mm(across) + " mm thick " +
           shortLength_mm(place) + " mm behind its tip, the opening " + shortLength_mm(narrow) +
           " mm wide: it stops there and cannot be inserted further without force.";
  }
  return std::nullopt;
}

}  // namespace perilymph::session

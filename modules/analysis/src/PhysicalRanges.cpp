// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PhysicalRanges.h"

#include <algorithm>

#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

namespace {

using session::shortestDecimal;

/// A value with its name, unit and range.
struct Checked {
  const char* quantity;
  const char* unit;
  double value;
  Range range;
};

template <class Values>
std::string firstImpossible(const Values& values)
{
  for (const Checked& each : values)
    if (auto reason = impossibility(each.quantity, each.unit, each.value, each.range);
        !reason.empty())
      return reason;
  return {};
}

/// Contacts and profile, which both kinds of insertions have.
std::string impossibility(const std::vector<ContactPosition>& contacts,
                          const std::vector<DepthForce>& profile)
{
  for (const ContactPosition& each : contacts) {
    const Checked values[] = {
        {"the depth of a contact", "mm", inMillimeters(each.depth), physical::depth_mm},
        {"the angle of a contact", "degrees", inDegrees(each.angle), physical::angle_deg},
        {"the place of a contact", "of the organ of Corti", each.coverage, physical::fraction},
        {"the frequency of a contact", "Hz", each.frequency_Hz, physical::frequency_Hz},
        {"the distance of a contact to the modiolus", "mm", inMillimeters(each.toModiolus),
         physical::toModiolus_mm}};
    if (auto reason = firstImpossible(values); !reason.empty()) return reason;
  }
  for (const DepthForce& each : profile) {
    const Checked values[] = {
        {"a depth", "mm", inMillimeters(each.depth), physical::depth_mm},
        {"a force", "mN", inMillinewtons(each.force), physical::signedForce_mN}};
    if (auto reason = firstImpossible(values); !reason.empty()) return reason;
  }
  return {};
}

void limit(Force& force, Range range)
{
  force = millinewtons(std::clamp(inMillinewtons(force), range.low, range.high));
}

/// An insertion without values, with a reason.
template <class Insertion>
Insertion notComputed(const Insertion& insertion, const std::string& reason)
{
  Insertion without;
  without.reason = "Its values are impossible and were not kept: " + reason + ".";
  if constexpr (requires { without.seed; }) {
    without.array = insertion.array;
    without.seed = insertion.seed;
    without.patient = insertion.patient;
  }
  return without;
}

}  // namespace

std::string impossibility(const char* quantity, const char* unit, double value, Range range)
{
  if (isWithin(value, range)) return {};
  return std::string(quantity) + " is " + shortestDecimal(value) + (*unit == '\0' ? "" : " ") +
         unit + "; " + shortestDecimal(range.low) + " to " + shortestDecimal(range.high) +
         " is possible";
}

std::string impossibility(const InsertionRun& insertion)
{
  const Checked values[] = {
      {"the depth", "mm", inMillimeters(insertion.depth), physical::depth_mm},
      {"the maximum depth", "mm", inMillimeters(insertion.maxDepth), physical::depth_mm},
      {"the angle", "degrees", inDegrees(insertion.apical), physical::angle_deg},
      {"the coverage", "%", 100.0 * insertion.coverage, physical::percent},
      {"the peak force", "mN", inMillinewtons(insertion.peak.force), physical::force_mN},
      {"the depth of the peak force", "mm", inMillimeters(insertion.peak.depth),
       physical::depth_mm},
      {"the force at the end", "mN", inMillinewtons(insertion.endForce), physical::signedForce_mN},
      {"the force on the partition", "mN", inMillinewtons(insertion.partition),
       physical::partition_mN}};
  auto reason = firstImpossible(values);
  return reason.empty() ? impossibility(insertion.contacts, insertion.profile) : reason;
}

std::string impossibility(const ClinicalInsertion& insertion)
{
  const auto atRest = [](const std::optional<Force>& force) {
    return inMillinewtons(force.value_or(Force{}));
  };
  const Checked values[] = {
      {"the depth", "mm", inMillimeters(insertion.depth), physical::depth_mm},
      {"the angle", "degrees", inDegrees(insertion.apical), physical::angle_deg},
      {"the peak force", "mN", inMillinewtons(insertion.peak), physical::force_mN},
      {"the force at the end", "mN", inMillinewtons(insertion.endForce), physical::signedForce_mN},
      {"the force on the partition", "mN", inMillinewtons(insertion.partition),
       physical::partition_mN},
      {"the force after 1 s", "mN", atRest(insertion.forceAfter1s), physical::signedForce_mN},
      {"the force after 10 s", "mN", atRest(insertion.forceAfter10s), physical::signedForce_mN},
      {"the place of the rupture", "degrees", inDegrees(insertion.ruptureAngle),
       physical::angle_deg}};
  auto reason = firstImpossible(values);
  return reason.empty() ? impossibility(insertion.contacts, insertion.profile) : reason;
}

InsertionRun asPossible(InsertionRun insertion)
{
  if (insertion.end == InsertionEnd::jammed) {
    limit(insertion.peak.force, physical::force_mN);
    limit(insertion.endForce, physical::signedForce_mN);
    for (DepthForce& each : insertion.profile) limit(each.force, physical::signedForce_mN);
  }
  const std::string reason = impossibility(insertion);
  return reason.empty() ? insertion : notComputed(insertion, reason);
}

ClinicalInsertion asPossible(ClinicalInsertion insertion)
{
  if (insertion.end == InsertionEnd::jammed) {
    limit(insertion.peak, physical::force_mN);
    for (auto* force : {&insertion.forceAfter1s, &insertion.forceAfter10s})
      if (*force) limit(**force, physical::signedForce_mN);
    limit(insertion.endForce, physical::signedForce_mN);
    for (DepthForce& each : insertion.profile) limit(each.force, physical::signedForce_mN);
  }
  const std::string reason = impossibility(insertion);
  return reason.empty() ? insertion : notComputed(insertion, reason);
}

}  // namespace perilymph::analysis

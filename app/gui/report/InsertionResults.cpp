// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionResults.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "gui/report/InsertionOutcome.h"
#include "gui/report/PlanReportContent.h"
#include "gui/text/ClinicalText.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString mN(double force_N) { return tr("%1 mN").arg(forceNumber(force_N * 1e3)); }

QString degreesText(Angle angle) { return tr("%1°").arg(numberText(inDegrees(angle), 0)); }

/// "9 (4–14) mN"
QString bandText(const planning::Band& band, const QString& unit)
{
  return unit.arg(medianText(band, 0));
}

/// Adds the band of a plan, and whether a value is outside of it as both are shown.
InsertionResult beside(InsertionResult result, const std::optional<planning::Band>& band,
                       std::optional<double> value, const QString& unit)
{
  if (!band) return result;
  result.plan = bandText(*band, unit);
  if (!value) return result;
  const double shown = std::round(*value);
  result.isOutside = shown < std::round(band->low) || shown > std::round(band->high);
  return result;
}

/// Adds what clinics report of an array to the results that it is about.
void addClinics(std::vector<InsertionResult>& results, const std::string& array)
{
  using analysis::ReportedQuantity;
  const std::pair<QString, ReportedQuantity> reported[] = {
      {tr("Peak insertion force"), ReportedQuantity::peakForce},
      {tr("End force"), ReportedQuantity::endForce},
      {tr("Angular insertion depth"), ReportedQuantity::angle},
      {tr("Contacts inside"), ReportedQuantity::contactsInside}};
  for (InsertionResult& each : results)
    for (const auto& [name, quantity] : reported)
      if (each.name == name) {
        each.clinics = clinicsReport(array, quantity);
        each.clinicsDetail = clinicsReportDetails(array, quantity);
        each.clinicsSource = clinicsSource(array, quantity);
      }
}

/// No bare zero: the model hardly reaches the partition where patients have translocations.
QString partitionForce(double force_N)
{
  if (std::isnan(force_N)) return tr("not recorded");
  constexpr double smallest_mN = 0.1;
  return force_N * 1e3 < smallest_mN ? tr("< %1 mN").arg(numberText(smallest_mN, 1)) : mN(force_N);
}

QString partitionText(const ReportContent& content)
{
  if (content.insertion.translocation) return ruptureText(*content.insertion.translocation);
  if (!content.rupture) return {};
  return tr("rupture assumed at %1–%2 mN; original not available")
      .arg(numberText(content.rupture->low * 1e3, 0), numberText(content.rupture->high * 1e3, 0));
}

}  // namespace

QString ruptureText(const haptics::Translocation& found)
{
  const QString angle = numberText(inDegrees(radians(found.angle)), 0);
  const QString force = numberText(inMillinewtons(newtons(found.force)), 0);
  if (!(found.lengthAbove > 0.0)) return tr("ruptured at %1° by %2 mN").arg(angle, force);
  return tr("translocation: ruptured at %1° by %2 mN, %3 mm above")
      .arg(angle, force, numberText(inMillimeters(meters(found.lengthAbove)), 1));
}

namespace {

std::vector<InsertionResult> measuredResults(const ReportContent& content)
{
  const analysis::ForceProfile& profile = content.insertion.profile;
  const analysis::Motion& motion = content.insertion.motion;
  const auto& contacts = content.contacts;
  const auto inserted = [](const analysis::ContactPosition& each) { return each.isInserted; };
  const auto apical = std::find_if(contacts.begin(), contacts.end(), inserted);
  const auto basal = std::find_if(contacts.rbegin(), contacts.rend(), inserted);
  const auto inside = std::count_if(contacts.begin(), contacts.end(), inserted);
  const bool hasContact = apical != contacts.end();
  const QString tip =
      tr("tip at %1").arg(degreesText(radians(content.deepest.output.angularDepth)));

  // a script and a pointer hold without tremor, so the force stays where that of a plan's hand falls
  const bool isHeldStill = content.facts.isScripted() || content.facts.isByPointer();
  std::optional<planning::Band> peak, end, after1s, angle;
  if (content.plan) {
    peak = content.plan->peak_mN;
    end = content.plan->end_mN;
    if (!isHeldStill) after1s = content.plan->after1s_mN;
    angle = content.plan->angle_deg;
  }
  std::optional<double> after1s_mN, angle_deg;
  if (profile.forceAfter1s) after1s_mN = *profile.forceAfter1s * 1e3;
  if (hasContact) angle_deg = inDegrees(apical->angle);
  const QString force = tr("%1 mN"), degrees = tr("%1°");
  std::vector<InsertionResult> results = {
      beside({tr("Peak insertion force"),
              mN(profile.peak.force),
              tr("at insertion depth %1 mm").arg(numberText(profile.peakDepth * 1e3, 1)),
              {},
              {},
              {},
              false,
              true},
             peak, profile.peak.force * 1e3, force),
      beside({tr("End force"),
              mN(profile.endForce),
              tr("at the stop: line through the last 0.5 s of motion"),
              {},
              {},
              {},
              false,
              true},
             end, profile.endForce * 1e3, force),
      beside({tr("Force after 1 s of rest"),
              profile.forceAfter1s ? mN(*profile.forceAfter1s) : tr("not reached"),
              isHeldStill ? tr("mean of 0.5 to 1 s after the stop, without tremor")
                          : tr("mean of 0.5 to 1 s after the stop"),
              {},
              {},
              {},
              false,
              true},
             after1s, after1s_mN, force),
      beside({tr("Angular insertion depth"),
              hasContact ? degreesText(apical->angle) : tr("no contact inside"),
              hasContact ? tr("of the most apical contact; %1").arg(tip) : tip,
              {},
              {},
              {},
              false,
              true},
             angle, angle_deg, degrees),
      {tr("Contacts inside"),
       tr("%1 of %2").arg(inside).arg(contacts.size()),
       hasContact ? tr("from %1 to %2").arg(degreesText(basal->angle), degreesText(apical->angle))
                  : QString(),
       {},
       {},
       {},
       false,
       true},
      {tr("Insertion depth"),
       tr("%1 mm").arg(numberText(content.deepest.output.depth * 1e3, 1)),
       tr("past the opening"),
       {},
       {},
       {},
       false,
       false},
      {tr("Insertion time"),
       tr("%1 s").arg(numberText(profile.duration, 1)),
       tr("first to last motion, pauses included; reversals: %1").arg(motion.reversals),
       {},
       {},
       {},
       false,
       false},
      {tr("Maximum partition force"),
       partitionForce(profile.partitionForceMax),
       partitionText(content),
       {},
       {},
       {},
       false,
       true}};
  addClinics(results, content.scenario.arrayName());
  return results;
}

}  // namespace

std::vector<InsertionResult> insertionResults(const ReportContent& content)
{
  std::vector<InsertionResult> results = measuredResults(content);
  results.insert(results.begin(), outcomeOf(content));
  return results;
}

}  // namespace perilymph::gui

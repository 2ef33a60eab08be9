// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionOutcome.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/setup/StopTravel.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double sameDepth = 0.5e-3;  ///< [m]

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString mm(double length) { return tr("%1 mm").arg(numberText(length * 1e3, 1)); }

}  // namespace

QString outcomeText(haptics::InsertionEnd end, bool isAtDepth, const session::Scenario& scenario)
{
  switch (end) {
    case haptics::InsertionEnd::stoppedByResistance:
      return tr("Stopped by resistance");
    case haptics::InsertionEnd::buckled:
      return tr("Buckled in front of the opening");
    case haptics::InsertionEnd::outOfOpening:
      return tr("Slipped out of the opening");
    case haptics::InsertionEnd::foldedTip:
      return tr("Tip folded over");
    case haptics::InsertionEnd::jammed:
      return tr("Jammed");
    case haptics::InsertionEnd::fault:
      return tr("Stopped with a fault");
    default:
      break;
  }
  if (!isAtDepth) return tr("Withdrawn");
  const Length outside = outsideAtStop(scenario);
  return outside.si() <= 0.0 ? tr("Full depth")
                             : tr("Stopped as set, %1 mm of the array outside")
                                   .arg(numberText(inMillimeters(outside), 1));
}

QString outcomeWord(haptics::InsertionEnd end)
{
  switch (end) {
    case haptics::InsertionEnd::finished:
      return tr("stop reached");
    case haptics::InsertionEnd::stoppedByResistance:
      return tr("resistance");
    case haptics::InsertionEnd::buckled:
      return tr("buckled");
    case haptics::InsertionEnd::outOfOpening:
      return tr("slipped out");
    case haptics::InsertionEnd::foldedTip:
      return tr("tip folded");
    case haptics::InsertionEnd::jammed:
      return tr("jammed");
    case haptics::InsertionEnd::fault:
    case haptics::InsertionEnd::refused:
      return tr("fault");
    case haptics::InsertionEnd::none:
      break;
  }
  return tr("ended early");
}

QStringList deepestNotes(const ReportContent& content)
{
  const analysis::ForceProfile& profile = content.insertion.profile;
  if (profile.finalDepth > profile.deepest - sameDepth) return {};
  return {tr("depth, angle and contacts at the deepest place, %1").arg(mm(profile.deepest)),
          tr("at the end %1, tip at %2°")
              .arg(mm(profile.finalDepth), numberText(inDegrees(radians(profile.finalAngle)), 0))};
}

QString passedStopName(const analysis::PassedStop& passed)
{
  return tr("A hand that stops at %1 mN").arg(numberText(inMillinewtons(passed.stop), 0));
}

QString passedStopText(const analysis::PassedStop& passed)
{
  return tr("would have ended at %1, %2°, %3 of %4 contacts inside")
      .arg(mm(passed.depth.si()), numberText(inDegrees(passed.apical), 0))
      .arg(passed.inside)
      .arg(passed.contacts);
}

InsertionResult outcomeOf(const ReportContent& content)
{
  const haptics::InsertionEnd end = haptics::endOf(content.last);
  const double stop = content.scenario.stopTravel().si();
  const bool isAtDepth = content.deepest.output.travel >= stop - sameDepth;
  const bool endedByHand =
      end == haptics::InsertionEnd::none || end == haptics::InsertionEnd::finished;
  InsertionResult outcome;
  outcome.name = tr("Outcome");
  outcome.value = endedByHand && !isAtDepth ? tr("Ended before its stop at %1").arg(mm(stop))
                                            : outcomeText(end, isAtDepth, content.scenario);
  QStringList doubts = deepestNotes(content);
  if (const auto unbalanced = content.insertion.profile.ticksNotConverged; unbalanced > 0)
    doubts << tr("%1 samples did not converge").arg(unbalanced);
  outcome.detail = doubts.join(QLatin1Char('\n'));
  outcome.isSentence = true;
  return outcome;
}

}  // namespace perilymph::gui

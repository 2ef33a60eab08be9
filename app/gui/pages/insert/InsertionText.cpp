// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertionText.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/report/InsertionOutcome.h"
#include "gui/setup/SetupTitle.h"
#include "gui/setup/StopTravel.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString deviceHint(const InsertionControl& control)
{
  if (!control.isRunning()) {
    const QString press = tr("Press Start, then hold the device button and advance.");
    if (control.couplingText().empty()) return press;
    return press + QLatin1Char('\n') +
           tr("Coupling stiffness limited to %1 N/m: see Devices (H).")
               .arg(numberText(control.now().couplingStiffness, 0));
  }
  if (!control.isMoving()) return tr("Hold the device button: the array follows the device.");
  return tr("Holding. Release the button to stop.");
}

}  // namespace

QString inProgressText(const InsertionControl& control)
{
  const Length travel = Length::fromSi(control.now().output.travel);
  return tr("Insertion in progress (%1 mm); it is recorded up to here.")
      .arg(numberText(inMillimeters(travel), 1));
}

QString timingText(const InsertionControl& control, int framesPerSecond)
{
  const haptics::Snapshot& now = control.now();
  QStringList text;
  if (control.isRunning() && now.measuredRate > 0.0)
    text << tr("%1 Hz").arg(numberText(now.measuredRate, 0))
         << tr("late samples: %1").arg(now.lateTicks);
  text << tr("%1 fps").arg(framesPerSecond);
  return text.join(QStringLiteral(" · "));
}

QString statusText(const InsertionControl& control, const QString& device)
{
  const haptics::Snapshot& now = control.now();
  QStringList text;
  if (!control.recordingError().empty())
    text << tr("NOT recording");
  else if (control.progress() == Progress::concluded)
    text << tr("recorded");
  else if (control.progress() == Progress::resting)
    text << recordingText(Progress::resting);
  else if (control.isRunning() && (now.output.status & haptics::resting) != 0)
    text << tr("recording (paused)");
  else if (control.isRunning())
    text << (now.lostRecords > 0 ? tr("recording, %1 samples lost").arg(now.lostRecords)
                                 : tr("recording"));
  else
    text << tr("not started");
  if (!device.isEmpty()) text << device << tr("%1 overruns").arg(now.overruns);
  if (!control.couplingText().empty())
    text << tr("coupling %1 N/m").arg(numberText(now.couplingStiffness, 0));
  text << tr("not a medical device");
  return text.join(QStringLiteral(" · "));
}

QString errorText(const InsertionControl& control, const QString& error)
{
  const haptics::TickOutput& now = control.now().output;
  if (now.workflow == Workflow::fault) {
    const bool isLost = (now.status & haptics::deviceLost) != 0;
    // the device's own reason, which says what to do
    if (const auto health = isLost ? control.deviceHealth() : std::nullopt;
        health && !health->error.empty())
      return dataText(health->error);
    const QString what = isLost ? tr("The input device stopped responding.")
                         : (now.status & haptics::notFinite) != 0
                             ? tr("The simulation became unstable and was stopped.")
                             : tr("The insertion was stopped.");
    return what + tr(" The force is off and the array is stationary. Press Reset to start again.");
  }
  if (!error.isEmpty()) return error;
  const Sentence recording = control.recordingError();
  if (!recording.empty())
    return tr("This insertion is not being recorded: %1").arg(dataText(recording));
  return {};
}

QString endTitle(const InsertionControl& control)
{
  return outcomeText(haptics::endOf(control.now().output), control.isAtDepth(), control.scenario());
}

QString endText(haptics::InsertionEnd end, const haptics::TickOutput& now)
{
  const QString depth = numberText(inMillimeters(Length::fromSi(now.depth)), 1);
  switch (end) {
    case haptics::InsertionEnd::stoppedByResistance:
      return tr("Stopped by resistance at %1 mm, %2 mN. Press Withdraw or Reset.")
          .arg(depth, numberText(inMillinewtons(Force::fromSi(now.axialForce)), 0));
    case haptics::InsertionEnd::buckled:
      // how deep it was is on the card: what is left inside slips out
      return tr(
          "The array buckled in front of the opening. The force is off. Press Withdraw or Reset.");
    case haptics::InsertionEnd::outOfOpening:
      return tr("The tip has left the cochlea. The force is off. Press Reset.");
    case haptics::InsertionEnd::foldedTip:
      return tr("The tip folded over at %1 mm. The force is off. Press Withdraw or Reset.")
          .arg(depth);
    case haptics::InsertionEnd::jammed:
      return tr("The array jammed at %1 mm. The force is off. Press Withdraw or Reset.").arg(depth);
    default:
      return {};
  }
}

QString hintText(const InsertionControl& control)
{
  const haptics::TickOutput& now = control.now().output;
  if (control.isStopped()) return tr("Stopped: the force is off. Press Start to continue.");
  const haptics::InsertionEnd end = control.earlyEnd();
  if (end != haptics::InsertionEnd::none) return endText(end, now);
  if (control.isAtDepth()) {
    const Length outside = outsideAtStop(control.scenario());
    return outside.si() <= 0.0
               ? tr("Full depth. Press Withdraw or Reset.")
               : tr("Stopped as set; %1 mm of the array remains outside. Press Withdraw or Reset.")
                     .arg(numberText(inMillimeters(outside), 1));
  }
  if (now.workflow == Workflow::finished) {
    const Length inside = Length::fromSi(now.depth);
    return inside.si() <= 0.0
               ? tr("The array is withdrawn. Press Reset for a new insertion.")
               : tr("Back at the start, tip %1 mm inside. Press Reset for a new insertion.")
                     .arg(numberText(inMillimeters(inside), 1));
  }
  if (control.input() == InputSource::scripted) return {};
  if (control.input() == InputSource::device) return deviceHint(control);
  if (!control.isRunning())
    return tr("Press Start, then hold Space and scroll down or press ↓ to advance.");
  if (!control.isHeld()) return tr("Hold Space, then scroll down or press ↓ to advance.");
  return tr("Holding. Scroll down or press ↓ to advance, scroll up or press ↑ to withdraw.");
}

QString buildingHint(bool isStartRequested)
{
  return isStartRequested ? tr("Building the cochlea; the insertion then starts…")
                          : tr("Building the cochlea…");
}

QString styletText(const InsertionControl& control)
{
  if (!control.scenario().array().hasStylet) return tr("no stylet");
  const double withdrawn_mm = inMillimeters(Length::fromSi(control.now().output.styletWithdrawal));
  return withdrawn_mm > 0.0 ? tr("%1 mm withdrawn").arg(numberText(withdrawn_mm, 1))
                            : tr("in place");
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InsertionText.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/parts/Numbers.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString deviceHint(const InsertionControl& control)
{
  if (!control.isRunning()) {
    const QString press = tr("Press Start, then hold the device’s button and push.");
    if (control.couplingText().empty()) return press;
    return press + QLatin1Char('\n') +
           tr("Coupling %1 N/m, softer than asked: Devices (H).")
               .arg(numberText(control.now().couplingStiffness, 0));
  }
  if (!control.isMoving()) return tr("Hold the device’s button: the array follows the hand.");
  return tr("Array held. Letting go of the button lets it rest.");
}

}  // namespace

QString statusText(const InsertionControl& control, const QString& device, int framesPerSecond)
{
  const haptics::Snapshot& now = control.now();
  QStringList text;
  if (!control.recordingError().empty())
    text << tr("NOT recording");
  else if (control.isRunning())
    text << (now.lostRecords > 0 ? tr("recording, %1 ticks lost").arg(now.lostRecords)
                                 : tr("recording"));
  else
    text << tr("not started");
  if (control.isRunning()) text << tr("late ticks: %1").arg(now.lateTicks);
  if (!device.isEmpty()) text << device << tr("%1 overruns").arg(now.overruns);
  if (!control.couplingText().empty())
    text << tr("coupling %1 N/m").arg(numberText(now.couplingStiffness, 0));
  text << tr("%1 fps").arg(framesPerSecond);
  text << tr("not a medical device");
  return text.join(QStringLiteral(" · "));
}

QString errorText(const InsertionControl& control, const QString& error)
{
  const haptics::TickOutput& now = control.now().output;
  if (now.workflow == Workflow::fault) {
    const QString what = (now.status & haptics::deviceLost) != 0 ? tr("The hand stopped answering.")
                         : (now.status & haptics::notFinite) != 0
                             ? tr("The computed motion left every bound.")
                             : tr("The insertion was stopped.");
    return what + tr(" The force is off and the array rests. Press Reset to start again.");
  }
  if (!error.isEmpty()) return error;
  const std::string recording = control.recordingError();
  if (!recording.empty())
    return tr("This insertion is not being recorded: %1").arg(QString::fromStdString(recording));
  return {};
}

QString hintText(const InsertionControl& control)
{
  const haptics::TickOutput& now = control.now().output;
  if (control.isAtDepth()) return tr("Full depth. Withdraw or Reset.");
  if (now.workflow == Workflow::finished) return tr("The array is out. Reset to insert again.");
  if (control.hand() == InputSource::scripted) return {};
  if (control.hand() == InputSource::device) return deviceHint(control);
  if (!control.isRunning()) return tr("Press Start, then hold Space and turn the wheel.");
  if (!control.isHeld()) return tr("Hold Space, then turn the wheel or press Down.");
  return tr("Array held. Wheel or Down advances, Up withdraws.");
}

QString buildingHint(bool isStartAsked)
{
  return isStartAsked ? tr("Building the cochlea; then the insertion starts…")
                      : tr("Building the cochlea…");
}

QString styletText(const InsertionControl& control)
{
  if (!control.scenario().array().hasStylet) return tr("no stylet");
  const double withdrawn_mm = inMillimeters(Length::fromSi(control.now().output.styletWithdrawal));
  return withdrawn_mm > 0.0 ? tr("%1 mm out").arg(numberText(withdrawn_mm, 1)) : tr("in");
}

}  // namespace perilymph::gui

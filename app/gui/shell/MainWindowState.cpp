// What the window says of the insertion as it is: which buttons can be pressed, what the bars, the
// hint and the banner say.

#include "gui/pages/devices/DevicePage.h"
#include "gui/pages/insert/BottomBar.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/parts/Numbers.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/SettingsSheet.h"
#include "gui/shell/TopBar.h"

namespace perilymph::gui {

using haptics::Workflow;

void MainWindow::showState()
{
  const haptics::Snapshot& now = control_.now();
  const Workflow workflow = now.output.workflow;
  const bool isRunning = control_.isRunning();
  const bool isScripted = control_.hand() == InputSource::scripted;
  const bool hasMoved = isRunning && workflow != Workflow::idle && workflow != Workflow::armed;
  const bool isBusy = modelBuilder_.isBusy();
  const bool isThere = workflow == Workflow::finished || workflow == Workflow::fault;

  building_->show(modelBuilder_.busyFor_ms());

  if (isScripted)
    bottom_->setMain(control_.isMoving() ? BottomBar::Main::pause : BottomBar::Main::start,
                     !isThere && !isBusy);
  else
    bottom_->setMain(BottomBar::Main::start, !isRunning && !isBusy);
  bottom_->setWait(isBusy ? tr("The cochlea is being built; then the insertion can start.")
                          : QString());
  bottom_->setWithdrawEnabled(hasMoved && workflow != Workflow::fault && now.output.travel > 0.0 &&
                              (isScripted || workflow == Workflow::finished));
  side_->setChangeable(isChangeable());
  devices_->setChangeable(!hasMoved || isThere);
  settings_->setChangeable(!hasMoved || isThere);
  showDevice();
  side_->setHoldEnabled(isRunning && workflow != Workflow::fault);

  const bool hasStylet = control_.scenario().array.hasStylet;
  const double withdrawn_mm = inMillimeters(Length::fromSi(now.output.styletWithdrawal));
  const QString stylet = !hasStylet           ? tr("no stylet")
                         : withdrawn_mm > 0.0 ? tr("%1 mm out").arg(numberText(withdrawn_mm, 1))
                                              : tr("in");
  side_->setStylet(stylet, hasStylet && hasMoved && !control_.isStyletPulled());

  if (!isRunning)
    top_->setDevice(DeviceState::off, tr("ready"), QString::fromStdString(control_.handName()));
  else if (workflow == Workflow::fault)
    top_->setDevice(DeviceState::alarm, tr("fault · no force"), errorText());
  else if (now.measuredRate > 0.0)
    top_->setDevice(DeviceState::steady,
                    tr("%1 Hz · %2 late").arg(numberText(now.measuredRate, 0)).arg(now.lateTicks),
                    tr("%1. Ticks a second as measured, and ticks that began more than one period "
                       "late.")
                        .arg(QString::fromStdString(control_.handName())));
  else
    top_->setDevice(DeviceState::steady, tr("running"),
                    QString::fromStdString(control_.handName()));

  bottom_->setStatus(statusText(), !control_.recordingError().empty());
  view_->setBanner(errorText());
  view_->setHint(hintText());
}

QString MainWindow::statusText() const
{
  const haptics::Snapshot& now = control_.now();
  QStringList text;
  if (!control_.recordingError().empty())
    text << tr("NOT recording");
  else if (control_.isRunning())
    text << (now.lostRecords > 0 ? tr("recording, %1 ticks lost").arg(now.lostRecords)
                                 : tr("recording"));
  else
    text << tr("not started");
  if (control_.isRunning()) text << tr("late ticks: %1").arg(now.lateTicks);
  if (!deviceText_.isEmpty()) text << deviceText_ << tr("%1 overruns").arg(now.overruns);
  if (!control_.couplingText().empty())
    text << tr("coupling %1 N/m").arg(numberText(now.couplingStiffness, 0));
  text << tr("%1 fps").arg(meter_.framesPerSecond(FrameMeter::Clock::now()));
  text << tr("not a medical device");
  return text.join(QStringLiteral(" · "));
}

QString MainWindow::errorText() const
{
  const haptics::TickOutput& now = control_.now().output;
  if (now.workflow == Workflow::fault) {
    const QString what = (now.status & haptics::deviceLost) != 0 ? tr("The hand stopped answering.")
                         : (now.status & haptics::notFinite) != 0
                             ? tr("The computed motion left every bound.")
                             : tr("The insertion was stopped.");
    return what + tr(" The force is off and the array rests. Press Reset to begin anew.");
  }
  if (!error_.isEmpty()) return error_;
  const std::string recording = control_.recordingError();
  if (!recording.empty())
    return tr("This insertion is not being recorded: %1").arg(QString::fromStdString(recording));
  return {};
}

QString MainWindow::deviceHint() const
{
  if (!control_.isRunning()) {
    const QString press = tr("Press Start, then hold the device’s button and push.");
    if (control_.couplingText().empty()) return press;
    return press + QLatin1Char('\n') +
           tr("Coupling %1 N/m, softer than asked: Devices (H).")
               .arg(numberText(control_.now().couplingStiffness, 0));
  }
  if (!control_.isMoving()) return tr("Hold the device’s button: the array follows the hand.");
  return tr("Array held. Letting go of the button lets it rest.");
}

QString MainWindow::hintText() const
{
  const haptics::TickOutput& now = control_.now().output;
  if (modelBuilder_.isBusy())
    return isStartAsked_ ? tr("Building the cochlea; then the insertion starts…")
                         : tr("Building the cochlea…");
  if (control_.isAtDepth()) return tr("Full depth. Withdraw or Reset.");
  if (now.workflow == Workflow::finished) return tr("The array is out. Reset to insert again.");
  if (control_.hand() == InputSource::scripted) return {};
  if (control_.hand() == InputSource::device) return deviceHint();
  if (!control_.isRunning()) return tr("Press Start, then hold Space and turn the wheel.");
  if (!control_.isHeld()) return tr("Hold Space, then turn the wheel or press Down.");
  return tr("Array held. Wheel or Down advances, Up withdraws.");
}

}  // namespace perilymph::gui

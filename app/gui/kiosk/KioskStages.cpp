// What happens at the booth: the insertion that repeats, a visitor's turn, and its result.

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <array>

#include "gui/kiosk/BoardView.h"
#include "gui/kiosk/KioskWindow.h"
#include "gui/kiosk/PushPad.h"
#include "gui/parts/Numbers.h"
#include "gui/scene/OperationView.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;
using visualization::CameraPreset;

constexpr int slowInterval_ms = 66;
constexpr double longestStep_s = 0.1;
constexpr double station_s = 6.0;  // how long the tour stays at one place
constexpr double rest_s = 4.0;     // at full depth, before the insertion repeats
constexpr Speed byKey = millimetersPerSecond(2);
constexpr Speed back = millimetersPerSecond(3);

/// Where the tour looks from, one after the other.
constexpr std::array tour{CameraPreset::surgeon, CameraPreset::overview, CameraPreset::followTip};

std::array<QString, tour.size()> tourSentences()
{
  return {KioskWindow::tr("A cochlear implant gives hearing back by an electrode array in the "
                          "inner ear. A surgeon pushes it in by hand, through an opening of a "
                          "millimeter or two."),
          KioskWindow::tr("The cochlea winds up like a snail’s shell. The array has to follow it "
                          "without pressing on the delicate membrane along its way."),
          KioskWindow::tr("What the hand feels are thousandths of a newton. Here the force is "
                          "computed a thousand times a second, and can be practiced.")};
}

}  // namespace

Result<Done> KioskWindow::open()
{
  const Result<Done> prepared = control_.prepare(InputSource::scripted);
  if (!prepared) return prepared;
  const session::Scenario& scenario = control_.scenario();
  view_->setScene(std::make_unique<visualization::InsertionScene>(
      control_.anatomy(), scenario.array, scenario.patient.side));
  sinceFrame_.start();
  sinceSlow_.start();
  timer_.start();
  beginAttract();
  return Done{};
}

void KioskWindow::setStage(KioskStage stage)
{
  stage_ = stage;
  stageAt_s_ = now_s();
  touchedAt_s_ = now_s();
  foot_->setCurrentIndex(static_cast<int>(stage));
  setFocus();
}

void KioskWindow::say(const QString& title, const QString& sentence)
{
  title_->setText(title);
  sentence_->setText(sentence);
}

void KioskWindow::showBoard(std::optional<int> chosen)
{
  const std::vector<KioskEntry>& entries = board_.entriesOf(clock_.today().date());
  QStringList text;
  for (const KioskEntry& entry : entries)
    text << peakText(millinewtons(entry.peak_mN).si(), inVivo_);
  boardView_->show(entries, text, chosen);
}

bool KioskWindow::prepare(InputSource hand)
{
  letGo();
  turn_ = {};
  const Result<Done> prepared = control_.prepare(hand);
  const Result<Done> begun = prepared ? control_.begin() : prepared;
  view_->setBanner(begun ? QString() : QString::fromStdString(begun.error().message));
  if (prepared) view_->showArray(control_.now());
  return static_cast<bool>(begun);
}

void KioskWindow::beginAttract()
{
  restingAt_s_.reset();
  // what cannot be prepared now is tried again when the rest is over
  if (!prepare(InputSource::scripted)) restingAt_s_ = now_s();
  const bool isAnew = stage_ != KioskStage::attract || station_ < 0;
  if (!isAnew) return;
  setStage(KioskStage::attract);
  station_ = -1;
  showBoard(std::nullopt);
}

void KioskWindow::stepAttract()
{
  const int station = int((now_s() - stageAt_s_) / station_s) % int(tour.size());
  if (station != station_) {
    station_ = station;
    view_->glideTo(tour[std::size_t(station)]);
    say(tr("Inserting a cochlear implant"), tourSentences()[std::size_t(station)]);
  }
  const Workflow workflow = control_.now().output.workflow;
  const bool isOver = control_.isAtDepth() || workflow == Workflow::fault;
  if (isOver && !restingAt_s_) restingAt_s_ = now_s();
  if (restingAt_s_ && now_s() - *restingAt_s_ >= rest_s) beginAttract();
}

void KioskWindow::chooseHandle()
{
  if (control_.hand() == InputSource::device) return beginTurn(InputSource::pointer);
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  const auto found = std::find_if(survey.devices.begin(), survey.devices.end(),
                                  [](const device::FoundDevice& hand) { return hand.isUsable(); });
  if (found == survey.devices.end()) return beginTurn(InputSource::pointer);
  control_.choose(*found);
  beginTurn(InputSource::device);
}

void KioskWindow::beginTurn(InputSource hand)
{
  const device::DeviceSurvey survey = device::surveyDevices(device::systemRoots());
  handle_->setVisible(
      std::any_of(survey.devices.begin(), survey.devices.end(),
                  [](const device::FoundDevice& found) { return found.isUsable(); }));
  if (hand == InputSource::scripted) hand = InputSource::pointer;
  setStage(KioskStage::turn);
  if (!prepare(hand)) {
    if (hand == InputSource::device) return beginTurn(InputSource::pointer);
    say(tr("This cannot be tried now"), tr("The staff of the booth can help."));
    return setStage(KioskStage::result);
  }
  const bool isHandle = hand == InputSource::device;
  handle_->setText(isHandle ? tr("Use the screen") : tr("Use the handle"));
  pad_->setEnabled(!isHandle);
  pull_->setEnabled(!isHandle);
  view_->glideTo(CameraPreset::surgeon);
  say(tr("Your turn"),
      isHandle ? tr("Hold the handle’s button and push gently. Keep the force low until the array "
                    "is in.")
               : tr("Hold the green plate and the array moves in, the farther right the faster. "
                    "Keep the force low until it is at full depth."));
  showBoard(std::nullopt);
}

void KioskWindow::endTurn()
{
  letGo();
  if (control_.now().output.workflow == Workflow::fault) {
    say(tr("The array had to be stopped"),
        tr("The motion left what can be computed. The force is off. Try again."));
    return setStage(KioskStage::result);
  }
  const QDateTime today = clock_.today();
  const KioskEntry entry{today.time(), inMillinewtons(Force::fromSi(turn_.peakForce())),
                         turn_.duration(), turn_.reversals()};
  const std::optional<int> place = board_.enter(today.date(), entry);
  const QString peak = numberText(entry.peak_mN, 0);
  say(place ? tr("Full depth · peak force %1 mN · place %2 today").arg(peak).arg(*place)
            : tr("Full depth · peak force %1 mN").arg(peak),
      tr("%1, in %2 s; turned back: %3.")
          .arg(peakText(turn_.peakForce(), inVivo_), numberText(entry.duration_s, 1))
          .arg(entry.reversals));
  setStage(KioskStage::result);
  showBoard(place);
  if (!board_.error().empty()) view_->setBanner(QString::fromStdString(board_.error()));
}

void KioskWindow::letGo()
{
  pushedByKey_ = 0;
  if (pad_ != nullptr) pad_->release();
  if (pull_ != nullptr) pull_->setDown(false);
  control_.pause();
}

bool KioskWindow::isTouched() const
{
  return pad_->isHeld() || pull_->isDown() || pushedByKey_ != 0;
}

void KioskWindow::stepTurn(double elapsed_s)
{
  const bool isHeld = isTouched();
  if (isHeld || (control_.hand() == InputSource::device && control_.isMoving()))
    touchedAt_s_ = now_s();
  if (control_.hand() == InputSource::pointer) {
    if (isHeld != control_.isHeld()) control_.hold(isHeld);
    const double speed = pad_->isHeld()    ? pad_->speed().si()
                         : pull_->isDown() ? -back.si()
                                           : pushedByKey_ * byKey.si();
    if (isHeld && control_.now().output.workflow == Workflow::inserting)
      control_.advanceBy(Length::fromSi(speed * elapsed_s));
  }
  turn_.follow(control_.now().output);
  if (control_.isAtDepth() || control_.now().output.workflow == Workflow::fault) endTurn();
}

void KioskWindow::showPicture()
{
  const haptics::TickOutput& now = control_.now().output;
  const std::pair<double, double> seen{now.travel, now.axialForce};
  if (seen == drawn_) return;
  drawn_ = seen;
  view_->showArray(control_.now());
}

void KioskWindow::onFrame()
{
  ++frames_;
  const double elapsed_s = std::min(double(sinceFrame_.restart()) / 1e3, longestStep_s);
  if (control_.update()) showPicture();
  if (stage_ == KioskStage::attract) stepAttract();
  if (stage_ == KioskStage::turn) stepTurn(elapsed_s);
  if (stage_ != KioskStage::attract && now_s() - touchedAt_s_ >= patience_s) beginAttract();
  view_->stepCamera(elapsed_s);
  view_->renderIfDirty();
  if (sinceSlow_.elapsed() < slowInterval_ms) return;
  sinceSlow_.restart();
  view_->showNumbers(control_.now().output, control_.scenario().stopTravel);
}

void KioskWindow::onPresented()
{
  if (!isFirstFrame_ || !timer_.isActive()) return;
  isFirstFrame_ = false;
  Q_EMIT firstFrameShown();
}

}  // namespace perilymph::gui

// A recorded insertion looked at again, in the place of the one that runs.

#include <QKeyEvent>
#include <QStackedWidget>

#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/scene/OperationView.h"
#include "gui/shell/KeyList.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/SettingsSheet.h"
#include "gui/shell/TopBar.h"

namespace perilymph::gui {

namespace {

using haptics::Workflow;

constexpr int manyTicks = 100;  // of a step with Shift

bool hasBegun(const haptics::TickOutput& output)
{
  return output.workflow != Workflow::idle && output.workflow != Workflow::armed;
}

}  // namespace

void MainWindow::connectReplay()
{
  connect(replay_, &ReplayPlayer::opened, this, &MainWindow::beginReplay);
  connect(replay_, &ReplayPlayer::failed, this,
          [this](const QString& sentence) { sessions_->say(sentence, true); });
  connect(replayBar_, &ReplayBar::playAsked, this,
          [this] { replay_->isPlaying() ? replay_->pause() : replay_->play(); });
  connect(replayBar_, &ReplayBar::stepAsked, this, [this](int ticks) { replay_->stepBy(ticks); });
  connect(replayBar_, &ReplayBar::slowerAsked, replay_, &ReplayPlayer::slower);
  connect(replayBar_, &ReplayBar::fasterAsked, replay_, &ReplayPlayer::faster);
  connect(replayBar_, &ReplayBar::draggedTo, this, [this](double fraction) {
    if (replay_->isOpen())
      replay_->seek(std::uint64_t(fraction * double(replay_->playback().ticks() - 1)));
  });
  connect(replayBar_, &ReplayBar::closeAsked, this, &MainWindow::closeReplay);
}

void MainWindow::openReplay(const std::filesystem::path& file)
{
  sessions_->say(tr("Opening %1…").arg(QString::fromStdString(file.stem().string())));
  if (replay_->isOpen()) views_->forgetScene();
  replay_->open(file);
}

void MainWindow::beginReplay()
{
  // Nothing may move but the picture: the insertion ends, and no device stays open.
  modelBuilder_.forget();
  isStartAsked_ = false;
  handBefore_ = control_.hand();
  prepare(InputSource::scripted);
  showPage(Page::insert);
  const session::Playback& playback = replay_->playback();
  const session::Scenario& scenario = playback.scenario();
  bars_->setCurrentWidget(replayBar_);
  side_->hide();  // it tells of the insertion to come, not of this one
  top_->setModified(false, {});
  top_->setDevice(DeviceState::off, tr("replay"), tr("A recording is shown. No device is moved."));
  views_->setScene(*playback.anatomy(), scenario);
  charts_->begin(playback.anatomy()->entry());
  charted_ = 0;
  view_->setBanner({});
  setWindowTitle(
      tr("Perilymph · replay of %1").arg(QString::fromStdString(playback.file().stem().string())));
  replay_->play();
}

void MainWindow::closeReplay()
{
  if (!replay_->isOpen()) return;
  views_->forgetScene();
  replay_->close();
  bars_->setCurrentIndex(0);
  side_->show();
  showScenario();
  prepare(handBefore_);
  showCochlea();
  useSetup();  // a change that was being built when the replay began
}

bool MainWindow::frameOfReplay(double elapsed_s)
{
  if (!replay_->isOpen()) return false;
  if (page_ != Page::insert) replay_->pause();
  if (!replay_->advance(elapsed_s)) return true;
  view_->showArray(replay_->now());

  // the curves up to here, in even steps and with the very tick at their end
  const auto& samples = replay_->playback().samples();
  if (charted_ > 0 && samples[charted_ - 1].place > replay_->place()) {
    charts_->begin(replay_->playback().anatomy()->entry());
    charted_ = 0;
  }
  for (; charted_ < samples.size() && samples[charted_].place <= replay_->place(); ++charted_)
    if (hasBegun(samples[charted_].output)) charts_->append(samples[charted_].output);
  return true;
}

void MainWindow::showReplay()
{
  const session::Scenario& scenario = replay_->playback().scenario();
  view_->showNumbers(replay_->now().output, scenario.stopTravel);
  views_->showSlowly(replay_->now());
  view_->setHint(replay_->isPlaying() ? QString()
                                      : tr("Space plays. Left and Right step by one tick."));
  replayBar_->showPlace(*replay_);
}

bool MainWindow::keyOfReplay(QKeyEvent* event)
{
  if (!replay_->isOpen() || (event->modifiers() & Qt::AltModifier) != 0) return false;
  if ((event->modifiers() & Qt::ControlModifier) != 0)  // neither reset nor undo meanwhile
    return event->key() == Qt::Key_R || event->key() == Qt::Key_Z;
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  switch (event->key()) {
    case Qt::Key_Space:
      replay_->isPlaying() ? replay_->pause() : replay_->play();
      return true;
    case Qt::Key_Left:
      replay_->stepBy(isShift ? -manyTicks : -1);
      return true;
    case Qt::Key_Right:
      replay_->stepBy(isShift ? manyTicks : 1);
      return true;
    case Qt::Key_Home:
      replay_->seek(0);
      return true;
    case Qt::Key_End:
      replay_->seek(replay_->playback().ticks() - 1);
      return true;
    case Qt::Key_Comma:
      replay_->slower();
      return true;
    case Qt::Key_Period:
      replay_->faster();
      return true;
    case Qt::Key_Escape:
      if (keys_->isVisible() || settings_->isVisible()) return false;
      closeReplay();
      return true;
    // What would move an array.
    case Qt::Key_Backspace:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_S:
    case Qt::Key_H:
      return !isShift;
    default:
      return false;
  }
}

}  // namespace perilymph::gui

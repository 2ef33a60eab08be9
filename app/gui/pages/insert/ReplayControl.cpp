// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ReplayControl.h"

#include <QKeyEvent>

#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/ReplayBar.h"
#include "gui/pages/insert/ReplayPlayer.h"
#include "gui/run/WorkflowPredicates.h"
#include "gui/scene/OperationView.h"
#include "gui/setup/StopTravel.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/PublishedConditions.h"

namespace perilymph::gui {

namespace {

constexpr int manyTicks = 100;  // of a step with Shift

}  // namespace

ReplayControl::ReplayControl(ReplayPlayer& player, InsertionViews& views, QWidget* page)
    : QObject(page), player_(player), views_(views), bar_(new ReplayBar(page))
{
  connectBar();
}

void ReplayControl::connectBar()
{
  connect(bar_, &ReplayBar::playRequested, this, &ReplayControl::togglePlaying);
  connect(bar_, &ReplayBar::stepRequested, &player_, &ReplayPlayer::stepBy);
  connect(bar_, &ReplayBar::slowerRequested, &player_, &ReplayPlayer::slower);
  connect(bar_, &ReplayBar::fasterRequested, &player_, &ReplayPlayer::faster);
  connect(bar_, &ReplayBar::draggedTo, this, [this](double fraction) {
    if (player_.isOpen())
      player_.seek(std::uint64_t(fraction * double(player_.playback().ticks() - 1)));
  });
  connect(bar_, &ReplayBar::closeRequested, this, &ReplayControl::closeRequested);
}

void ReplayControl::togglePlaying() { player_.isPlaying() ? player_.pause() : player_.play(); }

void ReplayControl::begin()
{
  views_.setScene(*player_.playback().anatomy(), player_.playback().scenario());
  const session::Scenario& scenario = player_.playback().scenario();
  views_.charts()->setComparable(analysis::hasPublishedConditions(scenario));
  views_.operation()->setPartial(outsideAtStop(scenario).si() > 0.0);
  views_.charts()->showPlanIn(scenario);
  views_.charts()->showRibsOf(scenario);
  views_.charts()->begin(player_.playback().anatomy()->entry());
  charted_ = 0;
  views_.operation()->setBanner({});
  bar_->showEvents(player_);
  player_.play();
}

void ReplayControl::step(double elapsed_s, bool isSeen)
{
  if (!isSeen) player_.pause();
  if (!player_.advance(elapsed_s)) return;
  views_.operation()->showArray(player_.now());

  // the curves up to here, at equal steps and with the current tick at their end
  const auto& samples = player_.playback().samples();
  if (charted_ > 0 && samples[charted_ - 1].place > player_.place()) {
    views_.charts()->begin(player_.playback().anatomy()->entry());
    charted_ = 0;
  }
  for (; charted_ < samples.size() && samples[charted_].place <= player_.place(); ++charted_)
    if (hasBegun(samples[charted_].output.workflow))
      views_.charts()->append(samples[charted_].output, samples[charted_].peak);
}

void ReplayControl::updateReadouts()
{
  views_.operation()->showNumbers(
      player_.now().output,
      analysis::angularInsertionDepth(*player_.playback().anatomy(),
                                      player_.playback().scenario().array(), player_.now()),
      player_.playback().scenario().stopTravel());
  views_.showSlowly(player_.now());
  views_.operation()->setHint(
      player_.isPlaying() ? QString() : tr("Space plays or pauses. ← and → step by 1 ms."));
  bar_->showPlace(player_);
}

bool ReplayControl::takeKey(const QKeyEvent& event)
{
  if (!player_.isOpen() || (event.modifiers() & Qt::AltModifier) != 0) return false;
  if ((event.modifiers() & Qt::ControlModifier) != 0)  // no reset and no undo during a replay
    return event.key() == Qt::Key_R || event.key() == Qt::Key_Z;
  const bool isShift = (event.modifiers() & Qt::ShiftModifier) != 0;
  switch (event.key()) {
    case Qt::Key_Space:
      togglePlaying();
      return true;
    case Qt::Key_Left:
      player_.stepBy(isShift ? -manyTicks : -1);
      return true;
    case Qt::Key_Right:
      player_.stepBy(isShift ? manyTicks : 1);
      return true;
    case Qt::Key_Home:
      player_.seek(0);
      return true;
    case Qt::Key_End:
      player_.seek(player_.playback().ticks() - 1);
      return true;
    case Qt::Key_Comma:
      player_.slower();
      return true;
    case Qt::Key_Period:
      player_.faster();
      return true;
    case Qt::Key_Escape:
      Q_EMIT closeRequested();
      return true;
    // Keys that would move an array.
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

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/FrameLoop.h"

#include <algorithm>
#include <utility>

namespace perilymph::gui {

namespace {

constexpr int slowInterval_ms = 66;    // charts and numbers: 15 Hz
constexpr int restingTurns = 60;       // then nothing moves
constexpr int restInterval_ms = 50;    // until something does
constexpr double longestStep_s = 0.1;  // after a stall, keys are not caught up

}  // namespace

FrameLoop::FrameLoop(Turn turn, QObject* parent) : QObject(parent), turn_(std::move(turn))
{
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &FrameLoop::takeTurn);
}

void FrameLoop::start()
{
  sinceTurn_.start();
  sinceSlow_.start();
  timer_.start();
}

void FrameLoop::takeTurn()
{
  meter_.begin(FrameMeter::Clock::now());
  turn_.step(std::min(double(sinceTurn_.restart()) / 1e3, longestStep_s));
  const bool isSeen = turn_.isSeen();
  bool isDrawn = isSeen && turn_.drawPicture();
  if (sinceSlow_.elapsed() >= slowInterval_ms) {
    sinceSlow_.restart();
    turn_.updateReadouts();
    if (isSeen && turn_.drawCharts()) isDrawn = true;
  }
  if (!isDrawn) meter_.cancel();
  slowDownAtRest(isDrawn);
  if (!isSeen && isFirstFrame_) {
    isFirstFrame_ = false;
    Q_EMIT firstFrameShown();
  }
}

void FrameLoop::setInterval(int interval_ms)
{
  interval_ms_ = interval_ms;
  timer_.setInterval(interval_ms);
}

void FrameLoop::slowDownAtRest(bool isDrawn)
{
  turnsAtRest_ = isDrawn ? 0 : turnsAtRest_ + 1;
  const bool isAtRest = turnsAtRest_ > restingTurns;
  const int wanted_ms = isAtRest ? std::max(interval_ms_, restInterval_ms) : interval_ms_;
  if (timer_.interval() != wanted_ms) timer_.setInterval(wanted_ms);
}

void FrameLoop::present()
{
  meter_.present(FrameMeter::Clock::now());
  if (!isFirstFrame_ || !timer_.isActive() || meter_.frames() == 0) return;
  isFirstFrame_ = false;
  Q_EMIT firstFrameShown();
}

}  // namespace perilymph::gui

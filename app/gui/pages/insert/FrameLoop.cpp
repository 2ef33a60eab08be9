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

bool ChartPace::isDue(qint64 now_ms, qint64 turn_ms, int interval_ms) const
{
  const bool isLate = turn_ms > std::max(lateTurn_ms, 3 * interval_ms / 2);
  return isOverdue(now_ms) || (now_ms - drawn_ms_ >= interval_ms_ && !isLate);
}

FrameLoop::FrameLoop(Turn turn, QObject* parent) : QObject(parent), turn_(std::move(turn))
{
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &FrameLoop::takeTurn);
}

void FrameLoop::start()
{
  sinceTurn_.start();
  sinceSlow_.start();
  sinceStart_.start();
  timer_.start();
}

void FrameLoop::takeTurn()
{
  const FrameMeter::Clock::time_point began = FrameMeter::Clock::now();
  const qint64 elapsed_ms = sinceTurn_.restart();
  turn_.step(std::min(double(elapsed_ms) / 1e3, longestStep_s));
  const bool isSeen = turn_.isSeen();
  bool isDrawn = isSeen && turn_.drawPicture();
  // numbers and each chart in frames of their own, so that none of these is much longer than others
  const bool areNumbersDue = sinceSlow_.elapsed() >= slowInterval_ms;
  if (areNumbersDue) {
    sinceSlow_.restart();
    turn_.updateReadouts();
  }
  const qint64 now_ms = sinceStart_.elapsed();
  const bool isChartDue = areNumbersDue ? charts_.isOverdue(now_ms)
                                        : charts_.isDue(now_ms, elapsed_ms, timer_.interval());
  if (isSeen && isChartDue && turn_.drawChart()) {
    charts_.drawn(now_ms);
    isDrawn = true;
  }
  if (isDrawn) meter_.begin(began);  // else the frame before may still be on its way
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

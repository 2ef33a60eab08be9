// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The timer of the frames, at most 60 per second.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "gui/pages/insert/FrameMeter.h"

namespace perilymph::gui {

/// When a chart is drawn: every 33 ms one of the two, so that each is drawn at most fifteen times a second, and
/// none while frames are late, but for one each `longest_ms`.
class ChartPace {
public:
  /// A turn that begins later than this after the one before is late: 30 frames a second.
  static constexpr int lateTurn_ms = 33;
  /// On a machine where every frame is late, a chart is drawn this often.
  static constexpr int longest_ms = 120;

  /// @param now_ms       On any clock that only grows.
  /// @param turn_ms      Since the turn before this one.
  /// @param interval_ms  Between turns as the timer is set.
  bool isDue(qint64 now_ms, qint64 turn_ms, int interval_ms) const;
  /// No chart was drawn for so long that one is drawn even in a late frame.
  bool isOverdue(qint64 now_ms) const { return now_ms - drawn_ms_ >= longest_ms; }
  void drawn(qint64 now_ms) { drawn_ms_ = now_ms; }

private:
  static constexpr int interval_ms_ = 33;
  qint64 drawn_ms_ = -longest_ms;
};

/// Each timer event advances the insertion and draws what changed in the 3D view; fifteen times a
/// second also numbers and charts, each in other frames.
class FrameLoop : public QObject {
  Q_OBJECT
public:
  /// Functions called in a timer event. Drawing functions return whether anything was drawn.
  struct Turn {
    std::function<void(double elapsed_s)> step;
    std::function<void()> updateReadouts;
    std::function<bool()> drawPicture;
    std::function<bool()> drawChart;  ///< The one of the charts that was not drawn for longest.
    std::function<bool()> isSeen;     ///< Whether the page is visible.
  };

  FrameLoop(Turn turn, QObject* parent);

  void start();
  void setInterval(int interval_ms);
  /// The composed window was passed to the display.
  void present();

  const FrameMeter& meter() const { return meter_; }
  /// Resets the statistics.
  void restartMeter() { meter_ = {}; }

Q_SIGNALS:
  /// The first frame with the cochlea is on the display, or another page is.
  void firstFrameShown();

private:
  void takeTurn();
  void slowDownAtRest(bool isDrawn);

  Turn turn_;
  QTimer timer_;
  int interval_ms_ = 0;
  int turnsAtRest_ = 0;  ///< Since something was drawn.
  QElapsedTimer sinceTurn_, sinceSlow_, sinceStart_;
  ChartPace charts_;
  FrameMeter meter_;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui

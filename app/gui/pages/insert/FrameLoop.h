// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The timer of the frames, at most 60 per second.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "gui/pages/insert/FrameMeter.h"

namespace perilymph::gui {

/// Each timer event advances the insertion and draws what changed in the 3D view; fifteen times a
/// second also numbers and charts.
class FrameLoop : public QObject {
  Q_OBJECT
public:
  /// Functions called in a timer event. Drawing functions return whether anything was drawn.
  struct Turn {
    std::function<void(double elapsed_s)> step;
    std::function<void()> updateReadouts;
    std::function<bool()> drawPicture, drawCharts;
    std::function<bool()> isSeen;  ///< Whether the page is visible.
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
  QElapsedTimer sinceTurn_, sinceSlow_;
  FrameMeter meter_;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui

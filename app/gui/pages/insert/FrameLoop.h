#pragma once

// The one timer that keeps the picture new, at most 60 times a second.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "gui/parts/FrameMeter.h"

namespace perilymph::gui {

/// Takes turns: each one lets the insertion step and draws what changed of the picture; fifteen a
/// second do the same for numbers and charts.
class FrameLoop : public QObject {
  Q_OBJECT
public:
  /// What is drawn in a turn. Functions that draw say whether anything was.
  struct Turn {
    std::function<void(double elapsed_s)> step;
    std::function<void()> stepSlowly;
    std::function<bool()> drawPicture, drawCharts;
    std::function<bool()> isSeen;  ///< Whether the page is shown.
  };

  FrameLoop(Turn turn, QObject* parent);

  void start();
  void setInterval(int interval_ms) { timer_.setInterval(interval_ms); }
  /// The composed window was handed to the display.
  void present();

  const FrameMeter& meter() const { return meter_; }
  /// Forgets the frames so far.
  void restartMeter() { meter_ = {}; }

Q_SIGNALS:
  /// The first frame with the cochlea in it is on the display, or another page is.
  void firstFrameShown();

private:
  void takeTurn();

  Turn turn_;
  QTimer timer_;
  QElapsedTimer sinceTurn_, sinceSlow_;
  FrameMeter meter_;
  bool isFirstFrame_ = true;
};

}  // namespace perilymph::gui

#pragma once

// How long frames take, and how many there are.

#include <chrono>
#include <string>
#include <vector>

namespace perilymph::gui {

/// Times frames from the beginning of the timer's turn (commands, snapshot, scene, charts, labels)
/// over the rendering of every view that changed to the moment the composed window was handed to
/// the display.
class FrameMeter {
public:
  using Clock = std::chrono::steady_clock;

  /// A frame begins. One that was begun and never presented is forgotten.
  void begin(Clock::time_point now);
  /// The frame that was begun is on the display.
  void present(Clock::time_point now);
  /// Nothing had to be drawn in this turn.
  void cancel() { isOpen_ = false; }

  /// Frames presented during the last second before `now`.
  int framesPerSecond(Clock::time_point now) const;
  std::size_t frames() const { return durations_ms_.size(); }
  /// From the first frame to the last one.
  double span_s() const;
  /// The time that a share (0 to 1) of all frames did not exceed [ms]; 0 without frames.
  double quantile_ms(double fraction) const;
  /// "median 28.1 ms, p95 35.0 ms, 33.9 frames/s over 280 frames".
  std::string report() const;

private:
  bool isOpen_ = false;
  Clock::time_point began_;
  std::vector<double> durations_ms_;
  std::vector<Clock::time_point> presented_;
};

}  // namespace perilymph::gui

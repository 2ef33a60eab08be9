// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Measurement of frame times and frame rate.

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace perilymph::gui {

/// Measures frame times from the timer event (commands, snapshot, scene, charts, labels) over the
/// rendering of every changed view until the composed window was passed to the display.
class FrameMeter {
public:
  using Clock = std::chrono::steady_clock;

  /// Begins a frame. A previous frame that was never presented is ignored.
  void begin(Clock::time_point now);
  /// Ends a frame: it is on the display.
  void present(Clock::time_point now);

  /// Frames presented during the last second before `now`.
  int framesPerSecond(Clock::time_point now) const;
  std::size_t frames() const { return durations_ms_.size(); }
  /// Time from the first frame to the last one.
  double span_s() const;
  /// Quantile of the frame times, fraction 0 to 1 [ms]; 0 without frames.
  double quantile_ms(double fraction) const;
  /// "frame time median 28.1 ms, p95 35.0 ms, 33.9 frames/s over 280 frames; processor time a frame
  /// 24.0 ms, 11.2 ms of it in this thread". Other programs on the machine hardly change the latter.
  std::string report() const;

private:
  /// Processor time used so far [ns].
  struct ProcessorTime {
    std::int64_t process = 0, thread = 0;
  };
  static ProcessorTime processorTime();

  bool isOpen_ = false;
  Clock::time_point began_;
  std::vector<double> durations_ms_;
  std::vector<Clock::time_point> presented_;
  std::size_t counted_ = 0;  ///< Frames between the two.
  ProcessorTime first_, last_;
};

}  // namespace perilymph::gui

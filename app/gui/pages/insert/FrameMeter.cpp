// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/FrameMeter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "perilymph/foundation/Quantile.h"
#include "perilymph/realtime/ThreadTime.h"

namespace perilymph::gui {

namespace {

// An hour at 60 frames per second; then the older half is dropped to bound memory.
constexpr std::size_t maxFrames = 216'000;

}  // namespace

void FrameMeter::begin(Clock::time_point now)
{
  began_ = now;
  isOpen_ = true;
}

void FrameMeter::present(Clock::time_point now)
{
  if (!isOpen_) return;
  isOpen_ = false;
  if (durations_ms_.size() >= maxFrames) {
    durations_ms_.erase(durations_ms_.begin(), durations_ms_.begin() + maxFrames / 2);
    presented_.erase(presented_.begin(), presented_.begin() + maxFrames / 2);
  }
  durations_ms_.push_back(std::chrono::duration<double, std::milli>(now - began_).count());
  presented_.push_back(now);
  last_ = processorTime();
  if (durations_ms_.size() == 1) first_ = last_;
  if (durations_ms_.size() > 1) ++counted_;
}

FrameMeter::ProcessorTime FrameMeter::processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return {std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec, realtime::threadNanoseconds()};
}

int FrameMeter::framesPerSecond(Clock::time_point now) const
{
  const auto first =
      std::upper_bound(presented_.begin(), presented_.end(), now - std::chrono::seconds(1));
  return static_cast<int>(presented_.end() - first);
}

double FrameMeter::quantile_ms(double fraction) const { return quantile(durations_ms_, fraction); }

double FrameMeter::span_s() const
{
  if (presented_.size() < 2) return 0.0;
  return std::chrono::duration<double>(presented_.back() - presented_.front()).count();
}

std::string FrameMeter::report() const
{
  const double span = span_s();
  const double perSecond = span > 0.0 ? static_cast<double>(presented_.size() - 1) / span : 0.0;
  const double frames_ns = 1e6 * static_cast<double>(std::max<std::size_t>(1, counted_));
  char text[256];
  std::snprintf(text, sizeof text,
                "frame time median %.1f ms, p95 %.1f ms, %.1f frames/s over %zu frames; "
                "processor time a frame %.1f ms, %.1f ms of it in this thread",
                quantile_ms(0.5), quantile_ms(0.95), perSecond, durations_ms_.size(),
                static_cast<double>(last_.process - first_.process) / frames_ns,
                static_cast<double>(last_.thread - first_.thread) / frames_ns);
  return text;
}

}  // namespace perilymph::gui

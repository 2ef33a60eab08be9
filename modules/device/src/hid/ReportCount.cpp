// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ReportCount.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace perilymph::device {

namespace {

// More reports than any pause leaves in a queue: a larger step back means that the device restarted
// its counter.
constexpr std::uint64_t maxBack = 200;

/// Increment of a counter, across a wrap at 8, 16 or 32 bits.
std::optional<std::uint64_t> stepsOverWrap(std::uint64_t from, std::uint64_t to) noexcept
{
  constexpr std::array<std::uint64_t, 3> ends = {std::uint64_t{1} << 8, std::uint64_t{1} << 16,
                                                 std::uint64_t{1} << 32};
  for (const std::uint64_t end : ends)
    if (from < end && to + end - from <= std::min(maxBack, end / 4)) return to + end - from;
  return std::nullopt;
}

}  // namespace

ReportCount::ReportCount(double period) noexcept
    : period_(std::llround(std::clamp(period, 1e-5, 1.0) * 1e9)),
      // as for a stale hand: three periods, at least 3 ms, at most 30 ms
      maxAge_(std::clamp<std::int64_t>(3 * period_, 3'000'000, 30'000'000))
{
}

void ReportCount::reset() noexcept
{
  hasCounter_ = false;
  lost_ = 0;
  reports_ = 0;
}

ReportCount::Verdict ReportCount::classify(std::uint64_t counter, std::int64_t now,
                                           std::int64_t emptyAt) noexcept
{
  lost_ = 0;
  if (!hasCounter_) {
    hasCounter_ = counter != 0;
    last_ = counter;
    lastTime_ = now;
    minOffset_ = now - reports_ * period_;
    return Verdict::fresh;
  }
  if (counter == last_) return Verdict::duplicate;

  std::uint64_t steps = counter - last_;
  if (counter < last_) {
    const auto wrapped = stepsOverWrap(last_, counter);
    if (!wrapped && last_ - counter <= maxBack) return Verdict::old;
    if (!wrapped) {
      reset();
      return classify(counter, now, emptyAt);
    }
    steps = *wrapped;
  }
  last_ = counter;
  lost_ = steps - 1;
  reports_ += static_cast<std::int64_t>(std::min<std::uint64_t>(steps, 1'000'000'000));

  const std::int64_t offset = now - reports_ * period_;
  minOffset_ = std::min(minOffset_ + (now - lastTime_) / 50, offset);
  if (emptyAt != never) minOffset_ = std::max(minOffset_, offset - (now - emptyAt));
  lastTime_ = now;
  return offset - minOffset_ > maxAge_ ? Verdict::old : Verdict::fresh;
}

}  // namespace perilymph::device

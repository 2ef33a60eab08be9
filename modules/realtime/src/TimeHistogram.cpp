// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/TimeHistogram.h"

#include <algorithm>
#include <bit>

namespace perilymph::realtime {

int TimeHistogram::binOf(std::uint64_t nanoseconds) noexcept
{
  if (nanoseconds < binsPerOctave) return static_cast<int>(nanoseconds);
  const int octave = static_cast<int>(std::bit_width(nanoseconds)) - 6;  // 0 from 32 ns on
  const auto within = static_cast<int>((nanoseconds >> octave) - binsPerOctave);
  return std::min((octave + 1) * binsPerOctave + within, binsPerOctave * octaves - 1);
}

std::uint64_t TimeHistogram::upperEdge(int bin) noexcept
{
  if (bin < binsPerOctave) return static_cast<std::uint64_t>(bin);
  const int octave = bin / binsPerOctave - 1;
  const int within = bin % binsPerOctave;
  const auto next = static_cast<std::uint64_t>(binsPerOctave + within) + 1;
  return (next << octave) - 1;
}

void TimeHistogram::add(std::int64_t nanoseconds) noexcept
{
  const auto duration = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
  ++bins_[static_cast<std::size_t>(binOf(duration))];
  ++count_;
  longest_ = std::max(longest_, duration);
}

double TimeHistogram::quantile(double fraction) const noexcept
{
  if (count_ == 0) return 0.0;
  const double wanted = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count_);
  std::uint64_t seen = 0;
  for (int bin = 0; bin < binsPerOctave * octaves; ++bin) {
    seen += bins_[static_cast<std::size_t>(bin)];
    if (seen > 0 && static_cast<double>(seen) >= wanted)
      return static_cast<double>(std::min(upperEdge(bin), longest_)) * 1e-9;
  }
  return longest();
}

}  // namespace perilymph::realtime

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the logs of both sides say, in numbers.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "TickLog.h"

namespace perilymph::hidstack {

/// What came through of a device's reports.
struct StreamMeasure {
  std::int64_t reports = 0;   ///< That came, repeated ones included.
  std::int64_t lost = 0;      ///< Missing in the device's count.
  std::int64_t repeated = 0;  ///< That came again, or after a newer one.
  double rate = 0.0;          ///< [1/s]
};
/// Stream of a counter of 16 bits that wraps.
StreamMeasure streamIn(const std::vector<ReportRow>& rows);

/// How a set of times is spread [s].
struct Spread {
  double median = 0.0, p99 = 0.0, p999 = 0.0, maximum = 0.0;
};
/// Each the least value that the share of all did not exceed. Zero of nothing.
Spread spreadOf(std::vector<double> values);

/// From the stroke of the device's clock to the force that answers its report.
struct AnswerMeasure {
  std::int64_t ticks = 0;     ///< With a report.
  std::int64_t answered = 0;  ///< Before the next stroke, by exactly one output report.
  std::int64_t caused = 0;    ///< Those with the force of the tick that read this report.
  Spread fromTick;            ///< Stroke to force [s].
  Spread fromReport;          ///< Report handed over to force [s].
  Spread engine;              ///< Sample taken to force ready, in the loop [s].
  Spread besides;             ///< Stroke to force less the engine's share [s].
};
/// Over the ticks of these passages, but for the first of each: what answers it may have been under
/// way. `quantum` is that of the output report [N].
AnswerMeasure answersIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                        const std::vector<std::string>& passages, double quantum);

/// Where the handle was in a passage [m].
struct RestMeasure {
  double mean = 0.0;
  double swing = 0.0;  ///< Greatest minus least.
};
/// Nothing if the passage never came.
std::optional<RestMeasure> restIn(const std::vector<HandleTick>& handle,
                                  const std::string& passage);

/// From the last report before this passage to the first force too small to be shown, as the loop
/// wrote it, and as the device heard it [s]. Nothing where it did not come.
struct SilenceMeasure {
  std::optional<double> written;
  std::optional<double> heard;
  /// The force that stood when the last report was sent, as the loop wrote it [N].
  double before = 0.0;
};
SilenceMeasure silenceIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                         const std::string& passage, double quantum);

}  // namespace perilymph::hidstack

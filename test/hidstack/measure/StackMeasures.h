// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Evaluation of the logs of both sides.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "TickLog.h"

namespace perilymph::hidstack {

/// Received reports of a device.
struct StreamMeasure {
  std::int64_t reports = 0;   ///< Received, repeated ones included.
  std::int64_t lost = 0;      ///< Missing according to the device's counter.
  std::int64_t repeated = 0;  ///< Received again, or after a newer one.
  double rate = 0.0;          ///< [1/s]
};
/// Statistics of a stream with a 16-bit counter.
StreamMeasure streamIn(const std::vector<ReportRow>& rows);

/// Distribution of times [s].
struct Spread {
  double median = 0.0, p99 = 0.0, p999 = 0.0, maximum = 0.0;
};
/// Quantiles of the times; zero if there are none.
Spread spreadOf(std::vector<double> values);

/// Latency from the device's clock to the force that answers its report.
struct AnswerMeasure {
  std::int64_t ticks = 0;     ///< With a report.
  std::int64_t answered = 0;  ///< Before the next tick, by exactly one output report.
  std::int64_t caused = 0;    ///< Answered with the force of the tick that read this report.
  Spread fromTick;            ///< From tick to force [s].
  Spread fromReport;          ///< From sent report to force [s].
  Spread engine;              ///< From sample to force, in the loop [s].
  Spread besides;             ///< From tick to force, without the engine's part [s].
};
/// Over the ticks of these passages, except the first of each, whose answer may have been pending.
/// `quantum` is that of the output report [N].
AnswerMeasure answersIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                        const std::vector<std::string>& passages, double quantum);

/// Positions of the handle in a passage [m].
struct RestMeasure {
  double mean = 0.0;
  double swing = 0.0;  ///< Maximum minus minimum.
};
/// Empty if the passage was never reached.
std::optional<RestMeasure> restIn(const std::vector<HandleTick>& handle,
                                  const std::string& passage);

/// Time from the last report before this passage to the first force too small to be rendered, as
/// written by the loop, and as received by the device [s]. Empty if there is none.
struct SilenceMeasure {
  std::optional<double> written;
  std::optional<double> heard;
  /// The force written by the loop when the last report was sent [N].
  double before = 0.0;
};
SilenceMeasure silenceIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                         const std::string& passage, double quantum);

}  // namespace perilymph::hidstack

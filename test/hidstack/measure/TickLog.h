// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The logs of both sides, as rows of text: words separated by spaces.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// Events between one tick of the device and the next. Times of CLOCK_MONOTONIC [ns].
struct HandleTick {
  std::int64_t due = 0;       ///< Due time of the tick.
  std::int64_t sent = 0;      ///< Time at which its report was sent; 0: none was.
  std::int64_t answered = 0;  ///< Arrival of the first output report after the tick; 0: none.
  std::int64_t force = 0;     ///< Force of that output report along z [quanta].
  std::int64_t outputs = 0;   ///< Output reports until the next tick.
  std::int64_t sequence = 0;  ///< Sequence number of the report.
  double position = 0.0;      ///< Toward the cochlea [m].
  std::string passage;        ///< Passage of the script.
};

/// One tick of the loop. Times of CLOCK_MONOTONIC [ns].
struct LoopTick {
  std::int64_t read = 0;      ///< Time at which the newest sample had been read.
  std::int64_t written = 0;   ///< Time before the force was written.
  std::int64_t sequence = 0;  ///< Sequence number of the report.
  std::int64_t isValid = 0;   ///< Whether the sample was valid.
  double force = 0.0;         ///< Along D's z [N].
};

/// One report from the host's transport.
struct ReportRow {
  std::int64_t read = 0;      ///< Time of arrival [ns].
  std::int64_t sequence = 0;  ///< The device's counter.
};

Result<void> write(const std::filesystem::path& file, const std::vector<HandleTick>& ticks);
Result<void> write(const std::filesystem::path& file, const std::vector<LoopTick>& ticks);
Result<void> write(const std::filesystem::path& file, const std::vector<ReportRow>& rows);

Result<std::vector<HandleTick>> readHandleLog(const std::filesystem::path& file);
Result<std::vector<LoopTick>> readLoopLog(const std::filesystem::path& file);
Result<std::vector<ReportRow>> readReportLog(const std::filesystem::path& file);

}  // namespace perilymph::hidstack

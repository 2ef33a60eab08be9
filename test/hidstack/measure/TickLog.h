// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The logs of both sides of the wire, as rows of text: words between spaces.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// What happened between one tick of the device and the next. Times of CLOCK_MONOTONIC [ns].
struct HandleTick {
  std::int64_t due = 0;       ///< When the device's clock struck.
  std::int64_t sent = 0;      ///< When its report was handed over; 0: none was.
  std::int64_t answered = 0;  ///< When the first output report after the tick came; 0: none did.
  std::int64_t force = 0;     ///< Force of that output report along z [quanta].
  std::int64_t outputs = 0;   ///< Output reports until the next tick.
  std::int64_t sequence = 0;  ///< Sequence number of the report.
  double position = 0.0;      ///< Toward the cochlea [m].
  std::string passage;        ///< Which of the script's.
};

/// One tick of the loop. Times of CLOCK_MONOTONIC [ns].
struct LoopTick {
  std::int64_t read = 0;      ///< When the newest sample had been taken.
  std::int64_t written = 0;   ///< When the force was about to be handed over.
  std::int64_t sequence = 0;  ///< Sequence number of the report.
  std::int64_t isValid = 0;   ///< Whether the sample was valid.
  double force = 0.0;         ///< Along D's z [N].
};

/// One report as the host's transport gave it.
struct ReportRow {
  std::int64_t read = 0;      ///< When [ns].
  std::int64_t sequence = 0;  ///< The device's counter.
};

Result<Done> write(const std::filesystem::path& file, const std::vector<HandleTick>& ticks);
Result<Done> write(const std::filesystem::path& file, const std::vector<LoopTick>& ticks);
Result<Done> write(const std::filesystem::path& file, const std::vector<ReportRow>& rows);

Result<std::vector<HandleTick>> readHandleLog(const std::filesystem::path& file);
Result<std::vector<LoopTick>> readLoopLog(const std::filesystem::path& file);
Result<std::vector<ReportRow>> readReportLog(const std::filesystem::path& file);

}  // namespace perilymph::hidstack

// SPDX-License-Identifier: BSD-3-Clause
#include "recording/DeviceReport.h"

#include <nlohmann/json.hpp>

namespace perilymph::session {

std::string deviceReport(const device::DeviceHealth& health,
                         const haptics::LoopStatistics& statistics)
{
  const device::ReadingFigures& reading = health.reading;
  const device::WritingFigures& writing = health.writing;
  const nlohmann::ordered_json report = {{"period_s", health.period},
                                         {"period_measured", health.isPeriodMeasured},
                                         {"delay_s", health.delay},
                                         {"round_trip_s", health.roundTrip},
                                         {"round_trip_measured", health.isRoundTripMeasured},
                                         {"guarded", health.isGuarded},
                                         {"rate_per_s", reading.overall.rate},
                                         {"interval_median_s", reading.overall.intervalMedian},
                                         {"interval_p99_s", reading.overall.intervalP99},
                                         {"interval_max_s", reading.overall.intervalMax},
                                         {"reports", reading.fresh},
                                         {"lost", reading.lost},
                                         {"duplicates", reading.duplicates},
                                         {"old", reading.old},
                                         {"foreign", reading.foreign},
                                         {"forces", writing.accepted},
                                         {"forces_refused", writing.refused},
                                         {"write_median_s", writing.timeMedian},
                                         {"write_p99_s", writing.timeP99},
                                         {"write_max_s", writing.timeMax},
                                         {"writer_real_time", writing.hasRealTimePriority},
                                         {"reconnections", health.reconnections},
                                         {"blocked_writes", health.blockedWrites},
                                         {"late_ticks", statistics.lateTicks},
                                         {"missed_ticks", statistics.missedTicks},
                                         {"overruns", statistics.overruns},
                                         {"tick_median_s", statistics.tickTimeMedian},
                                         {"tick_p99_s", statistics.tickTimeP99},
                                         {"tick_max_s", statistics.tickTimeMax},
                                         {"real_time", statistics.hasRealTimePriority},
                                         {"memory_locked", statistics.isMemoryLocked}};
  return report.dump();
}

}  // namespace perilymph::session

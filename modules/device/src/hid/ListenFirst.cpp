// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ListenFirst.h"

#include <cmath>

namespace perilymph::device {

namespace {

constexpr std::int64_t maxTime = 100'000'000;  // [ns]
constexpr int enoughReports = 64;
constexpr int fewestReports = 6;
constexpr int maxReads = 10 * enoughReports;
constexpr int writesToTime = 16;
// Maximum ratio between measured and profile period; others are measurement errors of a busy
// machine.
constexpr double maxRatio = 2.0;

/// Discards reports that waited since the handle was opened: their arrival times are unknown.
void discardWaiting(Transport& reading) noexcept
{
  RawReport report;
  for (int i = 0; i < 2 * ReportReader::queueLength; ++i)
    if (reading.read(report, Duration{}) != Transfer::done) break;
}

/// Waits for the report that answers a force: the next one, or the polled one.
bool awaitAnswer(Transport& reading, Transport& writing, const DeviceTraits& profile) noexcept
{
  RawReport report;
  if (profile.reporting == Reporting::onWrite)
    return reading.read(report, Duration::fromSi(0.02)) == Transfer::done;
  report.bytes[0] = profile.polledReport;
  report.size = longestReport;
  return writing.getFeature(report) == Transfer::done;
}

/// Median time to an answer [s]; 0 if the device does not answer.
double timeToAnswer(Transport& reading, Transport& writing, const DeviceTraits& profile,
                    ForceWriter& writer, Clock clock)
{
  realtime::TimeHistogram times;
  const std::int64_t end = clock() + maxTime / 2;
  for (int i = 0; i < writesToTime && clock() < end; ++i) {
    discardWaiting(reading);
    const std::int64_t began = clock();
    if (writer.send(writing, Wrench{}) != Transfer::done) break;
    if (!awaitAnswer(reading, writing, profile)) break;
    times.add(clock() - began);
  }
  return times.quantile(0.5);
}

}  // namespace

FirstImpression listenFirst(Transport& reading, Transport* writing, const DeviceTraits& profile,
                            ForceWriter& writer, Clock clock)
{
  FirstImpression heard;
  const std::int64_t began = clock();
  if (writing != nullptr) {
    for (int i = 0; i < writesToTime && clock() - began < maxTime / 2; ++i)
      if (writer.send(*writing, Wrench{}) != Transfer::done) break;
    heard.writeTime = writer.figures().timeMedian;
  }
  const bool answers =
      profile.reporting == Reporting::onWrite || profile.reporting == Reporting::polled;
  if (answers && writing != nullptr)
    heard.answerTime = timeToAnswer(reading, *writing, profile, writer, clock);
  if (profile.reporting != Reporting::periodic) return heard;

  discardWaiting(reading);
  RawReport report;
  std::int64_t first = 0, last = 0;
  int intervals = -1;
  for (int i = 0; i < maxReads && intervals < enoughReports; ++i) {
    if (clock() - began >= maxTime) break;
    const Transfer transfer = reading.read(report, Duration::fromSi(0.02));
    if (transfer == Transfer::gone) break;
    if (transfer != Transfer::done) continue;
    last = clock();
    if (++intervals == 0) first = last;
  }
  if (intervals < fewestReports || last <= first) return heard;
  const double period = static_cast<double>(last - first) * 1e-9 / intervals;
  const double ratio = period / profile.nominalPeriod;
  if (ratio <= maxRatio && ratio >= 1.0 / maxRatio) heard.period = period;
  return heard;
}

}  // namespace perilymph::device

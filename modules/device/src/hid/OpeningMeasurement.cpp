// SPDX-License-Identifier: BSD-3-Clause
#include "hid/OpeningMeasurement.h"

#include <algorithm>
#include <array>
#include <span>

namespace perilymph::device {

namespace {

constexpr std::int64_t maxTime = 100'000'000;  // [ns]
constexpr int enoughReports = 64;
constexpr std::size_t fewestIntervals = 6;
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

/// Median over pairs of reports, half of all apart, of the time between two neighbors [s]: a report that a busy
/// machine reads late, even the first or the last, changes few of the pairs.
///
/// @param arrivals  [ns], in order, at least 2; overwritten.
double periodOf(std::span<std::int64_t> arrivals) noexcept
{
  const std::size_t apart = arrivals.size() / 2;
  const std::span pairs = arrivals.first(arrivals.size() - apart);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = arrivals[i + apart] - arrivals[i];
  const auto median = pairs.subspan(pairs.size() / 2).begin();
  std::nth_element(pairs.begin(), median, pairs.end());
  return static_cast<double>(*median) * 1e-9 / static_cast<double>(apart);
}

}  // namespace

OpeningMeasurement measureOnOpening(Transport& reading, Transport* writing,
                                    const DeviceTraits& profile, ForceWriter& writer, Clock clock)
{
  OpeningMeasurement heard;
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
  std::array<std::int64_t, enoughReports + 1> arrivals;
  std::size_t count = 0;
  for (int i = 0; i < maxReads && count < arrivals.size(); ++i) {
    if (clock() - began >= maxTime) break;
    const Transfer transfer = reading.read(report, Duration::fromSi(0.02));
    if (transfer == Transfer::gone) break;
    if (transfer == Transfer::done) arrivals[count++] = clock();
  }
  if (count <= fewestIntervals) return heard;
  const double period = periodOf(std::span(arrivals).first(count));
  const double ratio = period / profile.nominalPeriod;
  if (ratio <= maxRatio && ratio >= 1.0 / maxRatio) heard.period = period;
  return heard;
}

}  // namespace perilymph::device

#include "ListenFirst.h"

#include <cmath>

namespace perilymph::device {

namespace {

constexpr std::int64_t mostTime = 100'000'000;  // [ns]
constexpr int enoughReports = 64;
constexpr int fewestReports = 6;
constexpr int mostReads = 10 * enoughReports;
constexpr int writesToTime = 16;
// A period measured on a busy machine is not believed against the profile's beyond this.
constexpr double mostRatio = 2.0;

}  // namespace

FirstImpression listenFirst(Transport& reading, Transport* writing, const DeviceTraits& profile,
                            ForceWriter& writer, Clock clock)
{
  FirstImpression heard;
  const std::int64_t began = clock();
  if (writing != nullptr) {
    for (int i = 0; i < writesToTime && clock() - began < mostTime / 2; ++i)
      if (writer.send(*writing, Wrench{}) != Transfer::done) break;
    heard.writeTime = writer.figures().timeMedian;
  }
  if (profile.reporting != Reporting::periodic) return heard;

  // What waited since the handle was opened has no time of its own.
  RawReport report;
  for (int i = 0; i < 2 * ReportReader::queueLength; ++i)
    if (reading.read(report, Duration{}) != Transfer::done) break;

  std::int64_t first = 0, last = 0;
  int intervals = -1;
  for (int i = 0; i < mostReads && intervals < enoughReports; ++i) {
    if (clock() - began >= mostTime) break;
    const Transfer transfer = reading.read(report, Duration::fromSi(0.02));
    if (transfer == Transfer::gone) break;
    if (transfer != Transfer::done) continue;
    last = clock();
    if (++intervals == 0) first = last;
  }
  if (intervals < fewestReports || last <= first) return heard;
  const double period = static_cast<double>(last - first) * 1e-9 / intervals;
  const double ratio = period / profile.nominalPeriod;
  if (ratio <= mostRatio && ratio >= 1.0 / mostRatio) heard.period = period;
  return heard;
}

}  // namespace perilymph::device

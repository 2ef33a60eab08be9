// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/TapeReading.h"

#include <algorithm>

#include "codec/DeviceProfile.h"
#include "hid/ReportReader.h"
#include "perilymph/realtime/TimeHistogram.h"
#include "tape/TapeReader.h"

namespace perilymph::device {

namespace {

// Current time on the tape, for this thread.
thread_local std::int64_t timeOnTape = 0;  // [ns]
std::int64_t tapeClock() noexcept { return timeOnTape; }

RawReport reportOf(const TapeEntry& entry) noexcept
{
  RawReport report;
  report.size = std::min(entry.bytes.size(), longestReport);
  std::copy_n(entry.bytes.begin(), report.size, report.bytes.begin());
  return report;
}

/// Extends the bounding box of the positions.
void note(const DeviceSample& hand, bool isFirst, TapeReading& result) noexcept
{
  for (std::size_t i = 0; i < 3; ++i) {
    const double coordinate = hand.position_D[i];
    result.min_D[i] = isFirst ? coordinate : std::min(result.min_D[i], coordinate);
    result.max_D[i] = isFirst ? coordinate : std::max(result.max_D[i], coordinate);
  }
  result.buttons |= hand.buttons;
}

}  // namespace

TapeReading readTape(const ReportTape& tape, DeviceCodec& codec, double period)
{
  TapeReading result;
  ReportReader reader(codec, period, tapeClock);
  realtime::TimeHistogram intervals, writes;
  std::int64_t first = 0, last = 0;
  std::uint64_t fresh = 0;
  for (const TapeEntry& entry : tape.entries) {
    // Never 0, which means before any report.
    timeOnTape = entry.time + 1;
    if (entry.event == TapeEvent::refused) ++result.writing.refused;
    if (entry.event == TapeEvent::gone) reader.reset();
    if (entry.event == TapeEvent::written) {
      ++result.writing.accepted;
      writes.add(entry.took);
    }
    if (entry.event != TapeEvent::input || !reader.accept(reportOf(entry))) continue;
    if (fresh > 0) intervals.add(entry.time - last);
    if (fresh == 0) first = entry.time;
    last = entry.time;
    note(reader.newest(), ++fresh == 1, result);
  }
  result.reading = reader.figures();
  if (last > first)
    result.reading.rate =
        static_cast<double>(fresh - 1) / (static_cast<double>(last - first) * 1e-9);
  result.reading.intervalMedian = intervals.quantile(0.5);
  result.reading.intervalP99 = intervals.quantile(0.99);
  result.reading.intervalMax = intervals.longest();
  result.writing.timeMedian = writes.quantile(0.5);
  result.writing.timeP99 = writes.quantile(0.99);
  result.writing.timeMax = writes.longest();
  if (!tape.entries.empty())
    result.duration =
        static_cast<double>(tape.entries.back().time - tape.entries.front().time) * 1e-9;
  return result;
}

Result<TapeReading> readTape(const std::filesystem::path& file)
{
  const auto tape = loadTape(file);
  if (!tape) return tape.error();
  const auto descriptor = ReportDescriptor::parse(tape->descriptor);
  if (!descriptor) return Error{"%1: %2", file, descriptor.error().message};
  const ProfileCatalog catalog = allProfiles();
  const DeviceProfile* const profile =
      matchingProfile(catalog.profiles, tape->identity, *descriptor);
  if (profile == nullptr)
    return Error{
        "No profile fits the device on %1 (%2, %3). For a device of a known kind add one "
        "(plugins/README.md).",
        file, tape->name, identityText(tape->identity)};
  auto codec = makeCodec(*profile, *descriptor);
  if (!codec) return codec.error();
  TapeReading reading = readTape(*tape, **codec, profile->traits.nominalPeriod);
  reading.name = tape->name;
  reading.identity = tape->identity;
  reading.profile = profile->name;
  reading.lost = tape->lost;
  return reading;
}

}  // namespace perilymph::device

// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ForceWriter.h"

#include <algorithm>
#include <cmath>

#include "hid/Intervals.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/RealTimePriority.h"

namespace perilymph::device {

namespace {

constexpr std::int64_t longestSleep = 10'000'000;  // [ns]

}  // namespace

ForceWriter::ForceWriter(DeviceChannels& channels, DeviceCodec& codec, const DeviceTraits& traits,
                         Clock clock)
    : channels_(channels),
      codec_(codec),
      traits_(traits),
      clock_(clock),
      patience_(nanoseconds(std::clamp(3.0 * traits.nominalPeriod, 10e-3, 30e-3))),
      period_(nanoseconds(std::clamp(traits.nominalPeriod, 1e-4, 10e-3)))
{
}

Transfer ForceWriter::send(Transport& transport, const Wrench& wrench_D) noexcept
{
  const std::int64_t began = clock_();
  // A force that was refused before is still pending.
  if (channels_.busySince == 0) channels_.busySince = began;
  codec_.encode(wrench_D, reports_);
  const std::size_t count = std::min(reports_.count, ReportList::capacity);
  for (std::size_t i = 0; i < count; ++i) {
    const Transfer transfer = transport.write(reports_.reports[i]);
    if (transfer == Transfer::done) continue;
    ++figures_.refused;
    return transfer;
  }
  channels_.busySince = 0;
  ++figures_.accepted;
  times_.add(clock_() - began);
  return Transfer::done;
}

const WritingFigures& ForceWriter::figures() noexcept
{
  figures_.timeMedian = times_.quantile(0.5);
  figures_.timeP99 = times_.quantile(0.99);
  figures_.timeMax = times_.longest();
  return figures_;
}

const WritingFigures& ForceWriter::latestFigures() noexcept
{
  shown_.refresh();
  return shown_.latest();
}

void ForceWriter::run() noexcept
{
  // Without the priority a force may be late; the figures report it.
  figures_.hasRealTimePriority = realtime::requestRealTimePriority(realtime::Rank::write) ==
                                 realtime::RealTimePriority::granted;
  Transport* transport = nullptr;
  bool isUsable = false;
  while (!channels_.isStopping) {
    const bool isPaced = traits_.reporting == Reporting::polled;
    // Sleep by the machine's clock, even if a test's clock stands still.
    const std::int64_t sleep = isPaced ? period_ : longestSleep;
    channels_.writerBell.waitUntil(realtime::monotonicNanoseconds() + sleep);
    if (channels_.isStopping) break;

    if (channels_.isGone && transport != nullptr) {
      channels_.busySince = 0;
      channels_.writing.giveBack(transport);
      channels_.supervisorBell.ring();
      transport = nullptr;
    }
    if (transport == nullptr) transport = channels_.writing.take();
    if (transport == nullptr) continue;
    isUsable = true;
    if (isPaced) poll(*transport);
    serve(*transport);
  }

  isUsable = isUsable && transport != nullptr && !channels_.isGone;
  if (isUsable && traits_.rendersForce) send(*transport, Wrench{});
  if (isUsable) codec_.end(*transport);
  channels_.busySince = 0;
  delete transport;
}

void ForceWriter::serve(Transport& transport) noexcept
{
  const std::int64_t now = clock_();
  const bool isNew = channels_.wrenches.refresh();
  if (isNew) lastNew_ = now;
  if (isNew) isSilent_ = false;

  // If no new forces arrive, the last one must not persist.
  const bool hasFallenSilent = !isNew && !isSilent_ && now - lastNew_ > patience_;
  if (hasFallenSilent) isSilent_ = true;
  const bool isOwing = channels_.busySince != 0 || channels_.isBlocked;
  if (!isNew && !hasFallenSilent && !isOwing) return;

  const bool isZero = hasFallenSilent || isSilent_ || channels_.isBlocked;
  const Wrench wrench_D = isZero ? Wrench{} : channels_.wrenches.latest();
  const Transfer transfer = send(transport, wrench_D);
  if (transfer == Transfer::gone) lose();
  // No longer blocked once it has accepted a force of zero.
  if (transfer == Transfer::done && isZero) channels_.isBlocked = false;

  if (now - published_ < statisticsInterval) return;
  published_ = now;
  shown_.publish(figures());
}

void ForceWriter::poll(Transport& transport) noexcept
{
  RawReport& report = channels_.polled.draft();
  report.bytes[0] = traits_.polledReport;
  report.size = longestReport;
  const Transfer transfer = transport.getFeature(report);
  if (transfer == Transfer::done) channels_.polled.publishDraft();
  if (transfer == Transfer::gone) lose();
}

void ForceWriter::lose() noexcept
{
  channels_.isGone = true;
  channels_.writerBell.ring();  // to give the handle back at once
}

}  // namespace perilymph::device

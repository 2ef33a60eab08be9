// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ReportReader.h"

namespace perilymph::device {

namespace {

// Twice the kernel's queue: a device that sends while it is drained cannot block the loop.
constexpr int maxReportsAtOnce = 128;
constexpr std::int64_t second = 1'000'000'000;  // [ns]

}  // namespace

ReportReader::ReportReader(DeviceCodec& codec, double period, Clock clock) noexcept
    : codec_(&codec), clock_(clock), count_(period)
{
}

bool ReportReader::accept(const RawReport& report) noexcept
{
  // Decode into a copy, so that a rejected report has no effect.
  DeviceSample told = sample_;
  const auto counter = codec_->decode(report, told);
  if (!counter) {
    ++figures_.foreign;
    return false;
  }
  const std::int64_t now = clock_();
  const ReportCount::Verdict verdict = count_.classify(*counter, now, emptyAt_);
  figures_.lost += count_.lost();
  if (verdict == ReportCount::Verdict::duplicate) ++figures_.duplicates;
  if (verdict == ReportCount::Verdict::old) ++figures_.old;
  if (verdict != ReportCount::Verdict::fresh) return false;

  told.sequence = sample_.sequence + 1;
  told.isValid = 1;
  sample_ = told;
  note(now);
  return true;
}

void ReportReader::note(std::int64_t now) noexcept
{
  ++figures_.fresh;
  ++freshInSecond_;
  if (lastFresh_ != 0) intervals_.add(now - lastFresh_);
  lastFresh_ = now;
  if (firstEver_ == 0) firstEver_ = now;
  if (lastEver_ != 0) allIntervals_.add(now - lastEver_);
  lastEver_ = now;
  if (secondBegan_ == 0) {
    secondBegan_ = now;
    freshInSecond_ = 0;
  }
  const std::int64_t passed = now - secondBegan_;
  if (passed < second) return;
  figures_.rate = static_cast<double>(freshInSecond_) / (static_cast<double>(passed) * 1e-9);
  figures_.intervalMedian = intervals_.quantile(0.5);
  figures_.intervalP99 = intervals_.quantile(0.99);
  figures_.intervalMax = intervals_.longest();
  intervals_.clear();
  freshInSecond_ = 0;
  secondBegan_ = now;
}

ReadingFigures ReportReader::figures() const noexcept
{
  ReadingFigures figures = figures_;
  const auto passed = static_cast<double>(lastEver_ - firstEver_) * 1e-9;
  if (passed > 0.0) figures.overall.rate = static_cast<double>(allIntervals_.count()) / passed;
  // a quantile takes 7 us on a slow machine: one at a time
  if ((asked_++ & 1) == 0)
    median_ = allIntervals_.quantile(0.5);
  else
    p99_ = allIntervals_.quantile(0.99);
  figures.overall.intervalMedian = median_;
  figures.overall.intervalP99 = p99_;
  figures.overall.intervalMax = allIntervals_.longest();
  return figures;
}

Transfer ReportReader::drain(Transport& transport) noexcept
{
  const DeviceSample before = sample_;
  const std::uint64_t freshBefore = figures_.fresh;
  const std::int64_t lastFreshBefore = lastFresh_;
  bool isGone = false;
  int taken = 0;
  if (isHolding_) {
    accept(report_);
    ++taken;
  }
  isHolding_ = false;
  while (taken < maxReportsAtOnce) {
    const Transfer transfer = transport.read(report_, Duration{});
    isGone = transfer == Transfer::gone;
    if (transfer == Transfer::nothing) emptyAt_ = clock_();
    if (transfer != Transfer::done) break;
    ++taken;
    accept(report_);
  }

  const std::uint64_t fresh = figures_.fresh - freshBefore;
  if (taken >= queueLength && fresh > 0) {
    // The queue had overflowed, so reports after its last one are missing and its age is unknown
    // until the next report.
    figures_.old += fresh;
    figures_.fresh = freshBefore;
    sample_ = before;
    lastFresh_ = lastFreshBefore;
  }
  if (isGone) return Transfer::gone;
  return sample_.sequence != before.sequence ? Transfer::done : Transfer::nothing;
}

Transfer ReportReader::await(Transport& transport, Duration timeout) noexcept
{
  if (isHolding_) return Transfer::done;
  const Transfer transfer = transport.read(report_, timeout);
  isHolding_ = transfer == Transfer::done;
  return transfer;
}

void ReportReader::reset() noexcept
{
  count_.reset();
  lastFresh_ = 0;
  emptyAt_ = ReportCount::never;
  isHolding_ = false;
}

}  // namespace perilymph::device

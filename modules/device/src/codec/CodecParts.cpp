// SPDX-License-Identifier: BSD-3-Clause
#include "codec/CodecParts.h"

namespace perilymph::device {

namespace {

RawReport raw(const FixedReport& fixed) noexcept
{
  RawReport report;
  report.size = std::min(fixed.bytes.size(), longestReport);
  std::copy_n(fixed.bytes.begin(), report.size, report.bytes.begin());
  return report;
}

Transfer send(Transport& transport, ReportKind kind, const RawReport& report) noexcept
{
  return kind == ReportKind::feature ? transport.setFeature(report) : transport.write(report);
}

}  // namespace

Result<void> sendOne(Transport& transport, ReportKind kind, const RawReport& report,
                     const std::string& device, const std::string& what)
{
  switch (send(transport, kind, report)) {
    case Transfer::done:
      return {};
    case Transfer::gone:
      return Error{"The %1 went away while it was told %2. Check its cable and open it again.",
                   device, what};
    default:
      return Error{
          "The %1 did not take %2 (report %3, %4 bytes). Unplug it, plug it in again, and close "
          "other programs that use it.",
          device, what, report.bytes[0], report.size};
  }
}

Result<void> sendAll(Transport& transport, std::span<const FixedReport> reports,
                     const std::string& device)
{
  for (const FixedReport& fixed : reports) {
    auto sent = sendOne(transport, fixed.kind, raw(fixed), device, "a report of its profile");
    if (!sent) return sent;
  }
  return {};
}

void sendQuietly(Transport& transport, std::span<const FixedReport> reports) noexcept
{
  for (const FixedReport& fixed : reports) send(transport, fixed.kind, raw(fixed));
}

}  // namespace perilymph::device

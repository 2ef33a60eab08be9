// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Common parts of codecs: rotation into D, force limit, constant reports.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "codec/ReportBits.h"
#include "hid/Transport.h"

namespace perilymph::device {

using Vector3 = std::array<double, 3>;

/// M v.
inline Vector3 rotated(const std::array<double, 9>& m, const Vector3& v) noexcept
{
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}

/// M^T v: the inverse rotation.
inline Vector3 rotatedBack(const std::array<double, 9>& m, const Vector3& v) noexcept
{
  return {m[0] * v[0] + m[3] * v[1] + m[6] * v[2], m[1] * v[0] + m[4] * v[1] + m[7] * v[2],
          m[2] * v[0] + m[5] * v[1] + m[8] * v[2]};
}

/// The force in the device's own axes, limited to its maximum; zero if not finite. The codec is the
/// last to handle a force, so it validates its input.
inline Vector3 limitedForce_B(const DeviceProfile& profile, const Vector3& force_D) noexcept
{
  Vector3 force_B = rotatedBack(profile.mount_DB, force_D);
  for (double& component : force_B) component *= profile.forceScale;
  const double limit = profile.traits.maxForce;
  const double length =
      std::sqrt(force_B[0] * force_B[0] + force_B[1] * force_B[1] + force_B[2] * force_B[2]);
  if (!std::isfinite(length)) return {};
  if (length > limit)
    for (double& component : force_B) component *= limit / length;
  return force_B;
}

/// Nearest integer, halves rounded up; 0 for NaN. For values that fit into a slot.
inline std::int64_t nearest(double value) noexcept
{
  if (std::isnan(value)) return 0;
  constexpr double limit = 4e9;
  return static_cast<std::int64_t>(std::floor(std::clamp(value, -limit, limit) + 0.5));
}

/// An empty report with this number and length (without the number).
inline void clear(RawReport& report, std::uint8_t number, std::size_t bytes) noexcept
{
  report.size = std::min(bytes + 1, longestReport);
  std::fill_n(report.bytes.begin(), report.size, std::uint8_t{0});
  report.bytes[0] = number;
}

/// The report without its number.
inline std::span<const std::uint8_t> body(const RawReport& report) noexcept
{
  const auto whole = report.view().first(std::min(report.size, longestReport));
  return whole.empty() ? whole : whole.subspan(1);
}

inline std::span<std::uint8_t> body(RawReport& report) noexcept
{
  return std::span(report.bytes).first(std::min(report.size, longestReport)).subspan(1);
}

/// A copy of the report as a constant report.
inline FixedReport fixed(const RawReport& report)
{
  const auto bytes = report.view();
  return {ReportKind::output, {bytes.begin(), bytes.end()}};
}

/// Sends several output or feature reports; the error names the one that was refused.
Result<void> sendAll(Transport& transport, std::span<const FixedReport> reports,
                     const std::string& device);
/// Sends one report. @param what  For messages: "the device gain".
Result<void> sendOne(Transport& transport, ReportKind kind, const RawReport& report,
                     const std::string& device, const std::string& what);
/// The same without error reporting.
void sendQuietly(Transport& transport, std::span<const FixedReport> reports) noexcept;

}  // namespace perilymph::device

// SPDX-License-Identifier: BSD-3-Clause
#include "codec/AxesReader.h"

#include "perilymph/foundation/Math.h"

namespace perilymph::device {

namespace {

using Quaternion = std::array<double, 4>;

constexpr std::uint16_t buttonPage = 0x09;

/// The rotation about a vector by its length [rad].
Quaternion rotationBy(const Vector3& turn) noexcept
{
  const double angle = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  if (!(angle > 0.0)) return {1.0, 0.0, 0.0, 0.0};
  const SineCosine half = sineCosine(0.5 * angle);
  const double scale = half.sine / angle;
  return {half.cosine, scale * turn[0], scale * turn[1], scale * turn[2]};
}

/// First b, then a; normalized.
Quaternion product(const Quaternion& a, const Quaternion& b) noexcept
{
  Quaternion q{a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
               a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
               a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
               a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
  return q;
}

std::string_view nameOf(std::size_t axis)
{
  constexpr std::array<std::string_view, 6> names{"x", "y", "z", "turn_x", "turn_y", "turn_z"};
  return names.at(axis);
}

}  // namespace

Result<AxesReader> AxesReader::make(const DeviceProfile& profile,
                                    const ReportDescriptor& descriptor)
{
  AxesReader reader;
  reader.layout_ = profile.axes;
  reader.mount_DB_ = profile.mount_DB;
  reader.period_ = profile.traits.nominalPeriod;
  reader.bound_ = profile.traits.workspaceRadius;
  const auto use = [&](std::uint8_t report) {
    reader.reportBytes_[report] =
        static_cast<std::uint16_t>(descriptor.reportBytes(ReportKind::input, report));
  };

  for (std::size_t i = 0; i < 6; ++i) {
    const AxisSource& source = profile.axes.axes[i];
    if (source.usage.page == 0) continue;
    const auto slot = descriptor.find(ReportKind::input, source.usage);
    const std::string wanted = "The profile " + profile.file + " moves '" + std::string(nameOf(i)) +
                               "' by the axis with usage " + std::to_string(source.usage.id) +
                               " of page " + std::to_string(source.usage.page);
    if (!slot)
      return Error{"%1, but the device has no such axis. Choose another axis in [axes].", wanted};
    if (slot->high <= slot->low && profile.axes.fullCounts == 0)
      return Error{
          "%1, but the device says that it only knows the value %2. Give full_counts in [axes].",
          wanted, slot->low};
    Axis& axis = reader.axes_[i];
    axis.slot = *slot;
    axis.sign = source.sign;
    const auto low = static_cast<double>(slot->low);
    const auto high = static_cast<double>(slot->high);
    axis.middle = 0.5 * (low + high);
    axis.half = profile.axes.fullCounts > 0 ? static_cast<double>(profile.axes.fullCounts)
                                            : 0.5 * (high - low);
    use(slot->report);
  }

  for (std::uint32_t button = 1; button <= maxButtons; ++button) {
    const auto slot =
        descriptor.find(ReportKind::input, {buttonPage, static_cast<std::uint16_t>(button)});
    if (!slot) continue;
    // The grasp button comes first; buttons before it are shifted by one.
    const std::uint32_t grasp = profile.graspButton;
    const std::uint32_t bit = button == grasp ? 0u : button < grasp ? button : button - 1u;
    reader.buttonSlots_[static_cast<std::size_t>(reader.buttons_++)] = {*slot, bit};
    use(slot->report);
  }
  return reader;
}

double AxesReader::deflection(const Axis& axis, std::span<const std::uint8_t> bytes) const noexcept
{
  const double counts = static_cast<double>(numberAt(bytes, axis.slot)) - axis.middle;
  const double fraction = std::clamp(counts / axis.half, -1.0, 1.0);
  const double beyond = std::fabs(fraction) - layout_.deadZone;
  if (beyond <= 0.0) return 0.0;
  return axis.sign * (fraction < 0.0 ? -beyond : beyond) / (1.0 - layout_.deadZone);
}

void AxesReader::place() noexcept
{
  const auto& d = deflections_;
  position_D_ =
      rotated(mount_DB_, {d[0] * layout_.travel, d[1] * layout_.travel, d[2] * layout_.travel});
  rotation_D_ = rotationBy(
      rotated(mount_DB_, {d[3] * layout_.turn, d[4] * layout_.turn, d[5] * layout_.turn}));
}

void AxesReader::drift(std::uint8_t report) noexcept
{
  // Only the axes in this report are advanced: others have reports of their own.
  std::array<double, 6> d{};
  for (std::size_t i = 0; i < 6; ++i)
    if (axes_[i].half > 0.0 && axes_[i].slot.report == report) d[i] = deflections_[i];
  const double step = layout_.speed * period_;
  const double turnStep = layout_.turnSpeed * period_;
  const Vector3 shift_D = rotated(mount_DB_, {d[0] * step, d[1] * step, d[2] * step});
  for (std::size_t i = 0; i < 3; ++i) {
    position_D_[i] += shift_D[i];
    if (bound_ > 0.0) position_D_[i] = std::clamp(position_D_[i], -bound_, bound_);
  }
  const Vector3 turn_D = rotated(mount_DB_, {d[3] * turnStep, d[4] * turnStep, d[5] * turnStep});
  rotation_D_ = product(rotationBy(turn_D), rotation_D_);
}

std::optional<std::uint64_t> AxesReader::decode(const RawReport& report,
                                                DeviceSample& sample) noexcept
{
  if (report.size == 0) return std::nullopt;
  const std::uint8_t number = report.bytes[0];
  const auto bytes = body(report);
  if (reportBytes_[number] == 0 || bytes.size() < reportBytes_[number]) return std::nullopt;

  bool hasAxes = false;
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(axes_[i].half > 0.0) || axes_[i].slot.report != number) continue;
    deflections_[i] = deflection(axes_[i], bytes);
    hasAxes = true;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(buttons_); ++i) {
    if (buttonSlots_[i].slot.report != number) continue;
    const std::uint32_t bit = 1u << buttonSlots_[i].bit;
    const bool isPressed = numberAt(bytes, buttonSlots_[i].slot) != 0;
    pressed_ = isPressed ? pressed_ | bit : pressed_ & ~bit;
  }
  if (hasAxes && layout_.motion == AxesLayout::Motion::place) place();
  if (hasAxes && layout_.motion == AxesLayout::Motion::rate) drift(number);
  sample.position_D = position_D_;
  sample.rotation_D = rotation_D_;
  sample.buttons = pressed_;
  return 0u;
}

}  // namespace perilymph::device

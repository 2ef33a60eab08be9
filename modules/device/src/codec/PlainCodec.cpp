// SPDX-License-Identifier: BSD-3-Clause
#include "codec/PlainCodec.h"

namespace perilymph::device {

namespace {

ReportSlot slotOf(const VectorLayout& layout, std::size_t axis) noexcept
{
  ReportSlot slot;
  slot.report = layout.report;
  slot.bitOffset = layout.firstBits[axis];
  slot.bits = layout.bits;
  slot.isSigned = true;
  return slot;
}

/// The device's buttons with the grasp button first.
std::uint32_t buttonBits(std::uint32_t pressed, std::uint32_t graspButton) noexcept
{
  const std::uint32_t grasp = (pressed >> (graspButton - 1)) & 1u;
  const std::uint32_t below = pressed & ((1u << (graspButton - 1)) - 1u);
  const std::uint32_t above = graspButton == 32 ? 0u : pressed >> graspButton << graspButton;
  return grasp | (below << 1) | above;
}

}  // namespace

Vector3 PlainCodec::position_B(const Vector3& counts) noexcept
{
  const PlainLayout& plain = profile_.plain;
  if (profile_.kind == CodecKind::vector)
    return {counts[0] * plain.inputQuantum[0], counts[1] * plain.inputQuantum[1],
            counts[2] * plain.inputQuantum[2]};
  const Vector3 angles = bodyAngles(plain.linkage, counts);
  for (std::size_t i = 0; i < 3; ++i) angles_[i] = angles[i];
  return handlePosition_B(plain.linkage, angles);
}

std::optional<std::uint64_t> PlainCodec::decode(const RawReport& report,
                                                DeviceSample& sample) noexcept
{
  const PlainLayout& plain = profile_.plain;
  const auto bytes = body(report);
  if (report.size == 0 || report.bytes[0] != plain.input.report) return std::nullopt;
  if (bytes.size() < plain.input.bytes) return std::nullopt;

  Vector3 counts{};
  for (std::size_t i = 0; i < 3; ++i)
    counts[i] = static_cast<double>(numberAt(bytes, slotOf(plain.input, i)));
  const Vector3 position_D = rotated(profile_.mount_DB, position_B(counts));
  for (const double coordinate : position_D)
    if (!std::isfinite(coordinate)) return std::nullopt;

  sample.position_D = position_D;
  if (plain.buttons)
    sample.buttons = buttonBits(static_cast<std::uint32_t>(numberAt(bytes, *plain.buttons)),
                                profile_.graspButton);
  if (plain.calibration && numberAt(bytes, *plain.calibration) != 0) asksForCounts_ = true;
  return plain.counter ? static_cast<std::uint64_t>(numberAt(bytes, *plain.counter)) : 0u;
}

void PlainCodec::putOutputs(const Vector3& force_B, RawReport& report) const noexcept
{
  const PlainLayout& plain = profile_.plain;
  Vector3 outputs = force_B;
  if (profile_.kind == CodecKind::encoders) {
    const Vector3 angles{angles_[0], angles_[1], angles_[2]};
    outputs = motorCurrents(plain.linkage, bodyTorques(plain.linkage, angles, force_B));
  }
  for (std::size_t i = 0; i < 3; ++i)
    putNumber(body(report), slotOf(plain.output, i), nearest(outputs[i] / plain.outputQuantum[i]));
}

/// The force along the axes of D that the device has.
Vector3 PlainCodec::alongAxes(const Vector3& force_D) const noexcept
{
  Vector3 along{};
  for (std::size_t i = 0; i < 3; ++i)
    if ((profile_.traits.actuatedAxes >> i & 1u) != 0) along[i] = force_D[i];
  return along;
}

void PlainCodec::putCounts(RawReport& report) const noexcept
{
  const PlainLayout& plain = profile_.plain;
  putNumber(body(report), *plain.command, plain.calibrateCommand);
  for (std::size_t i = 0; i < 3; ++i)
    putNumber(body(report), plain.countsToSet[i], nearest(plain.linkage.restCounts[i]));
}

void PlainCodec::encode(const Wrench& wrench_D, ReportList& reports) noexcept
{
  reports.count = 0;
  if (!profile_.traits.rendersForce) return;
  RawReport& report = reports.reports[0];
  clear(report, profile_.plain.output.report, profile_.plain.output.bytes);
  // A report that sets the counts renders no force: its current fields stay zero.
  if (profile_.plain.command && asksForCounts_.exchange(false))
    putCounts(report);
  else
    putOutputs(limitedForce_B(profile_, alongAxes(wrench_D.force_D)), report);
  reports.count = 1;
}

Result<void> PlainCodec::begin(Transport& transport)
{
  auto sent = sendAll(transport, profile_.onOpen, profile_.name);
  if (!sent || !profile_.traits.rendersForce) return sent;
  ReportList zero;
  encode({}, zero);
  return sendOne(transport, ReportKind::output, zero.reports[0], profile_.name, "a force of zero");
}

void PlainCodec::end(Transport& transport) noexcept
{
  if (profile_.traits.rendersForce) {
    RawReport zero;
    clear(zero, profile_.plain.output.report, profile_.plain.output.bytes);
    // Twice: the device may be busy with the previous force at the first one.
    for (int i = 0; i < 2; ++i)
      if (transport.write(zero) == Transfer::gone) return;
  }
  sendQuietly(transport, profile_.onClose);
}

ShutdownReports PlainCodec::shutdownReports() const
{
  if (!profile_.traits.rendersForce) return {};
  RawReport zero;
  clear(zero, profile_.plain.output.report, profile_.plain.output.bytes);
  const FixedReport noForce = fixed(zero);
  // Twice, as end() does.
  ShutdownReports shutdownReports{{noForce}, {noForce}};
  shutdownReports.switchOff.insert(shutdownReports.switchOff.end(), profile_.onClose.begin(),
                                   profile_.onClose.end());
  return shutdownReports;
}

}  // namespace perilymph::device

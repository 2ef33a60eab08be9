// SPDX-License-Identifier: BSD-3-Clause
#include "codec/PidCodec.h"

#include "perilymph/foundation/Math.h"

namespace perilymph::device {

namespace {

using Effects = PidLayout::Effects;
using Control = PidReports::Control;

// A device may need time to allocate an effect; each poll takes one USB transfer.
constexpr int maxQuestions = 20;

}  // namespace

bool PidCodec::isMoved(std::size_t axis) const noexcept
{
  return profile_.axes.axes[axis].usage.page != 0;
}

void PidCodec::encode(const Wrench& wrench_D, ReportList& reports) noexcept
{
  reports.count = 0;
  if (effectCount_ == 0) return;
  const Vector3 force_B = limitedForce_B(profile_, wrench_D.force_D);
  Vector3 magnitude{};
  for (std::size_t i = 0; i < 3; ++i)
    if (isMoved(i))
      magnitude[i] = force_B[i] / profile_.traits.maxForce * profile_.pid.signs[i] *
                     profile_.axes.axes[i].sign;
  if (profile_.pid.effects == Effects::direction) {
    encodeDirection(magnitude, reports);
    return;
  }
  for (std::size_t i = 0; i < effectCount_; ++i)
    reports_.constantForce(reports.reports[reports.count++], effects_[i].block,
                           magnitude[effects_[i].axis]);
}

void PidCodec::encodeDirection(const Vector3& magnitude, ReportList& reports) const noexcept
{
  // The direction that the force comes from, clockwise from north, which is the negative second
  // axis. The axes are the device's own, in the order of their usages: X before Y before Z.
  std::array<std::size_t, 2> axes{};
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3 && found < 2; ++i)
    if (isMoved(i)) axes[found++] = i;
  const auto usage = [&](std::size_t which) { return profile_.axes.axes[axes[which]].usage.id; };
  if (usage(1) < usage(0)) std::swap(axes[0], axes[1]);

  const double east = magnitude[axes[0]];
  const double south = magnitude[axes[1]];
  const double fraction = std::sqrt(east * east + south * south);
  const double direction = arcTangent(-east, south);
  reports_.setEffect(reports.reports[0], effects_[0].block, 0, direction);
  reports_.constantForce(reports.reports[1], effects_[0].block, fraction);
  reports.count = 2;
}

Result<void> PidCodec::tell(Transport& transport, std::optional<RawReport> report, const char* what)
{
  if (!report) return {};  // not listed by the device: nothing to send
  return sendOne(transport, ReportKind::output, *report, profile_.name, what);
}

Result<void> PidCodec::addEffect(Transport& transport, std::size_t axis)
{
  auto sent = sendOne(transport, ReportKind::feature, reports_.createEffect(), profile_.name,
                      "to make a constant force");
  if (!sent) return sent;

  PidReports::Load load = PidReports::Load::failed;
  RawReport answer;
  for (int i = 0; i < maxQuestions && load == PidReports::Load::failed; ++i) {
    answer = reports_.blockLoad();
    const Transfer transfer = transport.getFeature(answer);
    if (transfer == Transfer::gone)
      return Error{"The %1 went away while it made room for a force. Check its cable.",
                   profile_.name};
    if (transfer == Transfer::done) load = reports_.loadStatus(answer);
  }
  if (load != PidReports::Load::done)
    return Error{
        "The %1 has %2 for effect %3. Close other programs that use it, or take a profile with "
        "fewer effects (effects = \"direction\").",
        profile_.name,
        load == PidReports::Load::full ? Sentence{"no room"} : Sentence{"not answered with room"},
        effectCount_ + 1};
  const std::int64_t block = reports_.loadedBlock(answer);
  effects_[effectCount_++] = {block, axis};

  // create the effects with zero force and start them
  const PidLayout& pid = profile_.pid;
  RawReport report;
  const bool byAxis = pid.effects == Effects::axes;
  const double direction = pid.effects == Effects::polar ? pid.directions[axis] : 0.0;
  reports_.setEffect(report, block, byAxis ? 1u << axis : 0u,
                     byAxis ? std::nullopt : std::optional(direction));
  sent = tell(transport, report, "an effect");
  if (!sent) return sent;
  reports_.constantForce(report, block, 0.0);
  sent = tell(transport, report, "a force of zero");
  if (!sent) return sent;
  return tell(transport, reports_.start(block), "to start an effect");
}

Result<void> PidCodec::create(Transport& transport)
{
  auto sent = sendAll(transport, profile_.onOpen, profile_.name);
  if (sent) sent = tell(transport, reports_.control(Control::stopAll), "to stop all effects");
  if (sent && profile_.pid.resetFirst)
    sent = tell(transport, reports_.control(Control::reset), "to reset");
  if (sent) sent = tell(transport, reports_.gain(profile_.pid.gain), "its gain");
  if (profile_.pid.effects == Effects::direction) {
    if (sent) sent = addEffect(transport, 0);
  } else {
    for (std::size_t axis = 0; axis < 3 && sent; ++axis)
      if (isMoved(axis)) sent = addEffect(transport, axis);
  }
  // Last, when no old effect is left that could move the hand.
  if (sent) sent = tell(transport, reports_.control(Control::enable), "to enable its actuators");
  return sent;
}

Result<void> PidCodec::begin(Transport& transport)
{
  effectCount_ = 0;
  auto sent = create(transport);
  if (!sent) end(transport);
  return sent;
}

void PidCodec::end(Transport& transport) noexcept
{
  const auto quietly = [&](const std::optional<RawReport>& report) {
    if (report) transport.write(*report);
  };
  // First remove the force at once.
  RawReport zero;
  for (std::size_t i = 0; i < effectCount_; ++i) {
    reports_.constantForce(zero, effects_[i].block, 0.0);
    if (transport.write(zero) == Transfer::gone) break;
  }
  quietly(reports_.control(Control::stopAll));
  for (std::size_t i = 0; i < effectCount_; ++i) quietly(reports_.free(effects_[i].block));
  quietly(reports_.control(Control::disable));
  effectCount_ = 0;
  sendQuietly(transport, profile_.onClose);
}

ShutdownReports PidCodec::shutdownReports() const
{
  ShutdownReports shutdownReports;
  for (std::size_t i = 0; i < effectCount_; ++i) {
    RawReport zero;
    reports_.constantForce(zero, effects_[i].block, 0.0);
    shutdownReports.noForce.push_back(fixed(zero));
  }
  const auto add = [&](const std::optional<RawReport>& report) {
    if (report) shutdownReports.switchOff.push_back(fixed(*report));
  };
  add(reports_.control(Control::stopAll));
  for (std::size_t i = 0; i < effectCount_; ++i) add(reports_.free(effects_[i].block));
  add(reports_.control(Control::disable));
  shutdownReports.switchOff.insert(shutdownReports.switchOff.end(), profile_.onClose.begin(),
                                   profile_.onClose.end());
  return shutdownReports;
}

}  // namespace perilymph::device

// SPDX-License-Identifier: BSD-3-Clause
#include "codec/PidReports.h"

#include "perilymph/foundation/Units.h"

namespace perilymph::device {

namespace {

/// Usages of the physical interface page (PID 1.0, chapter 4).
constexpr Usage pid(std::uint16_t id) { return {0x0f, id}; }
constexpr Usage setEffectReport = pid(0x21);
constexpr Usage effectBlockIndex = pid(0x22);
constexpr Usage constantForceType = pid(0x26);
constexpr Usage durationUsage = pid(0x50);
constexpr Usage gainUsage = pid(0x52);
constexpr Usage triggerButton = pid(0x53);
constexpr Usage axesEnable = pid(0x55);
constexpr Usage directionEnableUsage = pid(0x56);
constexpr Usage directionUsage = pid(0x57);
constexpr Usage magnitudeUsage = pid(0x70);
constexpr Usage constantForceReport = pid(0x73);
constexpr Usage operationReport = pid(0x77);
constexpr Usage operationStartUsage = pid(0x79);
constexpr Usage loopCount = pid(0x7c);
constexpr Usage deviceGainUsage = pid(0x7e);
constexpr Usage blockLoadReport = pid(0x89);
constexpr Usage loadSuccess = pid(0x8c);
constexpr Usage loadFullUsage = pid(0x8d);
constexpr Usage blockFreeReport = pid(0x90);
constexpr Usage deviceControl = pid(0x96);
constexpr Usage createEffectReport = pid(0xab);
// Enable, disable, stop all, reset: in the order of PidReports::Control.
constexpr std::array<Usage, 4> controlUsages{pid(0x97), pid(0x98), pid(0x99), pid(0x9a)};
// First element of a direction (HID Usage Tables, ordinal page).
constexpr Usage firstOrdinal{0x0a, 0x01};

std::int64_t allOnes(const ReportSlot& slot) noexcept { return (std::int64_t{1} << slot.bits) - 1; }

bool holds(std::span<const std::uint8_t> bytes, const std::optional<UsageChoice>& choice) noexcept
{
  return choice && numberAt(bytes, choice->slot) == choice->value;
}

}  // namespace

Result<PidReports> PidReports::find(const DeviceProfile& profile,
                                    const ReportDescriptor& descriptor)
{
  std::string missing;
  const auto lacks = [&](const char* what) {
    if (missing.empty()) missing = what;
  };
  const auto bytesOf = [&](ReportKind kind, const ReportSlot& slot) {
    return descriptor.reportBytes(kind, slot.report);
  };
  const auto place = [&](ReportKind kind, Usage usage, Usage within, const char* what) {
    const auto slot = descriptor.find(kind, usage, within);
    if (!slot) lacks(what);
    return slot ? Place{*slot, bytesOf(kind, *slot)} : Place{};
  };
  using enum ReportKind;

  PidReports found;
  const auto create = descriptor.choice(feature, constantForceType, createEffectReport);
  if (create)
    found.createType_ = {*create, bytesOf(feature, create->slot)};
  else
    lacks("Create New Effect (feature, usage 0xAB) with constant force");
  found.loadBlock_ =
      place(feature, effectBlockIndex, blockLoadReport, "Block Load (feature, usage 0x89)");
  found.loadDone_ = descriptor.choice(feature, loadSuccess, blockLoadReport);
  found.loadFull_ = descriptor.choice(feature, loadFullUsage, blockLoadReport);

  found.effectBlock_ =
      place(output, effectBlockIndex, setEffectReport, "Set Effect (output, usage 0x21)");
  found.effectType_ = descriptor.choice(output, constantForceType, setEffectReport);
  found.duration_ = descriptor.find(output, durationUsage, setEffectReport);
  found.effectGain_ = descriptor.find(output, gainUsage, setEffectReport);
  found.trigger_ = descriptor.find(output, triggerButton, setEffectReport);
  for (std::size_t i = 0; i < 3; ++i)
    if (profile.axes.axes[i].usage.page != 0)
      found.axisEnable_[i] = descriptor.find(output, profile.axes.axes[i].usage, axesEnable);
  found.directionEnable_ = descriptor.find(output, directionEnableUsage, setEffectReport);
  found.direction_ = descriptor.find(output, firstOrdinal, directionUsage);

  found.forceBlock_ = place(output, effectBlockIndex, constantForceReport,
                            "Set Constant Force (output, usage 0x73)");
  found.magnitude_ = place(output, magnitudeUsage, constantForceReport,
                           "a magnitude (usage 0x70) in Set Constant Force")
                         .slot;
  found.operationBlock_ =
      place(output, effectBlockIndex, operationReport, "Effect Operation (output, usage 0x77)");
  if (const auto start = descriptor.choice(output, operationStartUsage, operationReport))
    found.operationStart_ = *start;
  else
    lacks("the operation start (usage 0x79) in Effect Operation");
  found.loops_ = descriptor.find(output, loopCount, operationReport);
  found.freeBlock_ =
      place(output, effectBlockIndex, blockFreeReport, "Block Free (output, usage 0x90)");
  if (const auto gain = descriptor.find(output, deviceGainUsage))
    found.deviceGain_ = Place{*gain, bytesOf(output, *gain)};
  for (std::size_t i = 0; i < controlUsages.size(); ++i)
    if (const auto said = descriptor.choice(output, controlUsages[i], deviceControl))
      found.controls_[i] = Said{*said, bytesOf(output, said->slot)};

  // requirements of the profile's representation of directions
  const bool needsDirection = profile.pid.effects != PidLayout::Effects::axes;
  if (needsDirection && (!found.direction_ || !found.directionEnable_))
    lacks("a direction (usages 0x56 and 0x57) in Set Effect; try effects = \"axes\"");
  for (std::size_t i = 0; !needsDirection && i < 3; ++i)
    if (profile.axes.axes[i].usage.page != 0 && !found.axisEnable_[i])
      lacks("an enable bit for each axis (usage 0x55) in Set Effect; try effects = \"polar\"");
  if (profile.pid.effects != PidLayout::Effects::direction && found.magnitude_.low >= 0)
    lacks("negative magnitudes in Set Constant Force; try effects = \"direction\"");
  if (found.magnitude_.high <= 0) lacks("positive magnitudes in Set Constant Force");
  if (missing.empty()) return found;
  return Error{"The %1 cannot show forces by the profile %2: its report descriptor lacks %3.",
               profile.name, profile.file, missing};
}

RawReport PidReports::blank(std::uint8_t report, std::size_t bytes) const noexcept
{
  RawReport raw;
  clear(raw, report, bytes);
  return raw;
}

std::optional<RawReport> PidReports::control(Control what) const noexcept
{
  const auto& said = controls_[static_cast<std::size_t>(what)];
  if (!said) return std::nullopt;
  RawReport report = blank(said->choice.slot.report, said->bytes);
  putNumber(body(report), said->choice.slot, said->choice.value);
  return report;
}

std::optional<RawReport> PidReports::gain(double fraction) const noexcept
{
  if (!deviceGain_) return std::nullopt;
  RawReport report = blank(deviceGain_->slot.report, deviceGain_->bytes);
  putNumber(body(report), deviceGain_->slot,
            nearest(fraction * static_cast<double>(deviceGain_->slot.high)));
  return report;
}

void PidReports::setEffect(RawReport& report, std::int64_t block, unsigned axes,
                           std::optional<double> direction) const noexcept
{
  clear(report, effectBlock_.slot.report, effectBlock_.bytes);
  const auto bytes = body(report);
  putNumber(bytes, effectBlock_.slot, block);
  if (effectType_) putNumber(bytes, effectType_->slot, effectType_->value);
  // The maximum value of the field means "infinite", and as a trigger "no button".
  if (duration_) putNumber(bytes, *duration_, allOnes(*duration_));
  if (trigger_) putNumber(bytes, *trigger_, allOnes(*trigger_));
  if (effectGain_) putNumber(bytes, *effectGain_, effectGain_->high);
  for (std::size_t i = 0; i < 3; ++i)
    if (((axes >> i) & 1u) != 0 && axisEnable_[i]) putNumber(bytes, *axisEnable_[i], 1);
  if (!direction || !direction_ || !directionEnable_) return;
  putNumber(bytes, *directionEnable_, 1);
  const double fraction = *direction / (2.0 * pi) - std::floor(*direction / (2.0 * pi));
  putNumber(bytes, *direction_, nearest(fraction * static_cast<double>(direction_->high)));
}

void PidReports::constantForce(RawReport& report, std::int64_t block,
                               double fraction) const noexcept
{
  clear(report, forceBlock_.slot.report, forceBlock_.bytes);
  putNumber(body(report), forceBlock_.slot, block);
  const auto maximum = static_cast<double>(magnitude_.high);
  const std::int64_t wanted = nearest(std::clamp(fraction, -1.0, 1.0) * maximum);
  putNumber(body(report), magnitude_, std::max(wanted, magnitude_.low));
}

RawReport PidReports::start(std::int64_t block) const noexcept
{
  RawReport report = blank(operationBlock_.slot.report, operationBlock_.bytes);
  putNumber(body(report), operationBlock_.slot, block);
  putNumber(body(report), operationStart_.slot, operationStart_.value);
  if (loops_) putNumber(body(report), *loops_, 1);
  return report;
}

RawReport PidReports::free(std::int64_t block) const noexcept
{
  RawReport report = blank(freeBlock_.slot.report, freeBlock_.bytes);
  putNumber(body(report), freeBlock_.slot, block);
  return report;
}

RawReport PidReports::createEffect() const noexcept
{
  RawReport report = blank(createType_.choice.slot.report, createType_.bytes);
  putNumber(body(report), createType_.choice.slot, createType_.choice.value);
  return report;
}

RawReport PidReports::blockLoad() const noexcept
{
  return blank(loadBlock_.slot.report, loadBlock_.bytes);
}

PidReports::Load PidReports::loadStatus(const RawReport& answer) const noexcept
{
  if (holds(body(answer), loadFull_)) return Load::full;
  // Without a status field the block's index alone decides.
  const bool isDone = loadDone_ ? holds(body(answer), loadDone_) : true;
  return isDone && loadedBlock(answer) > 0 ? Load::done : Load::failed;
}

std::int64_t PidReports::loadedBlock(const RawReport& answer) const noexcept
{
  return numberAt(body(answer), loadBlock_.slot);
}

}  // namespace perilymph::device

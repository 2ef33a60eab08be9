// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ReportDescriptor.h"

#include <algorithm>

namespace perilymph::device {

namespace {

std::uint32_t sizeOf(const UsageRange& range) noexcept
{
  return std::uint32_t{range.last} - range.first.id + 1u;
}

/// Index of a usage among the usages of a field.
std::optional<std::uint32_t> indexOf(const ReportField& field, Usage usage) noexcept
{
  std::uint32_t before = 0;
  for (const UsageRange& range : field.usages) {
    if (range.first.page == usage.page && usage.id >= range.first.id && usage.id <= range.last)
      return before + (usage.id - std::uint32_t{range.first.id});
    before += sizeOf(range);
  }
  return std::nullopt;
}

/// Whether one element represents several usages. Some devices (wheels by Moza) erroneously declare
/// such an array as a variable.
bool isArrayAtHeart(const ReportField& field) noexcept
{
  if (field.isArray || field.count != 1) return field.isArray;
  std::uint32_t usages = 0;
  for (const UsageRange& range : field.usages) usages += sizeOf(range);
  return usages > 1 && field.bitsEach > 1;
}

ReportSlot slotOf(const ReportField& field, std::uint32_t element) noexcept
{
  ReportSlot slot;
  slot.report = field.report;
  slot.bitOffset = field.bitOffset + element * field.bitsEach;
  slot.bits = field.bitsEach;
  slot.isSigned = field.logicalLow < 0;
  slot.low = field.logicalLow;
  slot.high = field.logicalHigh;
  return slot;
}

}  // namespace

std::optional<Usage> ReportDescriptor::application() const noexcept
{
  constexpr std::uint8_t applicationType = 1;
  for (const ReportCollection& collection : collections_)
    if (collection.type == applicationType) return collection.usage;
  return std::nullopt;
}

bool ReportDescriptor::hasApplication(Usage usage) const noexcept
{
  constexpr std::uint8_t applicationType = 1;
  return std::any_of(collections_.begin(), collections_.end(), [&](const auto& collection) {
    return collection.type == applicationType && collection.usage == usage;
  });
}

std::size_t ReportDescriptor::reportBytes(ReportKind kind, std::uint8_t report) const noexcept
{
  std::size_t bits = 0;
  for (const ReportField& field : fields_) {
    if (field.kind != kind || field.report != report) continue;
    bits = std::max<std::size_t>(bits, field.bitOffset + std::size_t{field.bitsEach} * field.count);
  }
  return (bits + 7) / 8;
}

bool ReportDescriptor::isInside(std::int32_t collection, Usage usage) const noexcept
{
  for (std::int32_t at = collection; at >= 0;
       at = collections_[static_cast<std::size_t>(at)].parent)
    if (collections_[static_cast<std::size_t>(at)].usage == usage) return true;
  return false;
}

std::optional<ReportSlot> ReportDescriptor::find(ReportKind kind, Usage usage,
                                                 std::optional<Usage> within) const noexcept
{
  for (const ReportField& field : fields_) {
    if (field.kind != kind || field.isArray || field.isConstant) continue;
    if (within && !isInside(field.collection, *within)) continue;
    const auto element = indexOf(field, usage);
    if (element && *element < field.count) return slotOf(field, *element);
  }
  return std::nullopt;
}

std::optional<UsageChoice> ReportDescriptor::choice(ReportKind kind, Usage usage,
                                                    Usage within) const noexcept
{
  for (const ReportField& field : fields_) {
    if (field.kind != kind || !isArrayAtHeart(field) || field.isConstant) continue;
    if (!isInside(field.collection, within)) continue;
    const auto index = indexOf(field, usage);
    if (!index) continue;
    const std::int64_t value = field.logicalLow + *index;
    if (value <= field.logicalHigh) return UsageChoice{slotOf(field, 0), value};
  }
  if (const auto slot = find(kind, usage, within)) return UsageChoice{*slot, 1};
  return std::nullopt;
}

}  // namespace perilymph::device

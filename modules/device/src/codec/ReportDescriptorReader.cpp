// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ReportDescriptorReader.h"

#include "hid/Transport.h"

namespace perilymph::device {

namespace {

// HID 1.11, 6.2.2.2 to 6.2.2.8: types and tags of items.
enum Type : std::uint8_t { mainItem = 0, globalItem = 1, localItem = 2 };
enum Main : std::uint8_t {
  inputTag = 8,
  outputTag = 9,
  collectionTag = 10,
  featureTag = 11,
  endCollectionTag = 12,
};
constexpr std::uint8_t longItemPrefix = 0xfe;
// Bits of the data of input, output and feature items.
constexpr std::uint32_t constantBit = 1u << 0;
constexpr std::uint32_t variableBit = 1u << 1;
constexpr std::uint32_t relativeBit = 1u << 2;

constexpr std::uint32_t maxReportBits = 8u * (longestReport - 1);

std::string hex(std::uint32_t value)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  do {
    text.insert(text.begin(), digits[value % 16]);
    value /= 16;
  } while (value != 0);
  return "0x" + text;
}

Error atByte(std::size_t offset, const std::string& what)
{
  return Error{
      "The report descriptor makes no sense at byte %1: %2 The device's firmware is at fault; "
      "Perilymph cannot use it.",
      offset, what};
}

}  // namespace

std::int64_t ReportDescriptorReader::Item::asSigned() const noexcept
{
  if (size == 1) return static_cast<std::int8_t>(value);
  if (size == 2) return static_cast<std::int16_t>(value);
  return static_cast<std::int32_t>(value);
}

Usage ReportDescriptorReader::LocalUsage::with(std::uint16_t page) const noexcept
{
  const auto id = static_cast<std::uint16_t>(value & 0xffffu);
  return {hasPage ? static_cast<std::uint16_t>(value >> 16) : page, id};
}

Result<ReportDescriptor> ReportDescriptorReader::read(std::span<const std::uint8_t> bytes)
{
  if (bytes.size() > ReportDescriptor::longest)
    return Error{"The report descriptor is %1 bytes long; at most %2 are read.", bytes.size(),
                 ReportDescriptor::longest};
  std::size_t at = 0;
  while (at < bytes.size()) {
    const std::uint8_t prefix = bytes[at];
    if (prefix == longItemPrefix) {  // HID defines no long items
      if (at + 2 >= bytes.size()) return atByte(at, "a long item is cut off.");
      const std::size_t length = 3u + bytes[at + 1];
      if (length > bytes.size() - at) return atByte(at, "a long item is cut off.");
      at += length;
      continue;
    }
    Item item;
    item.size = (prefix & 3u) == 3u ? 4u : prefix & 3u;
    item.type = static_cast<std::uint8_t>((prefix >> 2) & 3u);
    item.tag = static_cast<std::uint8_t>(prefix >> 4);
    if (item.size > bytes.size() - at - 1)
      return atByte(at, "the item " + hex(prefix) + " needs " + std::to_string(item.size) +
                            " bytes of data, but only " + std::to_string(bytes.size() - at - 1) +
                            " follow.");
    for (std::uint32_t i = 0; i < item.size; ++i)
      item.value |= std::uint32_t{bytes[at + 1 + i]} << (8 * i);
    if (const std::string error = readItem(item); !error.empty()) return atByte(at, error);
    at += 1 + item.size;
  }
  if (depth_ != 0)
    return atByte(at, "it ends inside " + std::to_string(depth_) + " open collections.");
  if (descriptor_.isNumbered_ && hasUnnumbered_)
    return atByte(at, "some reports have numbers and some have none.");
  return std::move(descriptor_);
}

std::string ReportDescriptorReader::readItem(const Item& item)
{
  switch (item.type) {
    case mainItem:
      return readMain(item);
    case globalItem:
      return readGlobal(item);
    case localItem:
      return readLocal(item);
    default:
      return {};  // reserved: to be ignored
  }
}

std::string ReportDescriptorReader::readMain(const Item& item)
{
  std::string error;
  switch (item.tag) {
    case inputTag:
      error = addField(ReportKind::input, item);
      break;
    case outputTag:
      error = addField(ReportKind::output, item);
      break;
    case featureTag:
      error = addField(ReportKind::feature, item);
      break;
    case collectionTag:
      error = openCollection(item);
      break;
    case endCollectionTag:
      if (depth_ == 0) return "a collection ends that was never opened.";
      collection_ = descriptor_.collections_[static_cast<std::size_t>(collection_)].parent;
      --depth_;
      break;
    default:
      break;  // reserved: to be ignored
  }
  clearLocals();
  return error;
}

std::string ReportDescriptorReader::openCollection(const Item& item)
{
  if (depth_ == deepest)
    return "collections stand more than " + std::to_string(deepest) + " deep in each other.";
  ReportCollection collection;
  if (!usages_.empty()) collection.usage = usages_.front().first.with(globals_.usagePage);
  collection.type = static_cast<std::uint8_t>(item.value & 0xffu);
  collection.parent = collection_;
  collection_ = static_cast<std::int32_t>(descriptor_.collections_.size());
  descriptor_.collections_.push_back(collection);
  ++depth_;
  return {};
}

std::string ReportDescriptorReader::addField(ReportKind kind, const Item& item)
{
  if (globals_.count == 0 || globals_.bitsEach == 0) return {};  // declares no field

  // Unused fields also extend the report: padding moves the fields after it.
  std::uint32_t& bits = bitsOf(kind, globals_.report);
  const std::uint64_t grown = bits + std::uint64_t{globals_.bitsEach} * globals_.count;
  if (grown > maxReportBits)
    return "report " + std::to_string(globals_.report) + " would have " + std::to_string(grown) +
           " bits; at most " + std::to_string(maxReportBits) + " are taken.";
  const std::uint32_t offset = bits;
  bits = static_cast<std::uint32_t>(grown);
  if (globals_.report == 0) hasUnnumbered_ = true;

  ReportField field;
  field.isConstant = (item.value & constantBit) != 0;
  if (globals_.bitsEach > 32 && !field.isConstant)
    return "a field has elements of " + std::to_string(globals_.bitsEach) +
           " bits; at most 32 are allowed.";
  field.kind = kind;
  field.report = globals_.report;
  field.bitOffset = offset;
  field.bitsEach = globals_.bitsEach;
  field.count = globals_.count;
  field.isArray = (item.value & variableBit) == 0;
  field.isRelative = (item.value & relativeBit) != 0;
  field.unitExponent = globals_.unitExponent;
  field.unit = globals_.unit;
  field.collection = collection_;

  // Many devices encode an unsigned maximum in too few bytes, such as 255 in one byte: if the
  // minimum is not negative, the maximum is taken as unsigned.
  const auto high = [](const Item& value, std::int64_t low) {
    return low < 0 ? value.asSigned() : std::int64_t{value.value};
  };
  field.logicalLow = globals_.logicalLow.asSigned();
  field.logicalHigh = high(globals_.logicalHigh, field.logicalLow);
  if (field.logicalHigh < field.logicalLow && !field.isConstant)
    return "a field's greatest value " + std::to_string(field.logicalHigh) +
           " is below its least, " + std::to_string(field.logicalLow) + ".";
  field.physicalLow = globals_.physicalLow.asSigned();
  field.physicalHigh = high(globals_.physicalHigh, field.physicalLow);
  if (field.physicalLow == 0 && field.physicalHigh == 0) {  // both absent: equal to the logical
                                                            // ones
    field.physicalLow = field.logicalLow;
    field.physicalHigh = field.logicalHigh;
  }

  for (const LocalRange& range : usages_) {
    const Usage first = range.first.with(globals_.usagePage);
    const Usage last = range.last.with(globals_.usagePage);
    if (first.page != last.page || last.id < first.id)
      return "usages run from " + hex(first.id) + " down to " + hex(last.id) + ".";
    field.usages.push_back({first, last.id});
  }
  descriptor_.fields_.push_back(std::move(field));
  return {};
}

std::string ReportDescriptorReader::readGlobal(const Item& item)
{
  switch (item.tag) {
    case 0:
      if (item.value > 0xffffu) return "usage page " + hex(item.value) + " has more than 16 bits.";
      globals_.usagePage = static_cast<std::uint16_t>(item.value);
      return {};
    case 1:
      globals_.logicalLow = item;
      return {};
    case 2:
      globals_.logicalHigh = item;
      return {};
    case 3:
      globals_.physicalLow = item;
      return {};
    case 4:
      globals_.physicalHigh = item;
      return {};
    case 5: {
      // Four bits in two's complement, although some devices use a whole signed byte.
      const auto nibble = static_cast<int>(item.value & 0xfu);
      globals_.unitExponent = nibble < 8 ? nibble : nibble - 16;
      return {};
    }
    case 6:
      globals_.unit = item.value;
      return {};
    case 7:
      globals_.bitsEach = item.value;
      return {};
    case 8:
      if (item.value == 0 || item.value > 0xffu)
        return "report number " + std::to_string(item.value) + " is not between 1 and 255.";
      globals_.report = static_cast<std::uint8_t>(item.value);
      descriptor_.isNumbered_ = true;
      return {};
    case 9:
      globals_.count = item.value;
      return {};
    case 10:
      if (stack_.size() == deepest)
        return "more than " + std::to_string(deepest) + " pushes without a pop.";
      stack_.push_back(globals_);
      return {};
    case 11:
      if (stack_.empty()) return "a pop without a push.";
      globals_ = stack_.back();
      stack_.pop_back();
      return {};
    default:
      return {};  // reserved: to be ignored
  }
}

std::string ReportDescriptorReader::readLocal(const Item& item)
{
  const LocalUsage usage{item.value, item.size == 4};
  switch (item.tag) {
    case 0:
      addUsage(usage, usage);
      return {};
    case 1:
    case 2:
      (item.tag == 1 ? usageLow_ : usageHigh_) = usage;
      if (!usageLow_ || !usageHigh_) return {};
      addUsage(*usageLow_, *usageHigh_);
      usageLow_.reset();
      usageHigh_.reset();
      return {};
    case 10:
      if (item.value > 1 || (item.value == 1) == inDelimiter_)
        return "a delimiter opens or closes out of turn.";
      inDelimiter_ = item.value == 1;
      hasAlternative_ = false;
      return {};
    default:
      return {};  // designators and strings: not used
  }
}

void ReportDescriptorReader::addUsage(LocalUsage first, LocalUsage last)
{
  // Of a delimited set of alternatives the first is preferred.
  if (inDelimiter_ && hasAlternative_) return;
  hasAlternative_ = true;
  // In a range, a page given at one end applies to both.
  if (last.hasPage && !first.hasPage) first = {(last.value & 0xffff0000u) | first.value, true};
  if (first.hasPage && !last.hasPage) last = {(first.value & 0xffff0000u) | last.value, true};
  usages_.push_back({first, last});
}

void ReportDescriptorReader::clearLocals()
{
  usages_.clear();
  usageLow_.reset();
  usageHigh_.reset();
  inDelimiter_ = false;
  hasAlternative_ = false;
}

std::uint32_t& ReportDescriptorReader::bitsOf(ReportKind kind, std::uint8_t report)
{
  return bits_[static_cast<std::size_t>(kind)][report];
}

Result<ReportDescriptor> ReportDescriptor::parse(std::span<const std::uint8_t> bytes)
{
  return ReportDescriptorReader().read(bytes);
}

}  // namespace perilymph::device

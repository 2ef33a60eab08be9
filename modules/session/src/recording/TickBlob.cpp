// SPDX-License-Identifier: BSD-3-Clause
#include "recording/TickBlob.h"

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "recording/TickFields.h"

namespace perilymph::session {

namespace {

/// The unsigned integer type with a field's bits.
template <class Field>
using Bits = std::conditional_t<sizeof(Field) == 8, std::uint64_t, std::uint32_t>;

template <class Field>
Bits<Field> bitsOf(Field field)
{
  static_assert(sizeof(Field) == 4 || sizeof(Field) == 8);
  if constexpr (std::is_enum_v<Field>)
    return static_cast<Bits<Field>>(field);
  else
    return std::bit_cast<Bits<Field>>(field);
}

template <class Field>
Field fieldOf(Bits<Field> bits)
{
  if constexpr (std::is_enum_v<Field>)
    return static_cast<Field>(bits);
  else
    return std::bit_cast<Field>(bits);
}

class Writer {
public:
  explicit Writer(std::vector<unsigned char>& bytes) : bytes_(bytes) {}

  template <class Field>
  void operator()(const Field& field)
  {
    const auto bits = bitsOf(field);
    for (std::size_t i = 0; i < sizeof bits; ++i)
      bytes_.push_back(static_cast<unsigned char>(bits >> (8 * i)));
  }

private:
  std::vector<unsigned char>& bytes_;
};

class Reader {
public:
  explicit Reader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  template <class Field>
  void operator()(Field& field)
  {
    Bits<Field> bits = 0;
    if (bytes_.size() < sizeof bits) {
      isShort_ = true;
      bytes_ = {};
      return;
    }
    for (std::size_t i = 0; i < sizeof bits; ++i) {
      const auto part = static_cast<Bits<Field>>(bytes_[i]);
      bits = static_cast<Bits<Field>>(bits | static_cast<Bits<Field>>(part << (8 * i)));
    }
    field = fieldOf<Field>(bits);
    bytes_ = bytes_.subspan(sizeof bits);
  }

  /// True if all bytes were read and none was missing.
  bool isExact() const { return !isShort_ && bytes_.empty(); }

private:
  std::span<const unsigned char> bytes_;
  bool isShort_ = false;
};

TickBlobVersion versionOf(const haptics::TickRecord& record)
{
  const bool isRuptured = (record.output.status & haptics::partitionRuptured) != 0;
  if (std::isnan(record.output.partitionForce))
    return isRuptured ? TickBlobVersion::ruptured : TickBlobVersion::first;
  if (!std::isnan(record.output.plasticWork))
    return isRuptured ? TickBlobVersion::yieldingRuptured : TickBlobVersion::yielding;
  return isRuptured ? TickBlobVersion::partitionRuptured : TickBlobVersion::partition;
}

}  // namespace

void writeTick(const haptics::TickRecord& record, std::vector<unsigned char>& bytes)
{
  bytes.clear();
  Writer write(bytes);
  write(versionOf(record));
  forEachInput(record, write);
  for (std::uint32_t i = 0; i < record.commands.count && i < haptics::maxCommandsPerTick; ++i) {
    write(record.commands.items[i].kind);
    write(record.commands.items[i].value);
  }
  forEachField(record.output, [&write](const char*, int, const auto& value) { write(value); });
}

std::optional<haptics::TickRecord> readTick(std::span<const unsigned char> bytes)
{
  haptics::TickRecord record;
  Reader read(bytes);
  TickBlobVersion versionFound{};
  read(versionFound);
  if (versionFound < TickBlobVersion::partition)
    record.output.partitionForce = std::numeric_limits<double>::quiet_NaN();
  if (versionFound >= TickBlobVersion::yielding) record.output.plasticWork = 0.0;
  forEachInput(record, read);
  if (record.commands.count > haptics::maxCommandsPerTick) return std::nullopt;
  for (std::uint32_t i = 0; i < record.commands.count; ++i) {
    read(record.commands.items[i].kind);
    read(record.commands.items[i].value);
  }
  forEachField(record.output, [&read](const char*, int, auto& value) { read(value); });
  if (!read.isExact() || versionFound != versionOf(record)) return std::nullopt;
  return record;
}

}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause
#include "recording/TickBlock.h"

#include <zstd.h>

#include <algorithm>
#include <bit>
#include <type_traits>

#include "recording/BlockTable.h"
#include "recording/TickFields.h"

namespace perilymph::session {

namespace {

using haptics::TickRecord;

/// Level of Zstandard: 3 saves 1 to 2 % more than 1 in the same time (measured); 6 takes three times as
/// long for another 1 %.
constexpr int level = 3;

template <class Field>
std::uint64_t columnBits(Field field)
{
  if constexpr (std::is_same_v<Field, double>)
    return std::bit_cast<std::uint64_t>(field);
  else
    return static_cast<std::uint64_t>(field);
}

/// Sets a field to bits from a file.
///
/// @return  False if the field is too narrow for them.
template <class Field>
bool assignBits(Field& field, std::uint64_t bits)
{
  if constexpr (std::is_same_v<Field, double>)
    field = std::bit_cast<double>(bits);
  else
    field = static_cast<Field>(bits);
  return columnBits(field) == bits;
}

constexpr std::size_t commandBytes = 16;
constexpr std::size_t maxTerms = Coefficients().size();
constexpr std::size_t fewestForFit = 64;  ///< Smaller blocks are replaced soon: not worth a fit.

/// Bytes before the columns: a coding for each, and the coefficients of all relations.
std::size_t headSize()
{
  const BlockColumns& columns = columnsOfATick();
  return columns.count + columns.relations.size() * maxTerms * sizeof(double);
}

/// Bytes of a block before compression.
std::size_t unpackedSize(std::size_t ticks, std::size_t commands)
{
  return headSize() + ticks * columnsOfATick().count * sizeof(std::uint64_t) +
         commands * commandBytes;
}

std::size_t commandsOf(const TickRecord& record)
{
  return std::min<std::size_t>(record.commands.count, haptics::maxCommandsPerTick);
}

void putNumber(unsigned char* bytes, std::uint64_t number)
{
  for (std::size_t k = 0; k < sizeof number; ++k)
    bytes[k] = static_cast<unsigned char>(number >> (8 * k));
}

std::uint64_t numberAt(const unsigned char* bytes)
{
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < sizeof number; ++k) number |= std::uint64_t{bytes[k]} << (8 * k);
  return number;
}

}  // namespace

struct BlockPacker::Content {
  struct Free {
    void operator()(ZSTD_CCtx* context) const noexcept { ZSTD_freeCCtx(context); }
  };
  std::unique_ptr<ZSTD_CCtx, Free> context{ZSTD_createCCtx()};
  BlockTable table;
  std::vector<unsigned char> plain, packed;

  void writeColumns();
};

/// Writes codings, coefficients and columns.
void BlockPacker::Content::writeColumns()
{
  const BlockColumns& columns = columnsOfATick();
  const std::size_t rows = table.rows();
  unsigned char* codings = plain.data();
  unsigned char* coefficients = codings + columns.count;
  unsigned char* bytes = codings + headSize();
  std::fill(codings, bytes, static_cast<unsigned char>(0));
  for (std::size_t column = 0; column < columns.count; ++column) {
    Coefficients terms{};
    Coding coding = Coding::secondDifferences;
    std::size_t least = table.cost(column, coding);
    const auto consider = [&](Coding other, const Coefficients& ofOther) {
      const std::size_t cost = table.cost(column, other, ofOther);
      if (cost >= least) return;
      least = cost;
      coding = other;
      terms = ofOther;
    };
    consider(Coding::firstDifferences, {});
    if (const auto* relation = columns.of(column); relation && rows >= fewestForFit)
      consider(Coding::relation, table.fit(*relation));
    codings[column] = static_cast<unsigned char>(coding);
    if (coding == Coding::relation) {
      const auto place = static_cast<std::size_t>(columns.of(column) - columns.relations.data());
      for (std::size_t i = 0; i < maxTerms; ++i)
        putNumber(coefficients + (place * maxTerms + i) * sizeof(double), columnBits(terms[i]));
    }
    table.encode(column, coding, terms, [&](std::size_t row, std::uint64_t number) {
      for (std::size_t k = 0; k < sizeof number; ++k)
        bytes[k * rows + row] = static_cast<unsigned char>(number >> (8 * k));
    });
    bytes += rows * sizeof(std::uint64_t);
  }
}

BlockPacker::BlockPacker() : content_(std::make_unique<Content>()) {}
BlockPacker::~BlockPacker() = default;
BlockPacker::BlockPacker(BlockPacker&&) noexcept = default;
BlockPacker& BlockPacker::operator=(BlockPacker&&) noexcept = default;

std::span<const unsigned char> BlockPacker::pack(std::span<const TickRecord> records)
{
  Content& content = *content_;
  const std::size_t rows = records.size();
  if (!content.context || rows == 0 || rows > blockTicks) return {};
  std::size_t commands = 0;
  content.table.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    commands += commandsOf(records[i]);
    std::uint64_t* value = content.table.begin(0) + i;
    forEachColumn(records[i], [&value, rows](const auto& field) {
      *value = columnBits(field);
      value += rows;
    });
  }
  content.plain.resize(unpackedSize(rows, commands));
  content.writeColumns();
  unsigned char* bytes = content.plain.data() + unpackedSize(rows, 0);
  for (const TickRecord& record : records)
    for (std::size_t i = 0; i < commandsOf(record); ++i, bytes += commandBytes) {
      putNumber(bytes, columnBits(record.commands.items[i].kind));
      putNumber(bytes + sizeof(std::uint64_t), columnBits(record.commands.items[i].value));
    }
  content.packed.resize(ZSTD_compressBound(content.plain.size()));
  const std::size_t size =
      ZSTD_compressCCtx(content.context.get(), content.packed.data(), content.packed.size(),
                        content.plain.data(), content.plain.size(), level);
  if (ZSTD_isError(size)) return {};
  return std::span(content.packed).first(size);
}

struct BlockUnpacker::Content {
  struct Free {
    void operator()(ZSTD_DCtx* context) const noexcept { ZSTD_freeDCtx(context); }
  };
  std::unique_ptr<ZSTD_DCtx, Free> context{ZSTD_createDCtx()};
  BlockTable table;
  std::vector<unsigned char> plain;
  std::vector<TickRecord> records;

  bool readColumns();
  bool readCommands(std::size_t size);
};

/// Reads the columns, those that follow from others last.
bool BlockUnpacker::Content::readColumns()
{
  const BlockColumns& columns = columnsOfATick();
  const unsigned char* codings = plain.data();
  const unsigned char* coefficients = codings + columns.count;
  for (const bool isLast : {false, true})
    for (std::size_t column = 0; column < columns.count; ++column) {
      const auto coding = static_cast<Coding>(codings[column]);
      const bool isRelation = coding == Coding::relation;
      if (!isRelation && coding != Coding::firstDifferences && coding != Coding::secondDifferences)
        return false;
      if (isRelation != isLast) continue;
      Coefficients terms{};
      if (isRelation) {
        const auto* relation = columns.of(column);
        if (!relation) return false;
        const auto place = static_cast<std::size_t>(relation - columns.relations.data());
        for (std::size_t i = 0; i < maxTerms; ++i)
          terms[i] = std::bit_cast<double>(
              numberAt(coefficients + (place * maxTerms + i) * sizeof(double)));
      }
      table.decode(column, coding, terms,
                   codings + headSize() + column * table.rows() * sizeof(std::uint64_t));
    }
  return true;
}

/// Reads the commands behind the columns.
///
/// @param size  Bytes of the unpacked block.
bool BlockUnpacker::Content::readCommands(std::size_t size)
{
  std::size_t commands = 0;
  for (const TickRecord& record : records) {
    if (record.commands.count > haptics::maxCommandsPerTick) return false;
    commands += record.commands.count;
  }
  if (size != unpackedSize(records.size(), commands)) return false;
  const unsigned char* bytes = plain.data() + unpackedSize(records.size(), 0);
  for (TickRecord& record : records)
    for (std::size_t i = 0; i < record.commands.count; ++i, bytes += commandBytes)
      if (!assignBits(record.commands.items[i].kind, numberAt(bytes)) ||
          !assignBits(record.commands.items[i].value, numberAt(bytes + sizeof(std::uint64_t))))
        return false;
  return true;
}

BlockUnpacker::BlockUnpacker() : content_(std::make_unique<Content>()) {}
BlockUnpacker::~BlockUnpacker() = default;
BlockUnpacker::BlockUnpacker(BlockUnpacker&&) noexcept = default;
BlockUnpacker& BlockUnpacker::operator=(BlockUnpacker&&) noexcept = default;

std::span<const TickRecord> BlockUnpacker::unpack(std::span<const unsigned char> packed,
                                                  std::uint64_t ticks)
{
  Content& content = *content_;
  if (!content.context || ticks == 0 || ticks > blockTicks) return {};
  const auto rows = static_cast<std::size_t>(ticks);
  // The size is bounded before anything is unpacked, whatever the frame states.
  content.plain.resize(unpackedSize(rows, rows * haptics::maxCommandsPerTick));
  const std::size_t size = ZSTD_decompressDCtx(content.context.get(), content.plain.data(),
                                               content.plain.size(), packed.data(), packed.size());
  if (ZSTD_isError(size) || size < unpackedSize(rows, 0)) return {};

  content.table.resize(rows);
  if (!content.readColumns()) return {};
  content.records.assign(rows, TickRecord());
  bool fits = true;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::uint64_t* value = content.table.begin(0) + i;
    forEachColumn(content.records[i], [&](auto& field) {
      fits = assignBits(field, *value) && fits;
      value += rows;
    });
  }
  const auto isOutOfOrder = [](const TickRecord& one, const TickRecord& next) {
    return one.tick >= next.tick;
  };
  const auto& records = content.records;
  if (!fits || !content.readCommands(size) ||
      std::adjacent_find(records.begin(), records.end(), isOutOfOrder) != records.end())
    return {};
  return records;
}

void addBlock(Sha256& hash, std::int64_t firstTick, std::int64_t ticks,
              std::span<const unsigned char> packed)
{
  hash.add(static_cast<std::uint64_t>(firstTick));
  hash.add(static_cast<std::uint64_t>(ticks));
  hash.add(packed.size());
  hash.add(packed);
}

}  // namespace perilymph::session

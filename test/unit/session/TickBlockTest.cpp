// SPDX-License-Identifier: BSD-3-Clause
#include "recording/TickBlock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "perilymph/test/OddRecords.h"

namespace perilymph::session {
namespace {

std::vector<haptics::TickRecord> oddRecords(std::uint64_t count)
{
  std::vector<haptics::TickRecord> records;
  for (std::uint64_t tick = 0; tick < count; ++tick) records.push_back(test::oddRecord(3 * tick));
  return records;
}

void expectTheSame(std::span<const haptics::TickRecord> read,
                   std::span<const haptics::TickRecord> written)
{
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    EXPECT_EQ(test::bitsOf(read[i]), test::bitsOf(written[i])) << i;
}

TEST(ABlock, GivesBackEveryBitOfRandomTicks)
{
  BlockPacker packer;
  BlockUnpacker unpacker;
  for (const std::uint64_t count : {1u, 2u, 3u, 20u, 1023u, 1024u, 7u}) {
    const auto written = oddRecords(count);
    const auto packed = packer.pack(written);
    ASSERT_FALSE(packed.empty()) << count;
    expectTheSame(unpacker.unpack(packed, count), written);
  }
}

TEST(ABlock, OfTooFewOrTooManyTicksIsNone)
{
  BlockPacker packer;
  EXPECT_TRUE(packer.pack({}).empty());
  EXPECT_TRUE(packer.pack(oddRecords(blockTicks + 1)).empty());
  const auto packed = packer.pack(oddRecords(20));
  BlockUnpacker unpacker;
  for (const std::uint64_t ticks : {0ull, 19ull, 21ull, 1024ull, 1025ull, ~0ull})
    EXPECT_TRUE(unpacker.unpack(packed, ticks).empty()) << ticks;
}

TEST(ABlock, OfTicksOutOfOrderIsNone)
{
  BlockPacker packer;
  BlockUnpacker unpacker;
  auto records = oddRecords(3);
  std::swap(records[1], records[2]);
  EXPECT_TRUE(unpacker.unpack(packer.pack(records), 3).empty());
  records[2] = records[1];
  EXPECT_TRUE(unpacker.unpack(packer.pack(records), 3).empty());
}

TEST(ABlock, CutAnywhereOrChangedInAnyByteIsRefusedOrOtherTicks)
{
  BlockPacker packer;
  const auto packed = packer.pack(oddRecords(5));
  const std::vector<unsigned char> whole(packed.begin(), packed.end());
  BlockUnpacker unpacker;
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(unpacker.unpack(std::span(whole).first(size), 5).empty()) << size;
  std::mt19937_64 random(7);
  for (std::size_t place = 0; place < whole.size(); ++place) {
    auto changed = whole;
    changed[place] = static_cast<unsigned char>(changed[place] ^ (1 + random() % 255));
    const auto read = unpacker.unpack(changed, 5);
    EXPECT_TRUE(read.empty() || read.size() == 5) << place;
  }
}

/// A frame that states gigabytes allocates nothing: its ticks state how long it is.
TEST(ABlock, ThatStatesMoreThanItsTicksHoldIsRefused)
{
  // magic, single segment with 8 bytes of size, 2^40 bytes, a block of 2^20 equal bytes, the last
  const std::vector<unsigned char> bomb = {0x28, 0xb5, 0x2f, 0xfd, 0xe0, 0, 0,    0, 0,
                                           0,    1,    0,    0,    0x03, 0, 0x80, 0};
  BlockUnpacker unpacker;
  EXPECT_TRUE(unpacker.unpack(bomb, 1024).empty());
}

/// Second differences of an even motion are 0, so that the size of a block is that of its constants.
TEST(ABlock, OfAnEvenMotionTakesNextToNothing)
{
  std::vector<haptics::TickRecord> records(blockTicks);
  for (std::size_t i = 0; i < blockTicks; ++i) {
    records[i].tick = i;
    records[i].sample.sequence = 5 * i;
    records[i].output.travel = 1.0 + std::ldexp(static_cast<double>(i), -30);
  }
  BlockPacker packer;
  EXPECT_LT(packer.pack(records).size(), blockTicks / 2);
}

}  // namespace
}  // namespace perilymph::session

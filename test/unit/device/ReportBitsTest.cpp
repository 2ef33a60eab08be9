// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ReportBits.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace perilymph::device {
namespace {

ReportSlot slotAt(std::uint32_t offset, std::uint32_t bits, bool isSigned)
{
  ReportSlot slot;
  slot.bitOffset = offset;
  slot.bits = bits;
  slot.isSigned = isSigned;
  return slot;
}

TEST(NumberInAReport, BeginsAtTheLowestBitOfTheLowestByte)
{
  // 0xabc in the twelve bits after the first four: nibbles d | c, b, a.
  const std::array<std::uint8_t, 2> report{0xcd, 0xab};
  EXPECT_EQ(numberAt(report, slotAt(4, 12, false)), 0xabc);
  EXPECT_EQ(numberAt(report, slotAt(0, 4, false)), 0xd);
}

TEST(NumberInAReport, IsInTwosComplementWhereTheFieldIsSigned)
{
  const std::array<std::uint8_t, 2> report{0xff, 0x80};
  EXPECT_EQ(numberAt(report, slotAt(0, 8, true)), -1);
  EXPECT_EQ(numberAt(report, slotAt(0, 8, false)), 255);
  EXPECT_EQ(numberAt(report, slotAt(8, 8, true)), -128);
}

TEST(NumberInAReport, ReadsZeroBeyondTheEnd)
{
  const std::array<std::uint8_t, 1> report{0xff};
  EXPECT_EQ(numberAt(report, slotAt(4, 8, false)), 0x0f);
  EXPECT_EQ(numberAt(report, slotAt(4000, 32, true)), 0);
}

TEST(NumberInAReport, ComesBackFromAnyPlaceAndLeavesItsNeighborsAlone)
{
  std::mt19937 random(1);
  for (std::uint32_t bits = 1; bits <= 32; ++bits) {
    for (std::uint32_t offset = 0; offset < 16; ++offset) {
      std::array<std::uint8_t, 7> before{};
      for (auto& byte : before) byte = static_cast<std::uint8_t>(random());
      for (const bool isSigned : {false, true}) {
        const std::int64_t span = std::int64_t{1} << bits;
        const std::int64_t low = isSigned ? -span / 2 : 0;
        const std::int64_t number = low + static_cast<std::int64_t>(random()) % span;
        std::array<std::uint8_t, 7> after = before;
        putNumber(after, slotAt(offset, bits, isSigned), number);
        EXPECT_EQ(numberAt(after, slotAt(offset, bits, isSigned)), number);

        // all other bits, one by one
        for (std::uint32_t bit = 0; bit < 56; ++bit) {
          if (bit >= offset && bit < offset + bits) continue;
          EXPECT_EQ((before[bit / 8] >> (bit % 8)) & 1, (after[bit / 8] >> (bit % 8)) & 1);
        }
      }
    }
  }
}

TEST(NumberInAReport, IsLimitedToWhatItsBitsHold)
{
  std::array<std::uint8_t, 2> report{};
  putNumber(report, slotAt(0, 8, true), 1000);
  EXPECT_EQ(numberAt(report, slotAt(0, 8, true)), 127);
  putNumber(report, slotAt(0, 8, true), -1000);
  EXPECT_EQ(numberAt(report, slotAt(0, 8, true)), -128);
  putNumber(report, slotAt(0, 8, false), -5);
  EXPECT_EQ(numberAt(report, slotAt(0, 8, false)), 0);
}

TEST(NumberInAReport, IsNeverPutBeyondTheEnd)
{
  std::array<std::uint8_t, 4> memory{0, 0, 0x5a, 0x5a};
  putNumber(std::span(memory).first(2), slotAt(12, 16, false), 0xffff);
  EXPECT_EQ(memory[1], 0xf0);
  EXPECT_EQ(memory[2], 0x5a);
}

}  // namespace
}  // namespace perilymph::device

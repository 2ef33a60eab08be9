// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ReportDescriptor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace perilymph::device {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::HasSubstr;

constexpr Usage mouse{0x01, 0x02};
constexpr Usage axisX{0x01, 0x30};
constexpr Usage axisY{0x01, 0x31};

// HID 1.11, appendix E.10: the report descriptor of the example mouse.
const Bytes exampleMouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x01, 0xa1, 0x00,
                         0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01,
                         0x95, 0x03, 0x75, 0x01, 0x81, 0x02, 0x95, 0x01, 0x75, 0x05,
                         0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81,
                         0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xc0, 0xc0};

// HID 1.11, appendix E.6: the example keyboard, whose keys are an array and whose lamps are
// outputs.
const Bytes exampleKeyboard{
    0x05, 0x01, 0x09, 0x06, 0xa1, 0x01, 0x05, 0x07, 0x19, 0xe0, 0x29, 0xe7, 0x15, 0x00, 0x25, 0x01,
    0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x95, 0x01, 0x75, 0x08, 0x81, 0x01, 0x95, 0x05, 0x75, 0x01,
    0x05, 0x08, 0x19, 0x01, 0x29, 0x05, 0x91, 0x02, 0x95, 0x01, 0x75, 0x03, 0x91, 0x01, 0x95, 0x06,
    0x75, 0x08, 0x15, 0x00, 0x25, 0x65, 0x05, 0x07, 0x19, 0x00, 0x29, 0x65, 0x81, 0x00, 0xc0};

ReportDescriptor read(const Bytes& bytes)
{
  const auto descriptor = ReportDescriptor::parse(bytes);
  EXPECT_TRUE(descriptor) << (descriptor ? "" : descriptor.error().message);
  return descriptor ? *descriptor : ReportDescriptor();
}

std::string error(const Bytes& bytes)
{
  const auto descriptor = ReportDescriptor::parse(bytes);
  return descriptor ? "it was accepted" : descriptor.error().message;
}

Bytes joined(std::initializer_list<Bytes> parts)
{
  Bytes bytes;
  for (const Bytes& part : parts)
    for (const std::uint8_t byte : part) bytes.push_back(byte);
  return bytes;
}

/// Puts global items in front of one input item with a usage.
Bytes inputWith(const Bytes& items)
{
  return joined({{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01}, items, {0x09, 0x30, 0x81, 0x02, 0xc0}});
}

TEST(ReportDescriptor, ReadsTheSpecificationsMouse)
{
  const ReportDescriptor descriptor = read(exampleMouse);
  EXPECT_EQ(descriptor.application(), mouse);
  EXPECT_FALSE(descriptor.isNumbered());
  // "report is three bytes long": three buttons, five bits of padding, X, Y
  EXPECT_EQ(descriptor.reportBytes(ReportKind::input, 0), 3u);
  EXPECT_EQ(descriptor.reportBytes(ReportKind::output, 0), 0u);

  const auto second = descriptor.find(ReportKind::input, {0x09, 2});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->bitOffset, 1u);
  EXPECT_EQ(second->bits, 1u);
  const auto y = descriptor.find(ReportKind::input, axisY);
  ASSERT_TRUE(y);
  EXPECT_EQ(y->bitOffset, 16u);
  EXPECT_TRUE(y->isSigned);
  EXPECT_EQ(y->low, -127);
  EXPECT_EQ(y->high, 127);
}

TEST(ReportDescriptor, ReadsTheSpecificationsKeyboard)
{
  const ReportDescriptor descriptor = read(exampleKeyboard);
  EXPECT_EQ(descriptor.reportBytes(ReportKind::input, 0), 8u);
  EXPECT_EQ(descriptor.reportBytes(ReportKind::output, 0), 1u);
  // The letter A is usage 4 of the keyboard page and has index 4 in the array.
  const auto key = descriptor.choice(ReportKind::input, {0x07, 0x04}, {0x01, 0x06});
  ASSERT_TRUE(key);
  EXPECT_EQ(key->slot.bitOffset, 16u);
  EXPECT_EQ(key->value, 4);
}

TEST(ReportDescriptor, SaysWhetherAFieldIsInsideACollection)
{
  const ReportDescriptor descriptor = read(exampleMouse);
  EXPECT_TRUE(descriptor.find(ReportKind::input, axisX, Usage{0x01, 0x01}));
  EXPECT_TRUE(descriptor.find(ReportKind::input, axisX, mouse));
  EXPECT_FALSE(descriptor.find(ReportKind::input, axisX, Usage{0x01, 0x04}));
}

TEST(ReportDescriptor, TakesTheOrderOfAnArraysUsagesNotTheirNumbers)
{
  // Disable actuators (0x98) is declared before enable (0x97), from 1 on.
  const ReportDescriptor descriptor =
      read({0x05, 0x0f, 0x09, 0x96, 0xa1, 0x02, 0x85, 0x05, 0x09, 0x98, 0x09, 0x97,
            0x15, 0x01, 0x25, 0x02, 0x75, 0x08, 0x95, 0x01, 0x91, 0x00, 0xc0});
  const auto disable = descriptor.choice(ReportKind::output, {0x0f, 0x98}, {0x0f, 0x96});
  const auto enable = descriptor.choice(ReportKind::output, {0x0f, 0x97}, {0x0f, 0x96});
  ASSERT_TRUE(disable && enable);
  EXPECT_EQ(disable->value, 1);
  EXPECT_EQ(enable->value, 2);
  EXPECT_EQ(enable->slot.report, 5);
}

TEST(ReportDescriptor, TakesAVariableWhereAnArrayWasMeant)
{
  const ReportDescriptor descriptor =
      read({0x05, 0x0f, 0x09, 0x96, 0xa1, 0x02, 0x09, 0x97, 0x09, 0x98, 0x15,
            0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x91, 0x02, 0xc0});
  const auto disable = descriptor.choice(ReportKind::output, {0x0f, 0x98}, {0x0f, 0x96});
  ASSERT_TRUE(disable);
  EXPECT_EQ(disable->value, 1);
  EXPECT_EQ(disable->slot.bitOffset, 1u);
}

TEST(ReportDescriptor, TakesOneVariableOfSeveralUsagesForTheArrayItWasMeantToBe)
{
  // Wheels by Moza: one byte, declared as a variable, for enable, disable, stop all.
  const ReportDescriptor descriptor =
      read({0x05, 0x0f, 0x09, 0x96, 0xa1, 0x02, 0x09, 0x97, 0x09, 0x98, 0x09, 0x99,
            0x15, 0x01, 0x25, 0x03, 0x75, 0x08, 0x95, 0x01, 0x91, 0x02, 0xc0});
  const auto stopAll = descriptor.choice(ReportKind::output, {0x0f, 0x99}, {0x0f, 0x96});
  ASSERT_TRUE(stopAll);
  EXPECT_EQ(stopAll->value, 3);
  EXPECT_EQ(stopAll->slot.bits, 8u);
}

TEST(ReportDescriptor, CountsTheBitsOfEachNumberedReportAlone)
{
  const ReportDescriptor descriptor =
      read({0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0x75, 0x10, 0x95, 0x01, 0x15, 0x00,
            0x26, 0xff, 0x7f, 0x85, 0x01, 0x09, 0x30, 0x81, 0x02, 0x85, 0x02, 0x09,
            0x31, 0x81, 0x02, 0x85, 0x01, 0x09, 0x32, 0x81, 0x02, 0xc0});
  EXPECT_TRUE(descriptor.isNumbered());
  EXPECT_EQ(descriptor.find(ReportKind::input, axisY)->bitOffset, 0u);
  EXPECT_EQ(descriptor.find(ReportKind::input, axisY)->report, 2);
  EXPECT_EQ(descriptor.find(ReportKind::input, {0x01, 0x32})->bitOffset, 16u);
  EXPECT_EQ(descriptor.reportBytes(ReportKind::input, 1), 4u);
  EXPECT_EQ(descriptor.reportBytes(ReportKind::input, 2), 2u);
}

TEST(ReportDescriptor, TakesThePageOfAnExtendedUsageFromTheUsage)
{
  const ReportDescriptor descriptor = read({0x05, 0x0c, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95,
                                            0x01, 0x0b, 0x30, 0x00, 0x01, 0x00, 0x81, 0x02});
  EXPECT_TRUE(descriptor.find(ReportKind::input, axisX));
}

TEST(ReportDescriptor, TakesThePageInForceAtTheMainItemForAShortUsage)
{
  // HID 1.11, 6.2.2.8: the usage is put together with the page when the main item is met.
  const ReportDescriptor descriptor = read({0x05, 0x0c, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95,
                                            0x01, 0x09, 0x30, 0x05, 0x01, 0x81, 0x02});
  EXPECT_TRUE(descriptor.find(ReportKind::input, axisX));
}

TEST(ReportDescriptor, RestoresPushedValues)
{
  const ReportDescriptor descriptor =
      read({0x05, 0x01, 0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0xa4,
            0x75, 0x10, 0x09, 0x30, 0x81, 0x02, 0xb4, 0x09, 0x31, 0x81, 0x02});
  EXPECT_EQ(descriptor.find(ReportKind::input, axisX)->bits, 16u);
  EXPECT_EQ(descriptor.find(ReportKind::input, axisY)->bits, 8u);
}

TEST(ReportDescriptor, ReadsAMaximumOfOneByteAsUnsignedWithAMinimumOfZero)
{
  const ReportDescriptor descriptor =
      read(inputWith({0x15, 0x00, 0x25, 0xff, 0x75, 0x08, 0x95, 0x01}));
  EXPECT_EQ(descriptor.find(ReportKind::input, axisX)->high, 255);
}

TEST(ReportDescriptor, ReadsUnitsAndTheirExponent)
{
  // Exponent -2 as a nibble; English rotation: degrees.
  const ReportDescriptor descriptor =
      read(inputWith({0x15, 0x00, 0x26, 0x9f, 0x8c, 0x35, 0x00, 0x46, 0x9f, 0x8c, 0x55, 0x0e, 0x65,
                      0x14, 0x75, 0x10, 0x95, 0x01}));
  ASSERT_EQ(descriptor.fields().size(), 1u);
  EXPECT_EQ(descriptor.fields()[0].unitExponent, -2);
  EXPECT_EQ(descriptor.fields()[0].unit, 0x14u);
  EXPECT_EQ(descriptor.fields()[0].physicalHigh, 35999);
}

TEST(ReportDescriptor, PrefersTheFirstOfDelimitedUsages)
{
  const ReportDescriptor descriptor =
      read({0x05, 0x01, 0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x02, 0xa9,
            0x01, 0x09, 0x30, 0x09, 0x33, 0xa9, 0x00, 0x09, 0x31, 0x81, 0x02});
  EXPECT_EQ(descriptor.find(ReportKind::input, axisX)->bitOffset, 0u);
  EXPECT_EQ(descriptor.find(ReportKind::input, axisY)->bitOffset, 8u);
  EXPECT_FALSE(descriptor.find(ReportKind::input, {0x01, 0x33}));
}

TEST(ReportDescriptor, IgnoresLongItems)
{
  const Bytes longItem{0xfe, 0x02, 0x10, 0xaa, 0xbb};
  EXPECT_EQ(read(joined({longItem, exampleMouse})).application(), mouse);
}

TEST(ReportDescriptor, OfNoBytesHasNoReports)
{
  const ReportDescriptor descriptor = read({});
  EXPECT_TRUE(descriptor.fields().empty());
  EXPECT_FALSE(descriptor.application());
}

TEST(MalformedReportDescriptor, IsAnsweredWithThePlace)
{
  EXPECT_THAT(error({0x05, 0x01, 0x26, 0xff}), HasSubstr("byte 2"));
  EXPECT_THAT(error({0x05, 0x01, 0x26, 0xff}), HasSubstr("needs 2 bytes"));
  EXPECT_THAT(error({0x05, 0x01, 0xc0}), HasSubstr("byte 2: a collection ends"));
  EXPECT_THAT(error({0xa1, 0x01}), HasSubstr("inside 1 open collections"));
  EXPECT_THAT(error({0xb4}), HasSubstr("pop without a push"));
  EXPECT_THAT(error(Bytes(100, 0xa4)), HasSubstr("more than 32 pushes"));
  Bytes deep;
  for (int i = 0; i < 40; ++i) deep = joined({deep, {0xa1, 0x00}});
  EXPECT_THAT(error(deep), HasSubstr("32 deep"));
  EXPECT_THAT(error({0x85, 0x00}), HasSubstr("report number 0"));
  EXPECT_THAT(error({0xfe, 0xff, 0x00, 0x00}), HasSubstr("long item is cut off"));
  EXPECT_THAT(error({0xa9, 0x00}), HasSubstr("delimiter"));
  EXPECT_THAT(error({0x07, 0x00, 0x00, 0x01, 0x00}), HasSubstr("usage page 0x10000"));
  EXPECT_THAT(error(inputWith({0x15, 0x05, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01})),
              HasSubstr("greatest value 1 is below its least, 5"));
  EXPECT_THAT(error(inputWith({0x15, 0x00, 0x25, 0x01, 0x75, 0x40, 0x95, 0x01})),
              HasSubstr("64 bits"));
  EXPECT_THAT(
      error({0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x19, 0x05, 0x29, 0x02, 0x81, 0x02}),
      HasSubstr("usages run from 0x5 down to 0x2"));
}

TEST(MalformedReportDescriptor, CannotAskForReportsWithoutEnd)
{
  // count 2^32 - 1 of 32 bits
  EXPECT_THAT(error(inputWith({0x15, 0x00, 0x25, 0x01, 0x75, 0x20, 0x97, 0xff, 0xff, 0xff, 0xff})),
              HasSubstr("bits; at most 8184"));
}

TEST(MalformedReportDescriptor, MayNotMixReportsWithAndWithoutNumber)
{
  EXPECT_THAT(
      error({0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x85, 0x01, 0x81, 0x02}),
      HasSubstr("some reports have numbers"));
}

TEST(MalformedReportDescriptor, MayNotBeLongerThanTheSystemReads)
{
  EXPECT_THAT(error(Bytes(5000, 0)), HasSubstr("5000 bytes long; at most 4096"));
}

TEST(MalformedReportDescriptor, CutOffAnywhereIsRefusedOrShorterButNeverWrong)
{
  for (std::size_t length = 0; length < exampleKeyboard.size(); ++length) {
    const auto descriptor = ReportDescriptor::parse(std::span(exampleKeyboard).first(length));
    if (!descriptor) continue;
    EXPECT_LE(descriptor->fields().size(), 5u) << length;
  }
}

}  // namespace
}  // namespace perilymph::device

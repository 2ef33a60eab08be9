// SPDX-License-Identifier: BSD-3-Clause
#include "RequestReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <igtlCapabilityMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlTransformMessage.h>

#include <random>
#include <vector>

namespace perilymph::broadcast {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

/// A message as the library packs it.
Bytes packed(igtl::MessageBase& message, const char* name)
{
  message.SetDeviceName(name);
  message.Pack();
  const auto* const begin = static_cast<const std::uint8_t*>(message.GetPackPointer());
  return {begin, begin + message.GetPackSize()};
}
Bytes request(const char* name = "PerilymphScala")
{
  return packed(*igtl::GetPolyDataMessage::New(), name);
}
Bytes transform() { return packed(*igtl::TransformMessage::New(), "Other"); }

/// What a reader makes of a stream that arrives in pieces.
struct Heard {
  std::vector<std::string> types;
  std::string fault;
};
Heard hear(const Bytes& stream, const std::function<std::size_t()>& pieceSize)
{
  Heard heard;
  RequestReader reader;
  std::size_t at = 0;
  while (at < stream.size() && reader.fault().empty()) {
    std::span<const std::uint8_t> piece(stream.data() + at,
                                        std::min(pieceSize(), stream.size() - at));
    at += piece.size();
    while (!piece.empty() && reader.fault().empty()) {
      piece = piece.subspan(reader.take(piece));
      if (reader.request()) heard.types.push_back(reader.request()->type);
    }
  }
  heard.fault = reader.fault();
  return heard;
}

Bytes joined(const std::vector<Bytes>& parts)
{
  Bytes whole;
  for (const Bytes& part : parts) whole.insert(whole.end(), part.begin(), part.end());
  return whole;
}

TEST(RequestReader, ReadsWhatTheLibraryPacks)
{
  RequestReader reader;
  const Bytes bytes = request();
  EXPECT_EQ(reader.take(bytes), bytes.size());
  ASSERT_TRUE(reader.request());
  EXPECT_EQ(reader.request()->type, "GET_POLYDATA");
  EXPECT_EQ(reader.request()->device, "PerilymphScala");
  EXPECT_FALSE(reader.isWithinMessage());
}

TEST(RequestReader, ReadsTheSameFromPiecesOfAnySize)
{
  const Bytes stream = joined({request(), transform(), request(""), transform(), transform()});
  for (std::size_t size = 1; size < 200; ++size) {
    const Heard heard = hear(stream, [size] { return size; });
    EXPECT_THAT(heard.types, testing::ElementsAre("GET_POLYDATA", "TRANSFORM", "GET_POLYDATA",
                                                  "TRANSFORM", "TRANSFORM"))
        << size;
    EXPECT_EQ(heard.fault, "") << size;
  }
}

TEST(RequestReader, KnowsThatAMessageIsNotComplete)
{
  const Bytes bytes = transform();
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    RequestReader reader;
    reader.take(std::span(bytes).first(size));
    EXPECT_TRUE(reader.isWithinMessage()) << size;
    EXPECT_FALSE(reader.request()) << size;
  }
}

TEST(RequestReader, RefusesWhatIsNoMessage)
{
  const auto faultOf = [](Bytes bytes) { return hear(bytes, [] { return 7; }).fault; };
  Bytes bytes = request();
  bytes[1] = 9;
  EXPECT_THAT(faultOf(bytes), HasSubstr("version 9"));
  bytes = request();
  bytes[2] = 7;
  EXPECT_THAT(faultOf(bytes), HasSubstr("no valid type"));
  bytes = request();
  bytes[2] = 0;
  EXPECT_THAT(faultOf(bytes), HasSubstr("no valid type"));
  bytes = transform();
  bytes.back() ^= 1;
  EXPECT_THAT(faultOf(bytes), HasSubstr("check sum of its TRANSFORM"));
}

// Version 2 of the protocol: a sender that computes no check sum writes 0.
TEST(RequestReader, TakesACheckSumOfZeroAsNone)
{
  Bytes bytes = transform();
  std::fill(bytes.begin() + 50, bytes.begin() + 58, std::uint8_t{0});
  bytes.back() ^= 1;
  EXPECT_THAT(hear(joined({bytes, request()}), [] { return 7; }).types,
              testing::ElementsAre("TRANSFORM", "GET_POLYDATA"));
}

TEST(RequestReader, SkipsALongBodyAndReadsOn)
{
  for (const std::size_t size : {std::size_t{(1 << 20) + 1}, std::size_t{5'000'000}}) {
    Bytes large = request();
    for (int i = 0; i < 8; ++i)
      large[42 + static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(size >> (56 - 8 * i));
    large.resize(RequestReader::headerSize + size, 0x55);
    const Heard heard = hear(joined({large, request("after")}), [] { return 40'000; });
    EXPECT_EQ(heard.fault, "");
    EXPECT_THAT(heard.types, testing::ElementsAre("GET_POLYDATA"));  // the second only
  }
}

TEST(RequestReader, TakesRandomBytesWithoutHarmAndIndependentlyOfTheirPieces)
{
  std::mt19937_64 random(20261123);
  const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
  for (int round = 0; round < 2000; ++round) {
    // Half of the streams begin as messages do, and are damaged somewhere.
    Bytes stream = round % 2 == 0 ? Bytes() : joined({request(), transform(), request()});
    const std::size_t size = random() % 400;
    while (stream.size() < size) stream.push_back(byte());
    for (int i = 0; i < round % 5 && !stream.empty(); ++i)
      stream[random() % stream.size()] = byte();
    const Heard whole = hear(stream, [] { return 1000; });
    const Heard pieces = hear(stream, [&] { return 1 + random() % 50; });
    EXPECT_EQ(whole.types, pieces.types) << round;
    EXPECT_EQ(whole.fault, pieces.fault) << round;
  }
}

}  // namespace
}  // namespace perilymph::broadcast

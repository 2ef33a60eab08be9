// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/broadcast/Broadcast.h"

namespace perilymph::broadcast {
namespace {

using testing::HasSubstr;

TEST(Endpoint, IsThisMachineIfOnlyAPortIsGiven)
{
  const auto endpoint = parseEndpoint("18944");
  ASSERT_TRUE(endpoint);
  EXPECT_EQ(endpoint->address, "127.0.0.1");
  EXPECT_EQ(endpoint->port, 18944);
}

TEST(Endpoint, HasAnAddressInFrontOfTheLastColon)
{
  EXPECT_EQ(parseEndpoint("192.168.0.7:2000")->address, "192.168.0.7");
  EXPECT_EQ(parseEndpoint("192.168.0.7:2000")->port, 2000);
  EXPECT_EQ(parseEndpoint("[::1]:18944")->address, "::1");
}

TEST(Endpoint, IsRefusedWithASentence)
{
  for (const char* text : {"", "0", "1023", "65536", "-1", "18944x", "127.0.0.1:", "port", "1e4"}) {
    const auto endpoint = parseEndpoint(text);
    ASSERT_FALSE(endpoint) << text;
    EXPECT_THAT(endpoint.error().message, HasSubstr("from 1024 to 65535")) << text;
  }
  for (const char* text : {"localhost:18944", ":18944", "300.1.1.1:18944", "1.2.3:18944"}) {
    const auto endpoint = parseEndpoint(text);
    ASSERT_FALSE(endpoint) << text;
    EXPECT_THAT(endpoint.error().message, HasSubstr("is not numeric")) << text;
  }
}

}  // namespace
}  // namespace perilymph::broadcast

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace perilymph {
namespace {

std::uint64_t hashOf(std::string_view text)
{
  Hash hash;
  hash.addBytes(text.data(), text.size());
  return hash.value();
}

// The published test vectors of FNV-1a, 64 bits.
TEST(Hash, AgreesWithThePublishedVectors)
{
  EXPECT_EQ(hashOf(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(Hash, TellsMinusZeroFromZero)
{
  Hash zero;
  zero.add(0.0);
  Hash minusZero;
  minusZero.add(-0.0);
  EXPECT_NE(zero.value(), minusZero.value());
}

}  // namespace
}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Sha256.h"

#include <gtest/gtest.h>

namespace perilymph {
namespace {

// The examples of FIPS 180-2, appendix B.
TEST(Sha256, GivesThePublishedHashes)
{
  EXPECT_EQ(Sha256().hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Sha256 abc;
  abc.add("abc");
  EXPECT_EQ(abc.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  Sha256 million;
  for (int i = 0; i < 1000; ++i) million.add(std::string(1000, 'a'));
  EXPECT_EQ(million.hex(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, ContinuesAfterAHashWasRead)
{
  Sha256 pieces;
  pieces.add("a");
  static_cast<void>(pieces.hex());
  const Sha256 copy = pieces;
  pieces.add("bc");
  Sha256 whole;
  whole.add("abc");
  EXPECT_EQ(pieces.hex(), whole.hex());
  EXPECT_NE(copy.hex(), whole.hex());
}

TEST(Sha256, TakesNumbersAsEightBytesTheLowestFirst)
{
  Sha256 number;
  number.add(std::uint64_t{0x0102});
  Sha256 bytes;
  bytes.add(std::string_view("\x02\x01\0\0\0\0\0\0", 8));
  EXPECT_EQ(number.hex(), bytes.hex());
}

}  // namespace
}  // namespace perilymph

// SPDX-License-Identifier: BSD-3-Clause

// Exceptions are caught at the boundary of a thread and become an error message.

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <thread>

#include "perilymph/foundation/CallNoThrow.h"

namespace perilymph {
namespace {

TEST(CallNoThrow, ReturnsTheResultOfWorkThatSucceeds)
{
  const auto result = callNoThrow("The sum", [] { return Result<int>(2 + 3); });
  ASSERT_TRUE(result);
  EXPECT_EQ(*result, 5);
}

TEST(CallNoThrow, ReportsOutOfMemoryWithTheSubject)
{
  const auto result =
      callNoThrow("The recording a.insertion", []() -> Result<int> { throw std::bad_alloc(); });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message,
            "The recording a.insertion needs more memory than is available. Close other programs "
            "and try again.");
}

TEST(CallNoThrow, KeepsTheReasonOfAnException)
{
  const auto result = callNoThrow(
      "The report", []() -> Result<void> { throw std::runtime_error("the disk is full"); });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "The report failed: the disk is full.");
}

TEST(CallNoThrow, NamesTheSubjectOfAnythingElseThatIsThrown)
{
  const auto result = callNoThrow("The report", []() -> Result<void> { throw 7; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "The report failed for an unknown reason.");
}

TEST(CallNoThrow, KeepsAThreadFromEndingTheProgram)
{
  Result<void> result;
  std::thread([&result] {
    result = callNoThrow("The work", []() -> Result<void> { throw std::bad_alloc(); });
  }).join();
  EXPECT_FALSE(result);
}

}  // namespace
}  // namespace perilymph

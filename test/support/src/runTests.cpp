// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/runTests.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace perilymph::test {

int runTests()
{
  const int status = RUN_ALL_TESTS();
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  if (tests.test_to_run_count() == 0) {
    std::fputs("No case has the name that was asked for; --gtest_list_tests lists them.\n", stderr);
    return 1;
  }
  const bool areAllSkipped = tests.skipped_test_count() == tests.test_to_run_count();
  return status == 0 && areAllSkipped ? 77 : status;
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause

// main() of the test programs that need no event loop.

#include <gmock/gmock.h>

#include "perilymph/test/runTests.h"

int main(int argc, char** argv)
{
  testing::InitGoogleMock(&argc, argv);
  return perilymph::test::runTests();
}
